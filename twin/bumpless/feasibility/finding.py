"""One thing about a mission that can't work, or is unlikely to."""

from dataclasses import asdict, dataclass
from typing import Literal

ERROR, WARNING = "error", "warning"  # can't work; unlikely, or not what was meant


@dataclass(frozen=True)
class Finding:
    """What is wrong, where, and what would work."""

    severity: Literal["error", "warning"]
    code: str  # "current_not_holdable"
    field: str  # of the mission: "legs[0].speed_mps"
    text: str  # why, in the vehicle's terms
    change: str = ""  # the nearest change that would work; "" where none is known

    def __str__(self) -> str:
        return f"{self.field}: {self.text}" + (f" {self.change}" if self.change else "")

    def as_dict(self) -> dict[str, str]:
        """For JSON."""
        return asdict(self)
