"""What each number may be, as the screen asks for it: made from the declarations."""

from dataclasses import dataclass

from bumpless.config.declare import Number, Row, fields_of
from bumpless.config.parameters.model import Parameters

ACTUATORS = -1  # as a count: one number per command


@dataclass(frozen=True)
class Range:
    """Bounds of one number, both included, or of each number of a row (`count`)."""

    path: str  # "forward.q_diagonal"
    unit: str  # "1" for a number without one
    min: float
    max: float
    label: str
    count: int  # 0: one number; 6: one per wrench component; ACTUATORS: one per command
    live: bool  # may change during a mission


def _ranges() -> tuple[Range, ...]:
    found: list[Range] = []
    for section, part in fields_of(Parameters).items():
        for key, field in fields_of(part.kind).items():
            note = field.note
            if not isinstance(note, Number | Row):
                continue
            count = 0 if isinstance(note, Number) else len(note.names) or ACTUATORS
            assert isinstance(note.min, int | float) and isinstance(note.max, int | float)
            path, unit = f"{section}.{key}", note.unit or "1"
            found.append(Range(path, unit, note.min, note.max, note.label, count, note.live))
    return tuple(found)


RANGES: tuple[Range, ...] = _ranges()
