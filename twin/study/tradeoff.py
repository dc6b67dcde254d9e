"""Where a goal is not met: the curve along which it would have to be bought, and with what.

Each curve moves one parameter of the design through its range and judges every goal at each point, on
the same plants. `CURVES` names what is traded for what.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from twin.study.goals import GOALS
from twin.study.robustness import run
from twin.study.scenarios import Overrides
from twin.study.tables import Progress


@dataclass(frozen=True)
class Curve:
    """One parameter and the values it takes."""

    name: str
    about: str
    points: tuple[tuple[float, Overrides], ...]


def _fins(price: float) -> list[float]:
    return [price] * 4 + [0.02, 0.05, 0.05]


CURVES: tuple[Curve, ...] = (
    Curve(
        "price of increments in the ramp",
        "smooth commands at a switch against wrench error: S4 <= S2 in e_tau is paid for with d_u",
        tuple((v, {"bumpless": {"ramp_increment_price": v}}) for v in (0.0, 1.0, 10.0, 100.0)),
    ),
    Curve(
        "length of the ramp into R, cycles",
        "the longer the ramp, the smaller d_u,FR and the later the vehicle brakes",
        tuple((float(v), {"reverse": {"ramp_cycles": v}}) for v in (20, 40, 80, 160)),
    ),
    Curve(
        "price of fins in hover",
        "idle fins in S5 leave more to gain in S6, and cost S4 its heading",
        tuple((v, {"hover": {"r_diagonal": _fins(v)}}) for v in (0.2, 1.0, 3.0, 10.0)),
    ),
)


def trade_off(
    curve: Curve, n_plants: int = 40, progress: Progress = None, workers: int | None = None
) -> list[dict[str, Any]]:
    """One row per point: the share and the median ratio of every goal."""
    rows = []
    for value, overrides in curve.points:
        answer = run(n_plants, progress, workers, overrides)
        judged = answer["goals"]
        rows.append(
            {
                "value": value,
                "goals": {
                    g.name: {
                        "share": judged[g.name]["share"],
                        "median": judged[g.name]["ratio_quantiles"]["q50"],
                    }
                    for g in GOALS
                },
            }
        )
    return rows


def curve_named(name: str, curves: Sequence[Curve] = CURVES) -> Curve:
    """The curve of a name."""
    return next(c for c in curves if c.name == name)
