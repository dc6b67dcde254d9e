"""How often do the plans dock that people fly? `python -m bumpless_paper.study.docks.shares --count 50`.

Every shipped mission, a newcomer's first one and odd plans, each with a vehicle, a sea and a target that are
not quite the plan's, as `missions/campaigns/foresight.yaml` draws them. Numbers from HELD_OUT on had no part
in any choice.
"""

import argparse
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from bumpless.campaign.engine import in_order
from bumpless.campaign.flight import Hangar
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.sketch import foresight_campaign, sketch
from bumpless.campaign.summary import share_of
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.feasibility import check_mission
from bumpless_paper.study.docks.plans import DOCKS, NOT_MEANT, SELDOM, Plans, groups

FIRST, HELD_OUT = 800_000, 5_300_000
OTHERS = 3  # of plans that are no example, so many times the flights
OFTEN = 0.95  # of flights that keep what is promised
SAID = ("docked", "held", "waved_off", "collided")


@dataclass(frozen=True)
class Row:
    """One line: what became of the plans that the check lets start."""

    name: str
    promise: str
    refused: int
    ends: dict[str, int]  # outcome -> flights

    @property
    def flights(self) -> int:
        """That were let start."""
        return sum(self.ends.values())

    @property
    def kept(self) -> int:
        """In which it docked, or what its title says instead, without a touch."""
        docked, struck = self.ends.get("docked", 0), self.ends.get("collided", 0)
        unstruck = self.flights - struck
        return {DOCKS: docked, NOT_MEANT: unstruck - docked, SELDOM: unstruck}[self.promise]

    @property
    def keeps(self) -> bool:
        """Whether it does what it promises in 95 of 100."""
        return self.flights > 0 and self.kept >= OFTEN * self.flights

    @property
    def cells(self) -> tuple[str, ...]:
        """For a table."""
        docked = share_of(self.ends.get("docked", 0), self.flights)
        other = self.flights - sum(self.ends.get(word, 0) for word in SAID)
        counts = [str(self.ends.get(word, 0)) for word in SAID[1:]]
        among = f"{docked.count} of {docked.total} ({docked.low:.0%} – {docked.high:.0%})"
        return (self.name, self.promise, among, *counts, str(other), str(self.refused))


HEAD = ("plan", "promises", "docked (95 %)", "held", "waved off", "in the dock", "other", "refused")


def end_of(job: tuple[str, int]) -> str:
    """How flight `number` of a group ended; "refused" where the check would not let it start."""
    name, number = job
    plans = _groups()[name]
    mission = plans.mission(number)
    vehicle = _vehicle(mission.vehicle)
    if plans.promise == DOCKS and any(found.blocks for found in check_mission(mission, vehicle)):
        return "refused"
    parameters = with_overrides(default_parameters(vehicle), mission.parameters)
    prepared = Prepared(foresight_campaign(), (Setup(mission, vehicle, parameters),))
    return sketch(prepared, number, _hangar(), 2).outcome.ending.value


def rows(
    first: int, count: int, only: Sequence[str] = (), workers: int = 2, others: int = OTHERS
) -> list[Row]:
    """A row a group; groups whose name begins with one of `only`, all for none."""
    found = []
    for name, plans in _groups().items():
        if only and not name.startswith(tuple(only)):
            continue
        many = count if name in _shipped() else others * count
        ends = Counter(in_order([(name, first + k) for k in range(many)], end_of, workers))
        refused = ends.pop("refused", 0)
        found.append(Row(name, plans.promise, refused, dict(sorted(ends.items()))))
    return found


def _shipped() -> set[str]:
    return {name for name in _groups() if " " not in name}


@cache
def _groups() -> dict[str, Plans]:
    return groups()


@cache
def _vehicle(name: str) -> Vehicle:
    return load_vehicle(name)


@cache
def _hangar() -> Hangar:
    return Hangar()


def table(cells: Sequence[Sequence[str]]) -> list[str]:
    """Lines of Markdown."""
    return [f"| {' | '.join(row)} |" for row in (HEAD, ["---"] * len(HEAD), *cells)]


def main() -> None:
    """Fly and print a table; exit code 1 where a plan does not do what it promises."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=FIRST, help=f"from {HELD_OUT} on: for reports alone")
    parser.add_argument(
        "--count", type=int, default=50, help="flights of each example, a third of the others"
    )
    parser.add_argument("--only", nargs="+", default=[], help="names of plans begin with one of these")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument(
        "--out", help="write the table there, JSON; docs/docking.md shows results/shares.json"
    )
    a = parser.parse_args()
    found = rows(a.first, a.count, a.only, a.workers)
    print("\n".join(table([row.cells for row in found])))
    if a.out:
        told = {"first": a.first, "count": a.count, "rows": [row.cells for row in found]}
        with open(a.out, "w", encoding="utf-8") as file:
            json.dump(told, file, indent=1, ensure_ascii=False)
            file.write("\n")
    raise SystemExit(0 if all(row.keeps for row in found) else 1)


if __name__ == "__main__":
    main()
