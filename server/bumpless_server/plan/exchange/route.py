"""What all foreign missions have in common: places to go to, and a word on everything else."""

from dataclasses import dataclass, field


class NotImportable(ValueError):
    """The file holds no way that could be flown, or is no such file; the text says what it is and why."""


@dataclass(frozen=True)
class Item:
    """One thing of a foreign file and what became of it."""

    what: str  # "item 3: DO_CHANGE_SPEED"
    carried: bool
    note: str = ""


@dataclass(frozen=True)
class Point:
    """A place to go to: latitude and longitude in deg, or north and east in m."""

    first: float
    second: float
    depth_m: float | None = None  # positive down; None: the file does not say
    speed_mps: float | None = None


@dataclass(frozen=True)
class Zone:
    """An outline of places like those of the points, to keep out of or inside."""

    inside: bool
    corners: tuple[tuple[float, float], ...]


@dataclass
class Route:
    """A foreign mission's way; `geographic` places are latitudes and longitudes."""

    kind: str  # "a QGroundControl plan"
    geographic: bool
    home: tuple[float, float] | None = None  # latitude and longitude of the local frame's origin
    points: list[Point] = field(default_factory=list)
    items: list[Item] = field(default_factory=list)
    title: str = ""
    zones: list[Zone] = field(default_factory=list)
    parts: tuple[str, ...] = ()  # ways that the file holds, where they have names and there may be several

    def carried(self, what: str, note: str = "") -> None:
        """Note something that came over."""
        self.items.append(Item(what, True, note))

    def left(self, what: str, note: str) -> None:
        """Note something that did not."""
        self.items.append(Item(what, False, note))


def depth_of(altitude_m: float) -> tuple[float | None, str]:
    """(depth, note) of an altitude above the surface; a place in the air has no depth."""
    if altitude_m > 0.0:
        return None, f"altitude {altitude_m:g} m is above the water: the depth is to be set"
    return abs(altitude_m), ""


def number(value: object, what: str) -> float:
    """A finite number of a file. Raises NotImportable."""
    try:
        found = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise NotImportable(f"{what} is {value!r}, not a number") from None
    if not abs(found) < 1e12:
        raise NotImportable(f"{what} is {value!r}, not a finite number")
    return found


def geographic(latitude: float, longitude: float, what: str) -> tuple[float, float]:
    """A place on the earth. Raises NotImportable."""
    if not (-90.0 <= latitude <= 90.0 and -180.0 <= longitude <= 180.0):
        raise NotImportable(f"{what}: {latitude:g}, {longitude:g} is no latitude and longitude")
    return latitude, longitude
