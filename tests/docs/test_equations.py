"""The way from an equation to its line: read from docstrings, complete, and true."""

from pathlib import Path

import pytest

from docs.generate import equations
from docs.generate.equations import LAST, Place, cited

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("docstring", "numbers"),
    [
        ("Does it. Source: Gao et al. 2026, eq. (53).", {53}),
        ("Does it.\n\nSource: Gao et al. 2026, eq. (27)-(29), (46), (50).", {27, 28, 29, 46, 50}),
        ("Source: Gao et al. 2026, eqs. (54)-(57), Proposition 1.", {54, 55, 56, 57}),
        ("Source: Fossen 2021, eq. (3.49).", set()),
        ("Source: Fossen 2021, eq. (12); Gao et al. 2026, eq. (6)-(7).", {6, 7}),
        ("Like eq. (9), but no source.", set()),
    ],
)
def test_citations_are_read_as_they_are_written(docstring: str, numbers: set[int]) -> None:
    """Protects: spans and lists are all found, and another book's equations are not taken for the paper's."""
    assert cited(docstring) == numbers


def test_a_bare_citation_counts_where_the_module_names_the_paper() -> None:
    """Protects: "Source: eq. (9)" below a module that cites the paper."""
    assert cited("Source: eq. (9).") == frozenset()
    assert cited("Source: eq. (9).", paper_meant=True) == {9}


def test_every_equation_of_the_method_leads_to_a_function() -> None:
    """Protects: no equation that a reader looks for in vain, or that leads no nearer than to a module."""
    known = set().union(*(place.equations for place in equations.places() if place.function))
    assert set(range(1, LAST + 1)) - known == set()


def test_the_page_has_room_for_every_equation() -> None:
    """Protects: the method page's groups leave no equation out."""
    page = (ROOT / "docs" / "method.md").read_text(encoding="utf-8")
    room = [range(int(a), int(b) + 1) for _, a, b, _ in equations.PLACE.findall(page)]
    assert sorted(number for span in room for number in span) == list(range(1, LAST + 1))


def test_what_implements_one_equation_comes_before_what_names_many() -> None:
    """Protects: the first row of a table is the line that a reader wants."""
    module = Place("twin/bumpless/a.py", 1, "", "All", frozenset({41, 42}))
    function = Place("twin/bumpless/b.py", 7, "law", "One", frozenset({41}))
    table = equations.filled("<!-- lines: 41-41 -->\n<!-- end -->", [module, function])
    assert table.splitlines()[3] == "| (41) | [`law`, b.py:7](../twin/bumpless/b.py#L7) | One |"
