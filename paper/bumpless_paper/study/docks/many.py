"""Fly many cases: `python -m bumpless_paper.study.docks.many --first 0 --count 60 --kind normal`."""

import argparse
import json
import math
import multiprocessing
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.sim.twin import Result, simulate
from bumpless_paper.study.docks.cases import KINDS, Case, Heading, Kind, draw_case, vehicle
from bumpless_paper.study.docks.judge import Judgement, judge

Overrides = Mapping[str, Mapping[str, Any]]


def fly_case(case: Case, overrides: Overrides | None = None) -> Result:
    """The flight of a case; overrides: parameters by section."""
    parameters = with_overrides(default_parameters(vehicle()), overrides or {})
    return simulate(case.mission, vehicle(), parameters, case.mission.seed, alter=case)


def _one(job: tuple[int, Kind, Heading, Overrides | None]) -> Judgement:
    number, kind, heading, overrides = job
    case = draw_case(number, kind, heading)
    return judge(case, fly_case(case, overrides))


def fly_cases(
    numbers: Iterable[int],
    kind: Kind = "normal",
    heading: Heading = "",
    overrides: Overrides | None = None,
    workers: int = 1,
) -> list[Judgement]:
    """Judgements of many cases, in order."""
    jobs: list[tuple[int, Kind, Heading, Overrides | None]] = [
        (number, kind, heading, overrides) for number in numbers
    ]
    if workers <= 1:
        return [_one(job) for job in jobs]
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        return pool.map(_one, jobs, chunksize=4)


def wilson(hits: int, count: int, z: float = 1.96) -> tuple[float, float]:
    """Confidence interval of a share, 95 %. Source: Wilson 1927."""
    if count == 0:
        return 0.0, 1.0
    p, n = hits / count, count
    middle, spread = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return max(0.0, (middle - spread) / (1 + z * z / n)), min(1.0, (middle + spread) / (1 + z * z / n))


def main() -> None:
    """Fly, count and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--kind", choices=KINDS, default="normal")
    parser.add_argument("--heading", choices=("", "fixed", "some", "into"), default="")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--out", help="write the judgements there, JSON")
    a = parser.parse_args()
    rows = fly_cases(range(a.first, a.first + a.count), a.kind, a.heading, workers=a.workers)
    counts = Counter(row.outcome for row in rows)
    low, high = wilson(counts["docked"], len(rows))
    print(f"{a.kind} {a.heading or 'drawn heading'}: {dict(counts)}; docked {low:.1%} to {high:.1%}")
    for row in rows:
        if row.outcome not in ("docked", "waved_off"):
            print(row)
    if a.out:
        with open(a.out, "w") as file:
            json.dump([asdict(row) for row in rows], file)


if __name__ == "__main__":
    main()
