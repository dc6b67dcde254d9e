"""What names may look like: vehicles, missions, files and runs become parts of keys, paths and addresses."""

import re
from dataclasses import dataclass


class BadName(ValueError):
    """A name that breaks its rule; what it names, the name and the rule are in the text."""


@dataclass(frozen=True)
class NameRule:
    """A kind of name: the pattern that the whole name must match, and the same in words."""

    pattern: str
    words: str

    def allows(self, name: str) -> bool:
        """Whether `name` keeps the rule."""
        return re.fullmatch(self.pattern, name) is not None

    def check(self, name: str, what: str) -> str:
        """`name`, or BadName that says of `what` which rule it breaks."""
        if not self.allows(name):
            raise BadName(f"{what} {name!r}: must be {self.words}")
        return name


VEHICLE = NameRule(r"[a-z0-9][a-z0-9_-]{0,31}", "1 to 32 of a-z, 0-9, '-' and '_', first a letter or digit")
MISSION = NameRule(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}", "1 to 64 of letters, digits, '-' and '_'")
FILE = NameRule(
    r"(?!.*\.$)[A-Za-z0-9][A-Za-z0-9._-]{0,63}",
    "1 to 64 of letters, digits, '-', '_' and '.', first a letter or digit",
)
RUN = NameRule(
    r"(?!.*\.$)[A-Za-z0-9][A-Za-z0-9._-]{0,127}",
    "1 to 128 of letters, digits, '-', '_' and '.', first a letter or digit",
)
