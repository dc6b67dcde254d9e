"""The hydrodynamic pipeline fed with REMUS against Prestero's thesis."""

from bumpless.config.vehicle import load_vehicle
from bumpless_paper.remus.check import TOLERANCE, Row, remus_check
from bumpless_paper.remus.notes import REASONS
from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.ticks import number, share


def part(progress: Progress) -> Part:
    """One row per published coefficient."""
    rows = remus_check()
    progress(1.0)
    good = sum(row.agrees for row in rows)
    off = [row for row in rows if not row.agrees]
    explained = sum(row.explained for row in off)
    return Part(
        "remus",
        "REMUS coefficients",
        f"The pipeline that makes TS-100's hydrodynamics, fed with the REMUS geometry: {good} of {len(rows)} "
        f"published coefficients come out within {share(TOLERANCE)}, among them the main terms of added mass "
        f"and of drag along the axes. Of the other {len(off)}, {explained} come out within "
        f"{share(TOLERANCE)} under another reading of the thesis, computed with the same pipeline; "
        f"{len(off) - explained} do not follow from the printed geometry under any reading we found.",
        [_table(rows), _reasons(rows)],
        numbers={
            "within_5_percent": good,
            "coefficients": len(rows),
            "explained": explained,
            "unexplained": len(off) - explained,
            "unexplained_names": [row.name for row in off if not row.explained],
        },
        hashes={"vehicle remus100": load_vehicle("remus100").sha256},
    )


def _table(rows: tuple[Row, ...]) -> Grid:
    return Grid(
        "remus_coefficients",
        "Coefficients of Prestero's thesis",
        "Force or moment over what its name says, radians left out of the units. Reason: see the next table. "
        "Reread: ours under the other reading named there.",
        ["coefficient", "unit", "ours", "thesis", "ratio", "reason", "reread", "ratio then"],
        [
            [
                row.name,
                row.unit,
                row.ours,
                row.theirs,
                row.ratio,
                "" if row.reason is None else row.reason.letter,
                row.reread,
                None if row.reread is None else row.reread / row.theirs,
            ]
            for row in rows
        ],
    )


def _reasons(rows: tuple[Row, ...]) -> Grid:
    lines = []
    for reason in REASONS:
        mine = [row for row in rows if row.reason is reason]
        lines.append(
            [
                reason.letter,
                " ".join(row.name for row in mine),
                reason.why,
                reason.reading or "none found",
                _between([row.ratio for row in mine]),
                _between([row.reread / row.theirs for row in mine if row.reread is not None]),
            ]
        )
    return Grid(
        "remus_reasons",
        f"Why some differ by more than {share(TOLERANCE)}",
        "The thesis states none of these readings; they are what its printed numbers ask for. Where the "
        "thesis leaves a choice ours is the printed geometry with the printed coefficients.",
        ["", "coefficients", "why", "another reading", "ratio", "ratio then"],
        lines,
    )


def _between(ratios: list[float]) -> str:
    if not ratios:
        return "–"
    low, high = min(ratios), max(ratios)
    return number(low, 3) if high - low < 5e-4 else f"{number(low, 3)} … {number(high, 3)}"
