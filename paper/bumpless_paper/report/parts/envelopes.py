"""Table 3 both ways: sampled as in the paper, and exact; and what sampling misses.

Source: Gao et al. 2026, section 2.6, figures 4 to 6, table 3.
"""

from typing import Any

import numpy as np

from bumpless.config.vehicle import load_vehicle
from bumpless.physics.actuators import FIN, THRUSTER
from bumpless.physics.envelope import Envelope, attainable_sets, sampled_sets, select
from bumpless.physics.envelope_hull import Hull
from bumpless.physics.model import build_model
from bumpless_paper.report.content import Comparison, Figure, Grid, Panel, Part, Series, Solid
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.published import published
from bumpless_paper.report.ticks import share

SPEED = 0.2  # m/s
DRAWS = 8
EXACT_DIRECTIONS, SHOWN_DIRECTIONS = 4000, 220
KEYS = ("force_volume", "force_area", "moment_volume", "moment_area")
COLUMNS = ("force volume (N³)", "force area (N²)", "moment volume ((N·m)³)", "moment area ((N·m)²)")
GROUPS = {"rudder": FIN, "thrusters": THRUSTER, "total": None}
FORCE, MOMENT = ("X (N)", "Y (N)", "Z (N)"), ("K (N·m)", "M (N·m)", "N (N·m)")


def indicators(sets: Envelope) -> list[float]:
    """Volume and area of the force set, then of the moment set."""
    return [sets.force.volume, sets.force.area, sets.moment.volume, sets.moment.area]


def paper_rows() -> dict[str, list[float | None]]:
    """Table 3 as printed."""
    table = published()["table3_envelopes_at_0p2_mps"]
    return {row: [table[row][key] for key in KEYS] for row in GROUPS}


def part(progress: Progress) -> Part:
    """Table 3 and figures 4 to 6."""
    vehicle = load_vehicle("ts100")
    model = build_model(vehicle)
    draws: dict[str, list[list[float]]] = {row: [] for row in GROUPS}
    for seed in range(DRAWS):
        for row, sets in sampled_sets(model, SPEED, seed).items():
            draws[row].append(indicators(sets))
        progress(0.4 * (seed + 1) / DRAWS)
    exact = {
        row: indicators(attainable_sets(model, SPEED, EXACT_DIRECTIONS, select(model, kind=kind)))
        for row, kind in GROUPS.items()
    }
    progress(0.5)
    rows: dict[str, Any] = {}
    shares = []
    for row, values in paper_rows().items():
        mean, spread = np.mean(draws[row], axis=0), np.std(draws[row], axis=0)
        rows[row] = (
            values,
            [None if p is None else float(m) for p, m in zip(values, mean, strict=True)],
            [float(s) for s in spread] if row == "total" else None,
        )
        shares.append([row, *(_missed(m, e) for m, e in zip(mean, exact[row], strict=True))])
    compared = Comparison(
        "table3",
        "Table 3, sampled as in the paper",
        "Rudders 20 levels each, thrusters 100 levels each, all seven 20,000 random commands; ours for all "
        f"seven is the mean of {DRAWS} draws with their standard deviation. The flat thruster sets are read "
        "as planar areas.",
        COLUMNS,
        rows,
    )
    precise = Grid(
        "table3_exact",
        "Table 3, exact",
        f"Support function of the sum of the actuators' own curves in {EXACT_DIRECTIONS} directions: no "
        "random numbers.",
        ["set", *COLUMNS],
        [[row, *values] for row, values in exact.items()],
    )
    missing = Grid(
        "table3_missed",
        "What sampling misses of the exact set",
        "1 − sampled / exact; a dash where the set is flat.",
        ["set", *COLUMNS],
        [[row, *(None if m is None else share(m + 1e-9, 1) for m in of)] for row, *of in shares],
    )
    worst = max(abs(c) for row in compared.as_dict()["rows"].values() for c in row["change"] if c is not None)
    figures = [_bodies(model), _convergence(model, exact["total"], progress), _speeds(model)]
    progress(1.0)
    lost = 1.0 - float(np.mean(draws["total"], axis=0)[0]) / exact["total"][0]
    lost_moment = 1.0 - float(np.mean(draws["total"], axis=0)[2]) / exact["total"][2]
    return Part(
        "envelopes",
        "Attainable sets (Table 3)",
        f"Under the paper's own sampling the farthest indicator is {share(worst, 1)} from print. Seven "
        "dimensions are too many for 20,000 random commands: they hardly ever meet a corner, and miss "
        f"{share(lost)} of the force set's volume and {share(lost_moment)} of the moment set's.",
        [compared, precise, missing],
        figures,
        numbers={
            "largest_deviation": worst,
            "force_volume_missed": lost,
            "moment_volume_missed": lost_moment,
        },
        hashes={"vehicle ts100": vehicle.sha256},
    )


def _missed(sampled: float, exact: float) -> float | None:
    return None if exact < 1e-12 else 1.0 - float(sampled) / exact


def _bodies(model: np.record) -> Figure:
    panels = []
    sampled = sampled_sets(model, SPEED, 0)
    for row, kind in GROUPS.items():
        sets = attainable_sets(model, SPEED, SHOWN_DIRECTIONS, select(model, kind=kind))
        for name, hull, axes, inner in (
            ("force", sets.force, FORCE, sampled[row].force),
            ("moment", sets.moment, MOMENT, sampled[row].moment),
        ):
            panels.append(Solid(f"{row}, {name}", hull.vertices, _visible(hull), axes, inner.vertices))
    return Figure(
        "fig4_6_envelopes",
        "Figures 4 to 6: attainable force and moment sets at 0.2 m/s",
        "Exact sets as bodies, each axis scaled to its box; dots: corners of the paper's sampled hulls.",
        panels,
        2,
    )


def _visible(hull: Hull) -> Any:
    corners = hull.vertices[hull.faces]
    size = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return hull.faces[size > 1e-9 * max(size.max(), 1e-300)]


def _convergence(model: np.record, exact: list[float], progress: Progress) -> Figure:
    counts = [500, 2_000, 8_000, 20_000, 80_000, 320_000]
    found = []
    for k, count in enumerate(counts):
        found.append(indicators(sampled_sets(model, SPEED, 1, count)["total"]))
        progress(0.5 + 0.4 * (k + 1) / len(counts))
    shares = np.array(found) / exact
    x = np.array(counts, float)
    names = ["force volume", "force area", "moment volume", "moment area"]
    series = [Series(name, x, shares[:, i], i) for i, name in enumerate(names)]
    return Figure(
        "sampling_convergence",
        "How many random commands a hull needs",
        "Size of the sampled hull of all seven actuators over the exact one; the paper draws 20,000.",
        [Panel("random commands", "share of the exact set", series, marks=[(20_000.0, "paper")], log_x=True)],
    )


def _speeds(model: np.record) -> Figure:
    speeds = np.linspace(-0.4, 1.0, 29)
    sets = [indicators(attainable_sets(model, float(u), 800)) for u in speeds]
    volumes = np.array(sets)
    panels = [
        Panel("surge speed through water (m/s)", "force volume (N³)", [Series("", speeds, volumes[:, 0], 0)]),
        Panel(
            "surge speed through water (m/s)",
            "moment volume ((N·m)³)",
            [Series("", speeds, volumes[:, 2], 1)],
        ),
    ]
    return Figure(
        "envelopes_over_speed",
        "How the sets grow with speed",
        "Fins act by the square of the flow: at rest the moment set is all but flat. Below zero the fins "
        "meet the flow from behind.",
        panels,
        2,
    )
