"""What was found, written into the vehicle's file: numbers change, all else stays as its author wrote it."""

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from bumpless.config.text import BOM
from bumpless.config.toml_places import places_of
from bumpless.config.vehicle import Vehicle, parse_vehicle
from bumpless.config.vehicle.shared import origin_of
from bumpless.identify.scales import LIFT, THRUST, Scale

FIELDS = {THRUST: ("thrust_coefficient", "thrust_slope"), LIFT: ("lift_slope_per_rad",)}  # of the file
_NUMBER = re.compile(r"(?P<key>[\w\"'-]+\s*=\s*)(?P<number>[^\s,#}]+)(?P<comment>[ \t]*#[^\n]*)?")


@dataclass(frozen=True)
class Change:
    """One number of a vehicle's file."""

    path: str  # where it is written, such as actuator_types.vertical.thrust_coefficient
    before: float
    after: float
    factor: float


def changes(vehicle: Vehicle, factors: Mapping[Scale, float]) -> list[Change]:
    """The numbers that differ, in the order of the scales. Drag is no number of a file: it is told alone."""
    tables, found = tomllib.loads(vehicle.text.removeprefix(BOM)), dict[str, Change]()
    for scale, factor in factors.items():
        for i, field in _written(vehicle, scale):
            path = origin_of(tables, f"actuators[{i}].{field}")
            before = float(getattr(vehicle.actuators[i], field))
            found.setdefault(path, Change(path, before, float(f"{before * factor:.5g}"), factor))
    return list(found.values())


def _written(vehicle: Vehicle, scale: Scale) -> Iterator[tuple[int, str]]:
    names: list[Any] = [actuator.name for actuator in vehicle.actuators]
    for name in scale.names:
        for field in FIELDS[scale.what]:
            yield names.index(name), field


def learned_text(vehicle: Vehicle, factors: Mapping[Scale, float]) -> str:
    """The text of the vehicle with these changes; what its file said of their source is replaced."""
    body = vehicle.text.removeprefix(BOM)
    lines, places = body.split("\n"), places_of(body)
    for change in changes(vehicle, factors):
        row, column = places[change.path]
        line = lines[row - 1]
        head, rest = line[: column - 1], line[column - 1 :]
        said = f"  # learned in flight: {change.factor:.3f} of {change.before:g}"

        def other(match: re.Match[str], said: str = said, after: float = change.after) -> str:
            return match["key"] + f"{after:g}" + (said if match.end() == len(match.string) else "")

        lines[row - 1] = head + _NUMBER.sub(other, rest, count=1)
    return "\n".join(lines)


def learned(vehicle: Vehicle, factors: Mapping[Scale, float]) -> Vehicle:
    """The vehicle with what was found in its file."""
    return parse_vehicle(learned_text(vehicle, factors), vehicle.source, vehicle.control_line)
