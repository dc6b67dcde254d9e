"""YAML as plain values that know their place, so that every complaint can name line and column.

Scalars mean what the YAML 1.2 core schema says, whatever the parser would make of them: numbers are decimal,
with or without leading zeros (045 is 45), but for 0o17 (octal) and 0x1F (hexadecimal); 1_000, 1:30, 0b1 and
yes are texts. Anchors, aliases and tags are not used.
"""

import math
import re
from collections.abc import Iterator
from typing import Any, cast

import yaml
from yaml.events import (
    AliasEvent,
    DocumentStartEvent,
    MappingEndEvent,
    MappingStartEvent,
    ScalarEvent,
    SequenceEndEvent,
)

from bumpless.config.plain import is_row
from bumpless.config.problems import Problem

LARGEST_FILE = 131_072  # characters: 511 legs with a comment each have room
_DEEPEST = 6
_LARGEST_BITS = 1024  # of a whole number: a larger one has no place among floats and counts as infinite
_DEEPEST_FLOW = 50  # brackets and indicators in a row that cost YAML scanners more than linear time
_HALF_CHARACTER = re.compile("[\ud800-\udfff]")
_HALF = "holds half of a character (a surrogate), which no text may"
_NOWHERE = "\0"  # path of what has no place of its own
_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # libyaml: thirty times as fast

_INT = re.compile(r"[-+]?[0-9]+")
_BASED = re.compile(r"0o[0-7]+|0x[0-9a-fA-F]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_WORDS: dict[str, float | None] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **{f"{sign}{word}": float(f"{sign}inf") for sign in ("", "-", "+") for word in (".inf", ".Inf", ".INF")},
    **dict.fromkeys((".nan", ".NaN", ".NAN"), math.nan),
}


class _Refused(Exception):
    """A text that is not read any further, with the place and the rule."""

    def __init__(self, mark: Any, rule: str) -> None:
        self.place, self.rule = (_place(mark) if mark else (1, 1)), rule


class YamlText:
    """A parsed file: its plain `value`, the place of each field, and the problems found so far.

    `value` is None when the text holds no named fields, or was refused.
    """

    def __init__(self, text: str, source: str) -> None:
        self.source = source
        self.problems: list[Problem] = []
        self.places: dict[str, tuple[int, int]] = {"": (1, 1)}
        self.value: dict[str, Any] | None = None
        try:
            self.value = self._document(text)
        except _Refused as refused:
            self.problems = [Problem(source, *refused.place, "", None, refused.rule)]
        except yaml.MarkedYAMLError as error:
            reason = " ".join(str(part) for part in (error.context, error.problem) if part)
            rule = f"not valid YAML: {reason}" if "Unicode character escape" not in reason else _HALF
            place = _place(error.problem_mark or error.context_mark)
            self.problems = [Problem(source, *place, "", None, rule)]
        except yaml.YAMLError as error:
            self.problems = [Problem(source, 1, 1, "", None, f"not valid YAML: {str(error).splitlines()[0]}")]

    def _document(self, text: str) -> dict[str, Any]:
        if len(text) > LARGEST_FILE:
            raise _Refused(None, f"the file is longer than {LARGEST_FILE} characters")
        if _open_brackets(text) > _DEEPEST_FLOW:
            raise _Refused(None, "is nested too deeply")
        events: Iterator[Any] = iter(cast("Any", yaml).parse(text, _LOADER))
        found = [event for event in (next(events), next(events)) if isinstance(event, DocumentStartEvent)]
        first = next(events) if found else None
        if not isinstance(first, MappingStartEvent):
            raise _Refused(
                first.start_mark if first else None, "must hold named fields such as `name: docking`"
            )
        value = self._plain(first, events, "", 1)
        next(events)  # the document's end
        second = next(events)
        if isinstance(second, DocumentStartEvent):
            raise _Refused(second.start_mark, "not valid YAML: a second document in one file")
        return value

    def _plain(self, event: Any, events: Iterator[Any], path: str, depth: int) -> Any:
        """The value that begins with `event`, read from `events`.

        What could make reading endless is refused at once: aliases, and nesting that no mission has.
        """
        if isinstance(event, AliasEvent) or event.anchor is not None:
            raise _Refused(event.start_mark, "anchors and aliases are not used in mission files")
        if event.tag is not None and event.implicit not in (True, (True, False), (False, True)):
            raise _Refused(event.start_mark, "tags are not used in mission files")
        if isinstance(event, ScalarEvent):
            if _HALF_CHARACTER.search(event.value):
                raise _Refused(event.start_mark, _HALF)
            return event.value if event.style else scalar(event.value)
        if depth > _DEEPEST:
            raise _Refused(event.start_mark, "is nested too deeply")
        if isinstance(event, MappingStartEvent):
            return self._mapping(events, path, depth)
        items: list[Any] = []
        while not isinstance(inner := next(events), SequenceEndEvent):
            at = f"{path}[{len(items)}]"
            self.places[at] = _place(inner.start_mark)
            items.append(self._plain(inner, events, at, depth + 1))
        return items

    def _mapping(self, events: Iterator[Any], path: str, depth: int) -> dict[str, Any]:
        """Named fields; a second one of the same name is a problem at its own place."""
        found: dict[str, Any] = {}
        while not isinstance(named := next(events), MappingEndEvent):
            if not isinstance(named, ScalarEvent):
                raise _Refused(named.start_mark, "must be the name of a field")
            self._plain(named, events, _NOWHERE, depth)
            key = named.value
            inner = f"{path}.{key}" if path else key
            if key not in found:
                self.places[inner] = _place(named.start_mark)
                found[key] = self._plain(next(events), events, inner, depth + 1)
                continue
            value = shown(self._plain(next(events), events, _NOWHERE, depth + 1))
            rule = f"appears twice; first on line {self.places[inner][0]}"
            self.problems.append(Problem(self.source, *_place(named.start_mark), inner, value, rule))
        return found

    def refuse(self, path: str, value: Any, rule: str) -> None:
        """Add a problem at the place of `path`, or of the nearest part around it."""
        around = self._around(path)
        value = "null" if value is None and around == path != "" else shown(value)
        self.problems.append(Problem(self.source, *self.places[around], path, value, rule))

    def said(self, path: str) -> Any:
        """What stands at `path`, as a problem shows it; None where nothing does."""
        if path not in self.places:
            return None
        part: Any = self.value
        for key in re.findall(r"[^.\[\]]+", path):
            part = part[int(key) if key.isdecimal() else key]
        return shown(part)

    def place_of(self, path: str) -> tuple[int, int]:
        """(line, column), both 1-based, of `path`, or of the nearest part around it."""
        return self.places[self._around(path)]

    def _around(self, path: str) -> str:
        while path not in self.places:
            path = path[: max(path.rfind("."), path.rfind("["), 0)]
        return path


def _place(mark: Any) -> tuple[int, int]:
    return mark.line + 1, mark.column + 1


def _open_brackets(text: str) -> int:
    """How deep brackets nest at most; strings and comments are not told apart, the limit is generous."""
    deepest = depth = 0
    for mark in re.findall(r"[\[\]{}]|(?:[-?] ){2,}", text):
        if len(mark) > 1:
            deepest = max(deepest, len(mark) // 2)
            continue
        depth = depth + 1 if mark in "[{" else max(depth - 1, 0)
        deepest = max(deepest, depth)
    return deepest


def scalar(value: str) -> Any:
    """What a plain scalar means by the YAML 1.2 core schema; text when it is nothing else."""
    if value in _WORDS:
        return _WORDS[value]
    if _INT.fullmatch(value) and len(value) < _LARGEST_BITS:
        number = int(value)
    elif _BASED.fullmatch(value):
        number = int(value, 0)
    else:
        return float(value) if _INT.fullmatch(value) or _FLOAT.fullmatch(value) else value
    return number if number.bit_length() < _LARGEST_BITS else math.inf if number > 0 else -math.inf


def shown(value: Any) -> Any:
    """What a problem prints for a value."""
    if isinstance(value, dict):
        return "{...}"
    if is_row(value):
        return [shown(item) for item in value[:7]]
    return value
