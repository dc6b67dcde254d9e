"""A vehicle is data: load its TOML file into frozen models, or say exactly what is wrong with it.

`vehicles/<id>.toml` holds body, actuators and sensors; `<id>.control.toml` beside it, if there is
one, holds the `[control]` tables. `Vehicle.text` is both, so that one text carries the whole vehicle.
"""

import re
import tomllib
from functools import lru_cache
from pathlib import Path
from typing import Any

from bumpless.config.capacity import MAX_ACTUATORS, MAX_FRAMES
from bumpless.config.declare import Broken, Unread, read
from bumpless.config.problems import Problem, ProblemsError
from bumpless.config.text import BOM, NotText, decoded, foreign_kind
from bumpless.config.vehicle.model import Document, Vehicle
from bumpless.config.vehicle.parts import Fin
from bumpless.config.vehicle.places import Places, beside
from bumpless.config.vehicle.shared import origin_of, with_shared_fields

FOLDER = Path(__file__).parents[1] / "vehicles"


class VehicleError(ProblemsError):
    """A vehicle file cannot be used; `problems` says why, field by field."""


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
    content, control_line = _text(path.read_bytes(), path.name), 0
    control = path.with_name(path.stem + ".control.toml")
    if control.is_file():
        content = content.rstrip("\r\n") + "\n\n"
        control_line = content.count("\n") + 1
        content += _text(control.read_bytes(), control.name).removeprefix(BOM)
    return parse_vehicle(content, path.name, control_line)


def parse_vehicle(content: bytes | str, source: str, control_line: int = 0) -> Vehicle:
    """A vehicle from the bytes or the text of its file; `source` names the file in problems.

    From line `control_line` on, if it is given, the text is that of the control file beside.
    The same text gives the same object: whoever edits a mission reads its vehicle with each letter typed.
    Raises: VehicleError with every problem, in the order of the file.
    """
    return _parsed(_text(content, source), source, control_line)


@lru_cache(maxsize=16)
def _parsed(text: str, source: str, control_line: int) -> Vehicle:
    tables = _tables(text, source, control_line)
    whole, broken = with_shared_fields(tables)
    try:
        document = read(Document, whole)
    except Unread as error:
        unmergeable = tuple(one.path.removesuffix(".type") + "." for one in broken)
        broken += [one for one in error.broken if not one.path.startswith(unmergeable)]
    else:
        broken += _rules(document)
        if not broken:
            return Vehicle(**vars(document), text=text, source=source, control_line=control_line)
    places = Places(text, source, control_line)
    problems = [places.problem(*one, at=origin_of(tables, one.path)) for one in broken]
    raise VehicleError(sorted(problems, key=lambda p: (p.file != source, p.line or 0, p.column or 0)))


def _text(content: bytes | str, source: str) -> str:
    kind = foreign_kind(content)
    if kind is not None:
        raise VehicleError([Problem(source, None, None, "", None, f"is {kind}, not a Bumpless vehicle")])
    try:
        return decoded(content, source)
    except NotText as error:
        raise VehicleError([error.problem]) from None


def _tables(text: str, source: str, control_line: int) -> dict[str, Any]:
    try:
        return tomllib.loads(text.removeprefix(BOM))
    except tomllib.TOMLDecodeError as error:
        place = re.search(r"at line (\d+), column (\d+)", str(error))
        lines = text.split("\n")
        line, column = (int(place[1]), int(place[2])) if place else (len(lines), len(lines[-1]) + 1)
        problem = Problem(source, line, column, "", None, f"is not TOML: {error}")
        raise VehicleError([beside(problem, control_line)]) from error
    except RecursionError:
        raise VehicleError([Problem(source, 1, 1, "", None, "is nested too deeply")]) from None


def _rules(document: Document) -> list[Broken]:
    """Rules between fields."""
    found, taken, count = list[Broken](), set[str](), 0
    for i, actuator in enumerate(document.actuators):
        names = {actuator.name, *(command.name for command in actuator.commands)}
        if names & taken:
            rule = "must be different from the other actuators' names"
            found.append(Broken(f"actuators[{i}].name", actuator.name, rule))
        taken |= names
        count += len(actuator.commands)
    if count > MAX_ACTUATORS:
        rule = f"must have {MAX_ACTUATORS} commands at most, they have {count}"
        found.append(Broken("actuators", None, rule))
    screws = {actuator.name for actuator in document.actuators if actuator.kind != "fin"}
    for i, actuator in enumerate(document.actuators):
        if isinstance(actuator, Fin) and actuator.wash and actuator.wash.screw not in screws:
            rule = f"must be a screw of this vehicle: {', '.join(sorted(screws)) or 'it has none'}"
            found.append(Broken(f"actuators[{i}].wash.screw", actuator.wash.screw, rule))
    for name in ("camera", "near_camera"):
        camera = getattr(document.sensors, name)
        if camera is not None and camera.range_max_m <= camera.range_min_m:
            found.append(Broken(f"sensors.{name}.range_max_m", camera.range_max_m, "must be > range_min_m"))
    camera = document.sensors.camera
    if camera.latency_s * camera.rate_hz > MAX_FRAMES - 2:
        rule = f"must be at most {(MAX_FRAMES - 2) / camera.rate_hz:g}: {MAX_FRAMES} frames on their way"
        found.append(Broken("sensors.camera.latency_s", camera.latency_s, rule))
    return found
