"""What many fields of a mission have in common."""

from bumpless.config.declare import Number, Row
from bumpless.config.names import NED

Vector3 = tuple[float, float, float]
Vector6 = tuple[float, float, float, float, float, float]


def direction(label: str) -> Number:
    """A direction in the horizontal plane, from north over east."""
    return Number(label, "deg", -360.0, 360.0)


def position(label: str) -> Row:
    """A place in NED; depth is positive down and never above the water."""
    hints = ("", "", "depth is positive down")
    return Row(label, "m", (-1e5, -1e5, 0.0), (1e5, 1e5, 11000.0), names=NED, hints=hints)


def moment(label: str) -> Number:
    """A time of the mission."""
    return Number(label, "s", 0.0, 1e5)


def flow(label: str) -> Row:
    """A current, the way it flows."""
    return Row(label, "m/s", -5.0, 5.0, names=NED)
