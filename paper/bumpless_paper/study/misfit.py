"""How much of e_tau on wide plants is what nobody on board knows: `python -m bumpless_paper.study.misfit`.

The same plants fly as drawn, then with thrust as in the vehicle's file, then lift, then lag and slew. And as
drawn once more, after one flight before from whose log thrust and lift were identified.
"""

import argparse
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from bumpless_paper.study.fly import Job, fly_all
from bumpless_paper.study.honest import judged
from bumpless_paper.study.plants import WIDE, draw
from bumpless_paper.study.scenarios import Overrides


@dataclass(frozen=True)
class Row:
    """What of the plants is known on board."""

    known: Mapping[str, float] = field(default_factory=dict[str, float])  # because plants are as the file
    learned: bool = False
    extra: Overrides = field(default_factory=dict[str, dict[str, Any]])


ROWS: dict[str, Row] = {
    "as drawn": Row(),
    "as drawn, learned in a flight before": Row(learned=True),
    "learned, and a quicker flow": Row(learned=True, extra={"guidance": {"flow_filter_s": 0.3}}),
    "thrust as in the file": Row({"thrust": 1.0}),
    "lift too": Row({"thrust": 1.0, "fin_lift": 1.0}),
    "lag and slew too": Row({"thrust": 1.0, "fin_lift": 1.0, "fin_slew": 1.0, "lag": 1.0}),
}
PARTS = {"e_tau_map": "allocated", "e_tau_told": "given as told", "e_tau_true": "whole"}


def medians(name: str, numbers: Iterable[int], row: Row, workers: int = 1) -> dict[str, float]:
    """Medians of the parts of e_tau, N and N m, of a scenario over plants of which this much is known."""
    jobs = [
        Job(name, number + 1, replace(draw(number, WIDE), **row.known), row.extra, learned=row.learned)
        for number in numbers
    ]
    flown = fly_all(jobs, judged, workers=workers)
    return {key: float(np.nanmedian([one[key] for one in flown])) for key in PARTS}


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=60)
    parser.add_argument("--count", type=int, default=20)
    a = parser.parse_args()
    for what, row in ROWS.items():
        for name in ("S4", "S2"):
            said = medians(name, range(a.first, a.first + a.count), row, workers=2)
            print(f"{what}, {name}: " + ", ".join(f"{PARTS[k]} {x:.3f}" for k, x in said.items()), flush=True)


if __name__ == "__main__":
    main()
