"""The hydrodynamic pipeline fed with REMUS against Prestero's thesis."""

from twin.hydrodynamics.remus_check import remus_check
from twin.report.content import Grid, Part
from twin.report.parts import Progress
from twin.vehicle import load_vehicle


def part(progress: Progress) -> Part:
    """One row per published coefficient."""
    rows = remus_check()
    progress(1.0)
    good = int(sum(row.agrees for row in rows))
    return Part(
        "remus",
        "REMUS coefficients",
        f"The pipeline that makes TS-100's hydrodynamics, fed with the REMUS geometry: {good} of {len(rows)} "
        "published coefficients come out within 5 %; each other one has its reason beside it.",
        [
            Grid(
                "remus_coefficients",
                "Coefficients of Prestero's thesis",
                "SI units, as the thesis prints them.",
                ["coefficient", "ours", "thesis", "ratio", "reason where it deviates"],
                [[row.name, row.ours, row.theirs, row.ratio, row.note] for row in rows],
            )
        ],
        numbers={"within_5_percent": good, "coefficients": len(rows)},
        hashes={"vehicle remus100": load_vehicle("remus100").sha256},
    )
