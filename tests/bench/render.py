"""Keep the table of docs/performance.md in step: `python -m tests.bench.render [--check]`."""

import json
import sys
from pathlib import Path

from tests.bench.figure import short

FIGURES = Path(__file__).with_name("figures.json")
PAGE = Path(__file__).parents[2] / "docs" / "performance.md"
BEGIN, END = "<!-- figures: begin -->", "<!-- figures: end -->"


def table(measured: dict) -> str:
    """Markdown of the machine and every row."""
    lines = ["; ".join(f"{name}: {value}" for name, value in measured["machine"].items()) + ".", ""]
    lines += ["| figure | median | quartiles | goal | |", "|---|--:|--:|--:|---|"]
    for row in measured["figures"]:
        mark = {True: "met", False: "**not met**", None: ""}[row["met"]]
        spread = f"{short(row['low'])} … {short(row['high'])}" if row["low"] != row["high"] else ""
        lines.append(
            f"| {row['title']} | {short(row['value'])} {row['unit']} | {spread} | {row['goal']} | {mark} |"
        )
    return "\n".join(lines)


def page_of(page: str, measured: dict) -> str:
    """`page` with its table made anew."""
    head, rest = page.split(BEGIN)
    return f"{head}{BEGIN}\n{table(measured)}\n{END}{rest.split(END)[1]}"


def main() -> int:
    """Rewrite the page, or with --check say whether it is out of step."""
    before = PAGE.read_text(encoding="utf-8")
    after = page_of(before, json.loads(FIGURES.read_text(encoding="utf-8")))
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(after, encoding="utf-8")
    elif after != before:
        print("docs/performance.md is not what tests/bench/figures.json says: python -m tests.bench.render")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
