"""What the bench of foresight says of its intervals, and where it writes it."""

from pathlib import Path

from tests.bench.foresight import chance_lines, into_docs

ROWS = [
    {"mission": "one", "fan": 0.9, "low": 0.85, "high": 0.93, "fresh": 0.92, "inside": True},
    {"mission": "two", "fan": 0.5, "low": 0.43, "high": 0.57, "fresh": 0.6, "inside": False},
]


def test_an_interval_that_missed_is_told(tmp_path: Path) -> None:
    """Protects: the page shows what did not hold as well, and nothing around it is touched."""
    page = tmp_path / "page.md"
    page.write_text("before\n<!-- chance: begin -->\nold\n<!-- chance: end -->\nafter\n")
    into_docs("chance", chance_lines(ROWS, 1000), page)
    text = page.read_text()
    assert text.startswith("before\n<!-- chance: begin -->\nInside: 1 of 2") and "old" not in text
    assert "10.0 % at most" in text and "**outside**" in text
    assert text.endswith("<!-- chance: end -->\nafter\n")
