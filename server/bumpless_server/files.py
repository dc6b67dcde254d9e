"""Names that people give to uploaded files: safe in a path, in an address and on every system."""

import re

RULE = "1 to 64 of letters, digits, '-', '_' and '.', first a letter or digit"
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,63}")


class BadName(ValueError):
    """A name that breaks the rule; `value` and the rule are in the text."""


def checked_name(name: str, *endings: str) -> str:
    """`name` without its ending (one of `endings`), if it may name a file. Raises BadName."""
    for ending in endings:
        name = name.removesuffix(ending)
    if not _NAME.fullmatch(name) or name.endswith("."):
        raise BadName(f"name = {name!r}; must be {RULE}")
    return name
