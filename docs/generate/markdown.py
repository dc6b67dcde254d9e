"""Small pieces of Markdown."""

from collections.abc import Iterable, Sequence

NOTE = "<!-- Made from the code by `make gen`; edit the code, not this page. -->\n\n"


def cell(text: object) -> str:
    """Text that may stand in a table's cell: one line, no bar."""
    return " ".join(str(text).split()).replace("|", "\\|")


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A Markdown table, ended by a line break."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(cell(one) for one in line) + " |\n" for line in lines)


def code(text: object) -> str:
    """`text` in code type; nothing for nothing."""
    return f"`{text}`" if str(text) else ""
