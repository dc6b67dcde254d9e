"""The page of figures, made from what was measured: docs/trust_figures.md."""

from pathlib import Path
from typing import Any

PAGE = Path(__file__).parents[2] / "docs" / "trust_figures.md"

HEAD = """\
# Trust, measured

What `python -m tests.trust --commit` found at full size; a small share of each trial is part of the tests
(`tests/trust/test_trials.py`). Why each is tried: [What can be trusted](trust.md). Times were taken while as
many jobs as the last column says wanted one of the machine's two cores.

| trial | what | found | promised | kept | load |
| --- | --- | --- | --- | --- | --- |
"""


def text(known: dict[str, Any]) -> str:
    """The page for these figures, by trial."""
    rows = []
    for one in known.values():
        for figure in one["figures"]:
            found = f"{figure['value']:.4g} {figure['unit']}".strip()
            kept = "yes" if figure["met"] else "**no**"
            cells = (figure["trial"], figure["what"], found, figure["goal"], kept, str(one["load"]))
            rows.append(f"| {' | '.join(cells)} |")
    return HEAD + "\n".join(rows) + "\n"


def write(known: dict[str, Any]) -> None:
    """Renew the page."""
    PAGE.write_text(text(known), encoding="utf-8")
