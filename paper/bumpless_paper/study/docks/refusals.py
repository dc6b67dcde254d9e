"""Is what is refused right? `python -m bumpless_paper.study.docks.refusals --first 6000000 --count 200`.

Drawn missions are asked of `bumpless.feasibility`. Each refused one is searched: is there a heading within
its tolerance, and a set of parameters, with which this plant in this sea docks all the same? Each accepted
one is flown as it is. The truth judges both.
"""

import argparse
import json
import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any

from bumpless.campaign.engine import in_order
from bumpless.campaign.summary import share_of
from bumpless.config.parameters import default_parameters
from bumpless.feasibility import ACCEPT, REFUSE, WARN, station_keeping
from bumpless.sim.approach import turn_used_deg
from bumpless_paper.study.docks.cases import Case, Heading, draw_case, vehicle
from bumpless_paper.study.docks.judge import hits, judge
from bumpless_paper.study.docks.many import Overrides, fly_case

ZONES = {REFUSE: "refused", WARN: "warned of", ACCEPT: "accepted"}
_NEVER_MPS = 3.0  # a current limit that is never met: the vehicle tries whatever comes
_TRY: dict[str, Any] = {"side_still_mps": _NEVER_MPS, "following_mps": _NEVER_MPS}
SEARCHED: tuple[dict[str, Any], ...] = (
    {},
    {"crab_near": 0.15, "crab_borne": 0.15, "hover_heading_deg": 9.0},
    {"cone_base_m": 0.8, "hover_lateral_m": 0.3, "aim_most_m": 0.2},
    {
        "crab_near": 0.15,
        "crab_borne": 0.15,
        "hover_heading_deg": 9.0,
        "aim_most_m": 0.2,
        "cone_base_m": 0.8,
        "patience_s": 120.0,
    },
)  # what of the parameters decides whether a current across is borne


@dataclass(frozen=True)
class Asked:
    """One mission: what was said of it, whether it docks. Currents are about the heading it would take."""

    number: int
    zone: int
    along_mps: float
    across_mps: float
    gusts_mps: float
    docks: bool  # refused: with any heading and parameters; else as it is
    flights: int


def headings_of(case: Case, chosen_deg: float) -> list[float]:
    """Headings to search within the tolerance: the one it would take, the target's, and a few about."""
    given, turn = case.mission.target.heading_deg, turn_used_deg(case.mission.target, vehicle())
    off = {0.0, (chosen_deg - given + 180.0) % 360.0 - 180.0, -turn, turn, -0.5 * turn, 0.5 * turn}
    return sorted({round(given + one, 3) for one in off if abs(one) <= turn + 1e-6})


def ways(case: Case, chosen_deg: float) -> Iterator[tuple[Case, Overrides]]:
    """Every heading with every set of parameters."""
    for heading in headings_of(case, chosen_deg):
        target = replace(case.mission.target, heading_deg=heading % 360.0, heading_tolerance_deg=0.0)
        turned = replace(case, mission=replace(case.mission, target=target))
        for changed in SEARCHED:
            yield turned, {"docking": {**_TRY, **changed}}


def ask(number: int, heading: Heading) -> Asked:
    """What is said of a mission, and what is so."""
    case = draw_case(number, "normal", heading)
    mission = case.mission
    current = mission.environment.current_ned_mps
    station = station_keeping(vehicle(), default_parameters(vehicle()), current, mission.target)
    c, s = (f(math.radians(station.chosen_deg)) for f in (math.cos, math.sin))
    flights, docks = 0, False
    tried = ways(case, station.chosen_deg) if station.chosen.zone == REFUSE else iter([(case, {})])
    for way, overrides in tried:
        flights += 1
        flown = fly_case(way, overrides)
        docks = judge(way, flown).outcome == "docked" and not hits(flown.log, mission.target).any()
        if docks:
            break
    gusts = mission.environment.current_variation
    return Asked(
        number, station.chosen.zone, current[0] * c + current[1] * s, -current[0] * s + current[1] * c,
        gusts.std_mps if gusts else 0.0, docks, flights,
    )  # fmt: skip


def _one(job: tuple[int, Heading]) -> Asked:
    return ask(*job)


def main() -> None:
    """Ask, fly, count and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--heading", choices=("fixed", "some"), default="fixed")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--out", help="write each answer there, JSON")
    a = parser.parse_args()
    jobs: list[tuple[int, Heading]] = [(number, a.heading) for number in range(a.first, a.first + a.count)]
    rows = in_order(jobs, _one, a.workers)
    for zone, word in ZONES.items():
        some = [row for row in rows if row.zone == zone]
        if some:
            docked = share_of(sum(row.docks for row in some), len(some))
            could = "could have docked" if zone == REFUSE else "docked"
            print(f"{word}: {len(some)}; {could}: {docked.count} ({docked.low:.1%} to {docked.high:.1%})")
    if a.out:
        with open(a.out, "w") as file:
            json.dump([asdict(row) for row in rows], file)


if __name__ == "__main__":
    main()
