"""pydantic's complaints in this project's words, with their place in the file."""

import difflib
from collections.abc import Iterable
from typing import Any

from pydantic import ValidationError

from bumpless.config.mission.document import Document


def refuse(document: Document, error: ValidationError, prefix: str = "", known: Iterable[str] = ()) -> None:
    """Add each complaint of `error` to the document; its places lie under `prefix`."""
    for one in error.errors(include_url=False):
        path = path_of(one["loc"], prefix)
        value = None if one["type"] == "missing" else one["input"]
        document.refuse(path, shown(value), _rule(one, known))


def path_of(place: Iterable[str | int], prefix: str = "") -> str:
    """`tune.search.low` or `missions[0]` from pydantic's place."""
    path = prefix
    for step in place:
        path += f"[{step}]" if isinstance(step, int) else f".{step}" if path else str(step)
    return path


def shown(value: Any) -> Any:
    """What a problem prints of a value."""
    return "{...}" if isinstance(value, dict) else list(value) if isinstance(value, tuple) else value


def unknown(name: str, known: Iterable[str]) -> str:
    """What is said of a name that does not exist."""
    names = list(known)
    near = difflib.get_close_matches(name, names, n=1, cutoff=0.5)
    return f"unknown; did you mean {near[0]}?" if near else f"unknown; one of {', '.join(names)}"


def _rule(one: Any, known: Iterable[str]) -> str:
    match one["type"]:
        case "missing":
            return "is missing"
        case "extra_forbidden":
            return unknown(str(one["loc"][-1]), known)
        case "value_error":
            return str(one["ctx"]["error"])
    return one["msg"].replace("Input should", "must").replace("should", "must")
