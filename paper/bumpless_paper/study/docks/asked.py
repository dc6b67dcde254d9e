"""Is what the check says right? `python -m bumpless_paper.study.docks.asked --count 60`.

Missions on both sides of each rule (`sides`), asked and flown whatever was said, each with a vehicle, a sea
and a target a little off the plan's. Of what is refused none should have docked, of what is let pass in
silence all.
"""

import argparse
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from bumpless.campaign.engine import in_order
from bumpless.campaign.flight import Hangar
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.sketch import foresight_campaign, sketch
from bumpless.campaign.summary import share_of
from bumpless.config.parameters import default_parameters
from bumpless.feasibility import check_mission
from bumpless_paper.study.docks.cases import vehicle
from bumpless_paper.study.docks.shares import FIRST, HELD_OUT
from bumpless_paper.study.docks.sides import FAMILIES

ADVICE = ("seen_early", "leg_near_dock")  # said of legs that are flown as well
REFUSED, WARNED, SILENT, ELSE = "refused", "warned of", "let pass", "said for another reason"
HEAD = (
    "rules",
    "refused: docked all the same",
    "warned of: docked",
    "let pass: docked",
    "in the dock of those",
)


@dataclass(frozen=True)
class Row:
    """A family: how many of each kind of answer there were, docked, and ran into the dock."""

    codes: tuple[str, ...]
    asked: dict[str, int]
    docked: dict[str, int]
    struck: dict[str, int]

    @property
    def cells(self) -> tuple[str, ...]:
        """For a table; shares with their Wilson intervals."""
        found = []
        for said in (REFUSED, WARNED, SILENT):
            one = share_of(self.docked.get(said, 0), self.asked.get(said, 0))
            interval = f" ({one.low:.0%} – {one.high:.0%})" if one.total else ""
            found.append(f"{one.count} of {one.total}{interval}" if one.total else "–")
        return (", ".join(self.codes), *found, str(self.struck.get(SILENT, 0)))


def ask(job: tuple[str, int]) -> tuple[str, str]:
    """(what was said, how it ended) of mission `number` of a family."""
    name, number = job
    family = FAMILIES[name]
    mission, parameters = family.mission(name, number), default_parameters(vehicle())
    found = check_mission(mission, vehicle())
    found = [one for one in found if one.code in family.codes or one.code not in ADVICE]
    mine = [one for one in found if one.code in family.codes]
    if len(mine) < len(found):
        said = ELSE
    else:
        said = REFUSED if any(one.blocks for one in mine) else WARNED if mine else SILENT
    prepared = Prepared(foresight_campaign(), (Setup(mission, vehicle(), parameters),))
    return said, sketch(prepared, number, _hangar(), 2).outcome.ending.value


def row(name: str, first: int, count: int, workers: int = 2) -> Row:
    """A family, asked and flown."""
    answers = in_order([(name, first + k) for k in range(count)], ask, workers)
    asked = Counter(said for said, _ in answers)
    docked = Counter(said for said, end in answers if end == "docked")
    struck = Counter(said for said, end in answers if end == "collided")
    return Row(FAMILIES[name].codes, dict(asked), dict(docked), dict(struck))


def rows(first: int, count: int, only: Sequence[str] = (), workers: int = 2) -> list[Row]:
    """A row a family."""
    return [row(name, first, count, workers) for name in FAMILIES if not only or name in only]


@cache
def _hangar() -> Hangar:
    return Hangar()


def main() -> None:
    """Ask, fly and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=FIRST, help=f"from {HELD_OUT} on: for reports alone")
    parser.add_argument("--count", type=int, default=60, help="missions of each family")
    parser.add_argument("--only", nargs="+", default=[], choices=list(FAMILIES))
    parser.add_argument("--workers", type=int, default=2)
    a = parser.parse_args()
    print(f"| {' | '.join(HEAD)} |\n|{'---|' * len(HEAD)}")
    for name in FAMILIES:
        if not a.only or name in a.only:
            print(f"| {' | '.join(row(name, a.first, a.count, a.workers).cells)} |", flush=True)


if __name__ == "__main__":
    main()
