"""A vehicle is data: load its TOML file into frozen dataclasses, or say exactly what is wrong with it.

`twin/vehicles/<id>.toml` holds body, actuators and sensors; `<id>.control.toml` beside it, if there is
one, holds the `[control]` tables. `Vehicle.text` is both, so that one text carries the whole vehicle.
"""

import hashlib
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.problems import Problem, ProblemsError
from bumpless.config.vehicle.fields import Collector, number, read, some_of, text
from bumpless.config.vehicle.lines import lines_of
from bumpless.config.vehicle.parts import (
    ACTUATORS,
    Actuator,
    Appendage,
    Command,
    Environment,
    Hull,
    Mass,
    MyringHull,
    TabulatedHull,
)
from bumpless.config.vehicle.sensors import Camera, DepthSensor, Dvl, Ins, Sensors

FOLDER = Path(__file__).parents[1] / "vehicles"
WRENCH = ("X", "Y", "Z", "K", "M", "N")
HULLS = {"myring": MyringHull, "tabulated": TabulatedHull}
SENSORS = {"ins": Ins, "dvl": Dvl, "depth": DepthSensor, "camera": Camera}
HEAD = ("id", "name", "control_period_s", "controllable")
TABLES = ("environment", "mass", "hull", "appendages", "actuator_types", "actuators", "sensors", "control")


class VehicleError(ProblemsError):
    """A vehicle file cannot be used; `problems` says why, field by field."""


@dataclass(frozen=True)
class _Head:
    id: str = text()
    name: str = text()
    control_period_s: float = number(above=0, high=1)
    controllable: tuple[str, ...] = some_of(*WRENCH)  # wrench components that the actuators shall serve


@dataclass(frozen=True)
class Vehicle:
    """One vehicle. Actuators stand in the file's order, and their commands one after the other: that is the
    order of u everywhere."""

    id: str
    name: str
    control_period_s: float
    controllable: tuple[str, ...]
    environment: Environment
    mass: Mass
    hull: Hull
    appendages: tuple[Appendage, ...]
    actuators: tuple[Actuator, ...]
    sensors: Sensors
    control: dict[str, Any]
    text: str
    sha256: str
    source: str

    @property
    def commands(self) -> tuple[Command, ...]:
        """Every command of every actuator, in the order of u."""
        return tuple(command for actuator in self.actuators for command in actuator.commands)

    def slots(self, kind: str) -> list[int]:
        """Places in u of the commands of all actuators of a kind ("fin", "thruster")."""
        return [
            i for i, owner in enumerate(a for a in self.actuators for _ in a.commands) if owner.kind == kind
        ]


def vehicle_names() -> tuple[str, ...]:
    """Ids of the vehicles that ship with Bumpless, sorted."""
    return tuple(sorted(p.stem for p in FOLDER.glob("*.toml") if not p.stem.endswith(".control")))


def load_vehicle(name_or_path: str | Path) -> Vehicle:
    """Load a shipped vehicle by its id, or one by the path of its TOML file.

    Raises: VehicleError when there is no such file or it breaks a rule.
    """
    path = Path(name_or_path)
    if path.suffix != ".toml":
        path = FOLDER / f"{name_or_path}.toml"
    if not path.is_file():
        rule = "no such vehicle; there are " + ", ".join(vehicle_names())
        raise VehicleError([Problem(str(name_or_path), None, None, "", None, rule)])
    content = path.read_text(encoding="utf-8")
    control = path.with_name(path.stem + ".control.toml")
    if control.is_file():
        content = content.rstrip("\n") + "\n\n" + control.read_text(encoding="utf-8")
    return parse_vehicle(content, path.name)


def parse_vehicle(content: str, source: str) -> Vehicle:
    """A vehicle from TOML text; `source` names the text in problems.

    Raises: VehicleError with every problem found.
    """
    table = _table(content, source)
    found = Collector(source, lines_of(content), [])
    for name in table:
        if name not in HEAD and name not in TABLES:
            found.add(name, None, "is not a known table or field; known are " + ", ".join(HEAD + TABLES))
    head = read(_Head, {k: v for k, v in table.items() if k in HEAD}, "", found)
    environment = read(Environment, table.get("environment"), "environment", found)
    mass = read(Mass, table.get("mass"), "mass", found)
    hull = _by_kind(HULLS, table.get("hull"), "hull", found)
    appendages = _appendages(table.get("appendages", []), found)
    actuators = _actuators(table, found)
    sensors = _sensors(table.get("sensors"), found)
    control = table.get("control", {})
    if not isinstance(control, dict):
        found.add("control", control, "must be a table")
    if found.problems:
        raise VehicleError(found.problems)
    assert head and environment and mass and hull and sensors  # read() returns None only with a problem
    return Vehicle(
        id=head.id,
        name=head.name,
        control_period_s=head.control_period_s,
        controllable=head.controllable,
        environment=environment,
        mass=mass,
        hull=hull,
        appendages=tuple(appendages),
        actuators=tuple(actuators),
        sensors=sensors,
        control=control,
        text=content,
        sha256=hashlib.sha256(content.encode()).hexdigest(),
        source=source,
    )


def _table(content: str, source: str) -> dict[str, Any]:
    try:
        return tomllib.loads(content)
    except tomllib.TOMLDecodeError as error:
        place = re.search(r"at line (\d+), column (\d+)", str(error))
        line, column = (int(place[1]), int(place[2])) if place else (None, None)
        raise VehicleError([Problem(source, line, column, "", None, f"is not TOML: {error}")]) from error


def _by_kind(kinds: dict[str, type], table: Any, path: str, found: Collector) -> Any:
    kind = table.get("kind") if isinstance(table, dict) else None
    if isinstance(table, dict) and (not isinstance(kind, str) or kind not in kinds):
        found.add(f"{path}.kind", kind, "must be one of " + ", ".join(kinds))
        return None
    return read(kinds.get(kind or "", next(iter(kinds.values()))), table, path, found)


def _appendages(entries: Any, found: Collector) -> list[Appendage]:
    if not isinstance(entries, list):
        found.add("appendages", entries, "must be tables")
        return []
    parts = [read(Appendage, entry, f"appendages[{i}]", found) for i, entry in enumerate(entries)]
    return [part for part in parts if part]


def _actuators(table: dict[str, Any], found: Collector) -> list[Actuator]:
    entries, types = table.get("actuators", []), table.get("actuator_types", {})
    if not isinstance(entries, list) or not 1 <= len(entries) <= MAX_ACTUATORS:
        found.add("actuators", None, f"must be 1 to {MAX_ACTUATORS} tables")
        return []
    if not isinstance(types, dict) or not all(isinstance(common, dict) for common in types.values()):
        found.add("actuator_types", None, "must hold tables")
        return []
    actuators: list[Actuator] = []
    for i, entry in enumerate(entries):
        path = f"actuators[{i}]"
        common = entry.get("type") if isinstance(entry, dict) else None
        if common is not None:  # fields that several actuators share stand once, in [actuator_types.<type>]
            if not isinstance(common, str) or common not in types:
                found.add(f"{path}.type", common, "must name a table of actuator_types")
                continue
            entry = types[common] | {k: v for k, v in entry.items() if k != "type"}
        actuator = _by_kind(ACTUATORS, entry, path, found)
        if actuator is None:
            continue
        taken = {name for a in actuators for name in (a.name, *(c.name for c in a.commands))}
        if taken & {actuator.name, *(c.name for c in actuator.commands)}:
            found.add(f"{path}.name", actuator.name, "must be different from the other actuators' names")
        if not any(actuator.direction):
            found.add(f"{path}.direction", list(actuator.direction), "must not be 0")
        actuators.append(actuator)
    count = sum(len(actuator.commands) for actuator in actuators)
    if count > MAX_ACTUATORS:
        found.add("actuators", None, f"must have {MAX_ACTUATORS} commands at most, they have {count}")
    return actuators


def _sensors(table: Any, found: Collector) -> Sensors | None:
    if not isinstance(table, dict):
        found.add("sensors", None, "is missing")
        return None
    for name in table:
        if name not in SENSORS:
            found.add(f"sensors.{name}", None, "is not a known sensor; known are " + ", ".join(SENSORS))
    parts = {name: read(kind, table.get(name), f"sensors.{name}", found) for name, kind in SENSORS.items()}
    camera = parts["camera"]
    if isinstance(camera, Camera) and camera.range_max_m <= camera.range_min_m:
        found.add("sensors.camera.range_max_m", camera.range_max_m, "must be > range_min_m")
    return Sensors(**parts) if all(parts.values()) else None  # type: ignore[arg-type]
