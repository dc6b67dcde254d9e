"""Which function implements which equation of the paper: read from the `Source:` lines of docstrings.

docs/method.md has a place `<!-- lines: 41-44 -->` ... `<!-- end -->` under each group of equations; it gets a
table of the functions that cite one of them, each with a link to its line.
"""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ROOT / "twin" / "bumpless"
LAST = 57  # the paper's last numbered equation
PLACE = re.compile(r"(<!-- lines: (\d+)-(\d+) -->\n).*?(<!-- end -->)", re.DOTALL)
PAPER = "Gao et al. 2026"
NUMBERS = re.compile(r"eqs?\. ((?:\(\d{1,2}\)(?:\s*(?:-|, | and )\s*)?)+)")
SPAN = re.compile(r"\((\d{1,2})\)(?:-\((\d{1,2})\))?")


@dataclass(frozen=True)
class Place:
    """A function, class or module that says which equations it implements."""

    path: str  # from the repository's root
    line: int
    name: str  # "" for a module
    meaning: str  # its docstring's first sentence
    equations: frozenset[int]
    function: bool = False  # what computes it, not a module or a class


def cited(docstring: str, paper_meant: bool = False) -> frozenset[int]:
    """Numbers of the paper's equations in the `Source:` of a docstring.

    `paper_meant`: a bare "Source: eq. (9)" means the paper, as its module says so.
    """
    found: set[int] = set()
    text = " ".join(docstring.split())
    for source in re.findall(r"Source: (.*?)(?=Source:|Differs:|$)", text):
        for part in source.split(";"):
            if PAPER in part or (paper_meant and part.startswith("eq")):
                for group in NUMBERS.findall(part):
                    for first, last in SPAN.findall(group):
                        found |= set(range(int(first), int(last or first) + 1))
    return frozenset(found)


def places(folder: Path = LIBRARY) -> list[Place]:
    """Every citing module, class and function below `folder`, in the order of files and lines."""
    return [place for path in sorted(folder.rglob("*.py")) for place in _in_file(path)]


def _in_file(path: Path) -> Iterator[Place]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    shown = path.relative_to(ROOT).as_posix()
    own = ast.get_docstring(tree) or ""
    whole = cited(own)
    if whole:
        yield Place(shown, 1, "", _sentence(own), whole)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            text = ast.get_docstring(node) or ""
            if equations := cited(text, paper_meant=PAPER in own):
                yield Place(
                    shown,
                    node.lineno,
                    node.name,
                    _sentence(text),
                    equations,
                    isinstance(node, ast.FunctionDef),
                )


def _sentence(docstring: str) -> str:
    text = " ".join(docstring.split()).split("Source:")[0].strip()
    return re.split(r"(?<=[.;]) ", text)[0].rstrip(":;.").replace("|", "\\|")


def filled(page: str, found: list[Place] | None = None) -> str:
    """The method page with its tables made anew."""
    found = places() if found is None else found
    return PLACE.sub(lambda match: match[1] + _table(found, int(match[2]), int(match[3])) + match[4], page)


def _table(found: list[Place], first: int, last: int) -> str:
    wanted = set(range(first, last + 1))
    rows = [(sorted(place.equations & wanted), place) for place in found if place.equations & wanted]
    # the function that implements one equation comes before the module that names twenty
    rows.sort(key=_nearest_first)
    lines = ["| equation | where | what it does |\n", "| --- | --- | --- |\n"]
    for numbers, place in rows:
        module = place.path.removeprefix("twin/bumpless/")
        name = f"`{place.name}`, {module}:{place.line}" if place.name else module
        lines.append(f"| {_spans(numbers)} | [{name}](../{place.path}#L{place.line}) | {place.meaning} |\n")
    return "".join(lines)


def _nearest_first(row: tuple[list[int], Place]) -> tuple[object, ...]:
    numbers, place = row
    return not place.name, not place.function, numbers[0], len(place.equations), place.path, place.line


def _spans(numbers: list[int]) -> str:
    """[1, 2, 3, 7] -> "(1)–(3), (7)"."""
    spans: list[list[int]] = []
    for number in numbers:
        if spans and spans[-1][1] == number - 1:
            spans[-1][1] = number
        else:
            spans.append([number, number])
    return ", ".join(f"({a})" if a == b else f"({a})–({b})" for a, b in spans)
