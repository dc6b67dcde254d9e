"""The figures that README leads with are those of the results."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROWS = (
    "hull in the dock",
    "docked, approach into the current",
    "docked in still water",
    "hover held for 10 min",
)


@pytest.mark.parametrize("row", ROWS)
def test_readme_says_what_the_results_say(row) -> None:
    """Protects: the first page told figures, and shortfalls, of a control that was gone."""
    results = (ROOT / "docs" / "results.md").read_text()
    (line,) = [one for one in results.splitlines() if one.startswith(f"| {row}")]
    found = re.search(r"([\d,]+) of ([\d,]+)", line.split("|")[4])
    assert found
    part, whole = found.groups()
    said = " ".join((ROOT / "README.md").read_text().split())
    none = f"in none of {whole} was" if part == "0" else None
    assert (none or f"{part} of {whole}") in said


def test_the_shares_in_the_docs_are_those_of_the_results() -> None:
    """Protects: shares of examples, first missions and odd plans that no command had made."""
    told = json.loads((ROOT / "results" / "shares.json").read_text(encoding="utf-8"))
    page = (ROOT / "docs" / "docking.md").read_text(encoding="utf-8")
    assert f"docks.shares --first {told['first']} --count {told['count']}" in page
    section = page.split("## How often the examples dock")[1].split("\n## ")[0]
    shown = [line.strip("| ").split(" | ") for line in section.splitlines() if line.startswith("| ")]
    assert shown[2:] == told["rows"]
