"""How much of e_tau on wide plants is what nobody on board knows: `python -m bumpless_paper.study.misfit`.

The same plants fly as drawn, then with thrust as in the vehicle's file, then lift, then lag and slew.
"""

import argparse
from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np

from bumpless_paper.study.fly import Job, fly_all
from bumpless_paper.study.honest import judged
from bumpless_paper.study.plants import WIDE, draw

KNOWN: dict[str, dict[str, float]] = {
    "as drawn": {},
    "thrust as in the file": {"thrust": 1.0},
    "lift too": {"thrust": 1.0, "fin_lift": 1.0},
    "lag and slew too": {"thrust": 1.0, "fin_lift": 1.0, "fin_slew": 1.0, "lag": 1.0},
}
PARTS = {"e_tau_map": "allocated", "e_tau_told": "given as told", "e_tau_true": "whole"}


def medians(
    name: str, numbers: Iterable[int], known: Mapping[str, float], workers: int = 1
) -> dict[str, float]:
    """Medians of the parts of e_tau, N and N m, of a scenario over plants of which this much is known."""
    jobs = [Job(name, number + 1, replace(draw(number, WIDE), **known)) for number in numbers]
    flown = fly_all(jobs, judged, workers=workers)
    return {key: float(np.nanmedian([one[key] for one in flown])) for key in PARTS}


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=60)
    parser.add_argument("--count", type=int, default=20)
    a = parser.parse_args()
    for what, known in KNOWN.items():
        for name in ("S4", "S2"):
            said = medians(name, range(a.first, a.first + a.count), known, workers=2)
            print(f"{what}, {name}: " + ", ".join(f"{PARTS[k]} {x:.3f}" for k, x in said.items()), flush=True)


if __name__ == "__main__":
    main()
