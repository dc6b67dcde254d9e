"""The documentation of campaigns."""

from pathlib import Path

from bumpless.campaign.quantities import QUANTITIES

PAGE = Path(__file__).parents[2] / "docs" / "campaigns.md"


def test_every_quantity_is_documented():
    """Protects: what can be drawn can be looked up, in the words of the code."""
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    missing = [n for n, q in QUANTITIES.items() if f"| `{n}` | {q.unit} | {q.about} |" not in lines]
    assert not missing
