"""Compare Numba's flags by what was set.

Numba looks up each overload of each call by its compiler flags, and to compare two sets of flags it works out
all thirty options of both: a tenth of the first compilation. Flags in which the same was set are equal.
"""

from typing import Any

from numba.core.compiler import Flags


def compare_by_what_was_set() -> None:
    """Put a short way in front of Numba's comparison; where Numba looks different, nothing changes."""
    kind: Any = Flags
    if getattr(kind, "_compared_by_what_was_set", False) or not hasattr(kind(), "_values"):
        return
    at_length, number = kind.__eq__, hash(kind())

    def equal(self: Any, other: Any) -> Any:
        if type(other) is type(self) and self._values == other._values:
            return True
        return at_length(self, other)

    kind.__eq__ = equal
    kind.__hash__ = lambda self: number  # of the options' names, as Numba's own: the same for all flags
    kind._compared_by_what_was_set = True
