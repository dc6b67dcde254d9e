"""Where a TOML text sets each of its fields, so that problems can name a line."""

import re

_ARRAY = re.compile(r"^\s*\[\[\s*([\w.\-]+)\s*\]\]")
_TABLE = re.compile(r"^\s*\[\s*([\w.\-]+)\s*\]")
_KEY = re.compile(r"^\s*([\w\-]+)\s*=")


def lines_of(content: str) -> dict[str, int]:
    """Path of each key and table header -> its line, from 1; arrays of tables count from 0.

    Keys inside inline tables and dotted keys are not followed: their problems carry no line.
    """
    lines: dict[str, int] = {}
    counts: dict[str, int] = {}
    prefix = ""
    for at, line in enumerate(content.splitlines(), start=1):
        if header := _ARRAY.match(line):
            name = header[1]
            prefix = f"{name}[{counts.get(name, 0)}]"
            counts[name] = counts.get(name, 0) + 1
        elif header := _TABLE.match(line):
            prefix = header[1]
        elif key := _KEY.match(line):
            lines[f"{prefix}.{key[1]}" if prefix else key[1]] = at
            continue
        else:
            continue
        lines[prefix] = at
    return lines
