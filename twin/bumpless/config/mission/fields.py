"""How a mission's fields say what they may hold: one note per field, read by parser and schema."""

from dataclasses import dataclass

from bumpless.contract.names import MISSION

Vector3 = tuple[float, float, float]
Vector6 = tuple[float, float, float, float, float, float]


@dataclass(frozen=True)
class Number:
    """A number between `min` and `max`, both included, in `unit`."""

    about: str
    min: float
    max: float
    unit: str = ""


@dataclass(frozen=True)
class Text:
    """A text; of the form `pattern` (a regular expression) if there is one, which `rule` words."""

    about: str
    pattern: str = ""
    rule: str = "must be letters, digits, - and _, at most 64 of them"


@dataclass(frozen=True)
class Row:
    """A row of numbers, each with its name and bounds."""

    about: str
    names: tuple[str, ...]
    min: tuple[float, ...]
    max: tuple[float, ...]
    unit: str


@dataclass(frozen=True)
class Entries:
    """How many entries a list may have."""

    about: str
    min: int
    max: int


@dataclass(frozen=True)
class Part:
    """A part with fields of its own."""

    about: str


@dataclass(frozen=True)
class Internal:
    """Not a field of the file."""


def unit_of(note: object) -> str:
    """Unit of a field's numbers; "" when it has none."""
    return getattr(note, "unit", "")


NAME = MISSION.pattern


def position(about: str) -> Row:
    """A place in NED; depth is positive down and never above the water."""
    return Row(about, ("north", "east", "down"), (-1e5, -1e5, 0.0), (1e5, 1e5, 11000.0), "m")


def offset(about: str) -> Row:
    """A distance from a place, in NED."""
    return Row(about, ("north", "east", "down"), (-100.0,) * 3, (100.0,) * 3, "m")


def velocity(about: str) -> Row:
    """A velocity of water in NED."""
    return Row(about, ("north", "east", "down"), (-5.0,) * 3, (5.0,) * 3, "m/s")


def wrench(about: str) -> Row:
    """A generalised force in body axes."""
    return Row(about, ("X", "Y", "Z", "K", "M", "N"), (-1e4,) * 6, (1e4,) * 6, "N and N·m")
