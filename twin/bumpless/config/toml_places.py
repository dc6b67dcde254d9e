"""Where a TOML text sets each of its fields, so that a problem can name line and column.

`tomllib` reads the values and says whether the text is TOML at all, but forgets the places, and no kept
library for Python gives them. So this scanner walks over a text that is known to be TOML, when there is a
problem to place.
"""

import re
import tomllib
from bisect import bisect_right

Place = tuple[int, int]

_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_SPACE = re.compile(r"[ \t]*")
_STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"""(?:"{0,2}(?!"))|' r"'''.*?'''(?:'{0,2}(?!'))|" r'"(?:\\.|[^"\\])*"|' r"'[^']*'",
    re.DOTALL,
)
_BARE = re.compile(r"[\w-]+")
_ATOM = re.compile(r"[^,\]}#\r\n]*")  # a number, a date, true or false


def places_of(text: str) -> dict[str, Place]:
    """Path of each field, table and entry of a list -> its line and column, from 1.

    Inline tables, dotted and quoted keys are followed; entries count from 0.
    """
    return _Scanner(text).walk()


class _Scanner:
    def __init__(self, text: str) -> None:
        self._text, self._at = text, 0
        self._ends = [match.end() for match in re.finditer("\n", text)]
        self._places: dict[str, Place] = {}
        self._lengths: dict[str, int] = {}  # of arrays of tables

    def walk(self) -> dict[str, Place]:
        table = ""
        self._skip(_BLANK)
        while self._at < len(self._text):
            if self._text[self._at] == "[":
                table = self._header()
            else:
                self._pair(table)
            self._skip(_BLANK)
        return self._places

    def _header(self) -> str:
        start, many = self._at, self._text.startswith("[[", self._at)
        self._at += 2 if many else 1
        self._skip(_SPACE)
        *outer, last = (key for key, _ in self._keys())
        self._at += 2 if many else 1
        path = ""
        for key in outer:
            path = self._last(_join(path, key))
        path = _join(path, last)
        if many:
            self._note(path, start)
            self._lengths[path] = self._lengths.get(path, 0) + 1
            path = self._last(path)
        self._note(path, start)
        return path

    def _last(self, path: str) -> str:
        """The entry that a header means when it names an array of tables: the last so far."""
        return f"{path}[{self._lengths[path] - 1}]" if path in self._lengths else path

    def _pair(self, table: str) -> None:
        path = table
        for key, at in self._keys():
            path = _join(path, key)
            self._note(path, at)
        self._at += 1  # the equals sign
        self._skip(_SPACE)
        self._value(path)

    def _keys(self) -> list[tuple[str, int]]:
        """The parts of a dotted key with their places; what follows them is next."""
        parts: list[tuple[str, int]] = []
        while True:
            self._skip(_SPACE)
            at, quoted = self._at, self._text[self._at] in "\"'"
            word = self._skip(_STRING if quoted else _BARE)
            parts.append((tomllib.loads(f"key = {word}")["key"] if quoted else word, at))
            self._skip(_SPACE)
            if self._text[self._at] != ".":
                return parts
            self._at += 1

    def _value(self, path: str) -> None:
        mark = self._text[self._at]
        if mark in "[{":
            self._inside(path, "]" if mark == "[" else "}")
        else:
            self._skip(_STRING if mark in "\"'" else _ATOM)

    def _inside(self, path: str, end: str) -> None:
        """Entries of a list or fields of an inline table."""
        self._at += 1
        count = 0
        self._skip(_BLANK)
        while self._text[self._at] != end:
            if end == "}":
                self._pair(path)
            else:
                self._note(f"{path}[{count}]", self._at)
                self._value(f"{path}[{count}]")
            count += 1
            self._skip(_BLANK)
            self._at += self._text[self._at] == ","
            self._skip(_BLANK)
        self._at += 1

    def _skip(self, pattern: re.Pattern[str]) -> str:
        match = pattern.match(self._text, self._at)
        assert match is not None
        self._at = match.end()
        return match[0]

    def _note(self, path: str, at: int) -> None:
        """The place of a field is where it is first named."""
        line = bisect_right(self._ends, at)
        column = at - (self._ends[line - 1] if line else 0) + 1
        self._places.setdefault(path, (line + 1, column))


def _join(path: str, key: str) -> str:
    return f"{path}.{key}" if path else key
