"""The table "How often it docks" of docs/docking.md: `python -m bumpless_paper.study.docks.table`.

Its seeds had no part in any choice: they are flown for the page and looked at once.
"""

import argparse
from collections import Counter

from bumpless_paper.study.docks.cases import Heading, Kind
from bumpless_paper.study.docks.many import fly_cases

ROWS: tuple[tuple[Kind, Heading, int, int], ...] = (
    ("normal", "into", 5_110_000, 120),
    ("still", "fixed", 5_110_120, 60),
    ("any", "some", 5_100_000, 250),
    ("any", "", 5_100_250, 150),
    ("fault", "", 5_110_180, 80),
    ("lost", "", 5_110_260, 80),
    ("camera_dead", "", 5_110_340, 60),
)


def row(kind: Kind, heading: Heading, first: int, count: int, workers: int) -> str:
    """One line of the table, flown."""
    ends = Counter(
        one.outcome for one in fly_cases(range(first, first + count), kind, heading, None, workers)
    )
    docked, waved, struck = ends["docked"], ends["waved_off"], ends["collided"]
    about = f"{kind}, {heading}" if heading else kind
    neither = count - docked - waved - struck
    return f"| {about} | {first}, {count} | {docked} | {waved} | {neither} | {struck} |"


def main() -> None:
    """Fly and print, line by line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--workers", type=int, default=2)
    workers = parser.parse_args().workers
    print("| `--kind`, `--heading` | `--first`, `--count` | docked | waved off | neither | in the dock |")
    print("|---|---|---|---|---|---|")
    for kind, heading, first, count in ROWS:
        print(row(kind, heading, first, count, workers), flush=True)


if __name__ == "__main__":
    main()
