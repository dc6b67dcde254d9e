"""Ten minutes in hover: `python -m bumpless_paper.study.docks.hover --first 0 --count 10 --current 0.05 0.1`.

Drawn vehicles that are free to turn, in a current against their approach with the drawn gusts.
"""

import argparse
import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from bumpless.config.mission.model import End
from bumpless.contract.enums import APPROACH, HOVER
from bumpless_paper.study.docks.cases import Case, draw_case, vehicle
from bumpless_paper.study.docks.many import fly_case

LASTS_S, SETTLES_S = 600.0, 10.0


@dataclass(frozen=True)
class Hover:
    """One flight, from 10 s after it first hovers on."""

    held: bool  # in place for ten minutes, without a wave-off
    share: float  # of that time in hover on the approach
    wander_deg: float  # deviation of the heading error in it; NaN where it never hovers


def against(number: int, current_mps: float) -> Case:
    """A drawn case in a current against its approach, with the drawn gusts, for 900 s."""
    case = draw_case(number, "normal", "into")
    psi = math.radians(case.mission.target.heading_deg)
    flow = (-current_mps * math.cos(psi), -current_mps * math.sin(psi), 0.0)
    sea = replace(case.mission.environment, current_ned_mps=flow)
    return replace(case, mission=replace(case.mission, environment=sea, duration_s=900.0, end=End()))


def hover(case: Case) -> Hover:
    """Fly a case and look at its hover."""
    log, period = fly_case(case).log, vehicle().control_period_s
    hovers = (log["mode"] == HOVER) & (log["stage"] == APPROACH)
    if not hovers.any():
        return Hover(False, 0.0, math.nan)
    first, lasts = int(np.argmax(hovers)) + round(SETTLES_S / period), round(LASTS_S / period)
    there, rows = hovers[first : first + lasts], log[first : first + lasts]
    off = np.degrees(np.angle(np.exp(1j * (rows["eta"][:, 5] - rows["approach"])))[there])
    wander = float(np.std(off)) if len(off) else math.nan
    return Hover(
        bool(there.all()) and len(there) == lasts, float(there.mean()) if len(there) else 0.0, wander
    )


def line(current_mps: float, numbers: Iterable[int]) -> str:
    """The figures of one current."""
    seen = [hover(against(number, current_mps)) for number in numbers]
    share, wander = np.mean([one.share for one in seen]), np.array([one.wander_deg for one in seen])
    return (
        f"{current_mps:g} m/s: {sum(one.held for one in seen)} of {len(seen)} held, {share:.1%} of the time; "
        f"heading {np.nanmedian(wander):.2f} deg RMS (median), {np.nanmax(wander):.2f} (worst)"
    )


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--current", type=float, nargs="+", default=[0.05, 0.08, 0.12])
    a = parser.parse_args()
    for current in a.current:
        print(line(current, range(a.first, a.first + a.count)))


if __name__ == "__main__":
    main()
