"""The reference page of a model: its fields in tables, as Markdown."""

from typing import Any

from bumpless.config.declare.catalogue import catalogue
from bumpless.config.declare.models import fields_of
from bumpless.config.declare.overrides import Overrides
from bumpless.config.plain import is_list, is_tuple

HEAD = (
    "| field | type | unit | range | default | live | meaning |",
    "|---|---|---|---|---|---|---|",
)


def tables(cls: type) -> list[str]:
    """Lines of Markdown: a heading and a table for the model and for each of its parts.

    Overrides of another model are not spelt out: that model has a page of its own.
    """
    groups: dict[tuple[str, str], list[dict[str, Any]]] = {}
    headings: dict[tuple[str, str], str] = {}
    elsewhere = tuple(f"{key}." for key, field in fields_of(cls).items() if isinstance(field.note, Overrides))
    for entry in catalogue(cls):
        if entry["path"].startswith(elsewhere):
            continue
        holder, _, _ = entry["path"].rpartition(".")
        groups.setdefault((holder, entry["kind"]), []).append(entry)
        headings.setdefault((entry["path"].removesuffix("[]"), entry["kind"]), entry["label"])
    lines: list[str] = []
    for (holder, kind), entries in groups.items():
        if holder:
            which = f" with `kind` {kind}" if kind else ""
            about = next(
                (text for (path, _), text in headings.items() if path == holder.removesuffix("[]")), ""
            )
            lines += [f"## `{holder}`{which}", "", f"{about}.", ""]
        lines += [*HEAD, *(_line(entry) for entry in entries), ""]
    return lines


def _line(entry: dict[str, Any]) -> str:
    name = entry["path"].rpartition(".")[2]
    meaning = entry["label"] + (f". {entry['help']}" if entry["help"] else "")
    cells = (
        f"`{name}`",
        _kind(entry),
        entry["unit"],
        _range(entry),
        _default(entry),
        "yes" if entry["live"] else "",
        meaning,
    )
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _kind(entry: dict[str, Any]) -> str:
    match entry["type"]:
        case "row":
            names = ", ".join(entry["names"])
            return f"row [{names}]" if names else "row, one per command"
        case "choice":
            return "word"
        case "switch":
            return "true or false"
        case "words":
            return "list of words"
        case "list":
            return "list"
        case "part":
            return "table"
        case _:
            return entry["type"]


def _range(entry: dict[str, Any]) -> str:
    if "choices" in entry:
        return ", ".join(f"`{word}`" for word in entry["choices"])
    if entry["type"] == "list":
        return f"{entry['fewest']} to {entry['most']} entries"
    if entry.get("form"):
        return entry["form"]
    low, high = entry.get("min"), entry.get("max")
    if is_tuple(low) and is_tuple(high):
        pairs = zip(entry["names"], low, high, strict=True)
        return ", ".join(f"{name} {a:.10g} to {b:.10g}" for name, a, b in pairs)
    if low is not None and high is not None:
        return f"{low:.10g} to {high:.10g}"
    sides = ((">", entry.get("above")), ("≥", low), ("≤", high))
    return ", ".join(f"{sign} {bound:.10g}" for sign, bound in sides if bound is not None)


def _default(entry: dict[str, Any]) -> str:
    if entry["required"]:
        return "required"
    value = entry.get("default")
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if is_list(value):
        return f"`[{', '.join(f'{item:g}' for item in value)}]`"
    return "" if value in (None, "") else f"`{value:.10g}`" if isinstance(value, float) else f"`{value}`"
