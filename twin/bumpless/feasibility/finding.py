"""One thing about a mission that can't work, or is unlikely to, and what would mend it."""

from dataclasses import asdict, dataclass
from typing import Any, Literal

HARD, SOFT = "hard", "soft"  # can't work, blocks the start; unlikely or not what was meant, asks first

Value = float | str | tuple[float, ...] | None


@dataclass(frozen=True)
class Mend:
    """A change of one field that would mend a finding, ready to be made."""

    path: str  # of the field in the mission file: "target.heading_deg", "legs[0].to_ned_m"
    value: Value  # the new one, in the file's unit; None: take the field, or that entry of a list, out
    words: str  # what to call it, short: "Approach with 090°"


@dataclass(frozen=True)
class Finding:
    """What is wrong, where, and what would work."""

    severity: Literal["hard", "soft"]
    code: str  # "current_not_holdable"
    field: str  # of the mission: "legs[0].speed_mps"
    text: str  # why, in the vehicle's terms
    change: str = ""  # the nearest change that would work, in words; "" where none is known
    mends: tuple[Mend, ...] = ()  # the same as data, best first

    @property
    def blocks(self) -> bool:
        """Whether the mission must not be started as it is."""
        return self.severity == HARD

    @property
    def word(self) -> str:
        """For people: "error" where it blocks, else "warning"."""
        return "error" if self.blocks else "warning"

    def __str__(self) -> str:
        return f"{self.field}: {self.text}" + (f" {self.change}" if self.change else "")

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)
