"""Fly many cases: `python -m bumpless_paper.study.docks.many --first 0 --count 60 --kind normal`."""

import argparse
import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict, replace
from typing import Any

from bumpless.campaign.engine import in_order
from bumpless.campaign.summary import share_of
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.sim.twin import Result, simulate
from bumpless_paper.study.docks.cases import KINDS, Case, Heading, Kind, draw_case, vehicle
from bumpless_paper.study.docks.judge import Judgement, judge
from bumpless_paper.study.learned import EARLIER, Unlearned, learned_from

Overrides = Mapping[str, Mapping[str, Any]]
Job = tuple[int, Kind, Heading, Overrides | None, bool, bool]


def fly_case(
    case: Case, overrides: Overrides | None = None, flow: bool = False, learned: bool = False
) -> Result:
    """The flight of a case; overrides: parameters by section; flow: with the mission's `actuator_flow`;
    learned: the vehicle's file says what was identified in a flight of another sea and seed before."""
    parameters = with_overrides(default_parameters(vehicle()), overrides or {})
    mission = replace(case.mission, actuator_flow=True) if flow else case.mission
    if not learned:
        return simulate(mission, vehicle(), parameters, mission.seed, alter=case)
    before = fly_case(replace(draw_case(case.number + EARLIER, "normal", "into"), plant=case.plant))
    alter = Unlearned(vehicle(), case)
    return simulate(mission, learned_from(before), parameters, mission.seed, alter=alter)


def _one(job: Job) -> Judgement:
    number, kind, heading, overrides, flow, learned = job
    case = draw_case(number, kind, heading)
    return judge(case, fly_case(case, overrides, flow, learned))


def fly_cases(
    numbers: Iterable[int],
    kind: Kind = "normal",
    heading: Heading = "",
    overrides: Overrides | None = None,
    workers: int = 1,
    flow: bool = False,
    learned: bool = False,
) -> list[Judgement]:
    """Judgements of many cases, in order."""
    jobs: list[Job] = [(number, kind, heading, overrides, flow, learned) for number in numbers]
    return in_order(jobs, _one, workers)


def main() -> None:
    """Fly, count and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--kind", choices=KINDS, default="normal")
    parser.add_argument("--heading", choices=("", "fixed", "some", "into"), default="")
    parser.add_argument("--flow", action="store_true", help="with the real flow at screws and fins")
    parser.add_argument("--learned", action="store_true", help="after a flight before, see bumpless identify")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--out", help="write the judgements there, JSON")
    a = parser.parse_args()
    numbers = range(a.first, a.first + a.count)
    rows = fly_cases(numbers, a.kind, a.heading, workers=a.workers, flow=a.flow, learned=a.learned)
    counts = Counter(row.outcome for row in rows)
    docked = share_of(counts["docked"], len(rows))
    heading = a.heading or "drawn heading"
    print(f"{a.kind} {heading}: {dict(counts)}; docked {docked.low:.1%} to {docked.high:.1%}")
    for row in rows:
        if row.outcome not in ("docked", "waved_off"):
            print(row)
    if a.out:
        with open(a.out, "w") as file:
            json.dump([asdict(row) for row in rows], file)


if __name__ == "__main__":
    main()
