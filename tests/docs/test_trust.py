"""The failure table is no list of wishes: every row names tests, and every test exists."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = (ROOT / "docs" / "trust.md").read_text(encoding="utf-8")
TEST = re.compile(r"`(tests/[\w/]+\.py)::(test_\w+)`")


def rows() -> list[str]:
    """The rows of every table, without heads and rules."""
    lines = [line for line in TABLE.splitlines() if line.startswith("|")]
    return [line for line in lines if not line.startswith(("| ---", "| danger"))]


def test_every_danger_has_a_guard_and_a_test() -> None:
    """Protects: a danger whose guard nobody tests is not guarded."""
    assert len(rows()) > 30
    for row in rows():
        danger, guard, tests = (cell.strip() for cell in row.strip("|").split("|"))
        assert danger and guard and TEST.search(tests), row


def test_every_test_that_is_named_is_there() -> None:
    """Protects: a renamed test would leave the table claiming what nobody checks."""
    for path, name in TEST.findall(TABLE):
        source = ROOT / path
        assert source.is_file(), path
        assert re.search(rf"^(async )?def {name}\(", source.read_text(encoding="utf-8"), re.MULTILINE), name
