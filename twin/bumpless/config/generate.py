"""What is made from the declarations and kept beside the sources: schemas and reference pages.

python -m bumpless.config.generate [--check]
"""

import json
import sys
from pathlib import Path
from typing import Any

from bumpless.config.declare.reference import tables
from bumpless.config.formats import MODELS, SCHEMAS

ROOT = Path(__file__).parents[3]
BESIDE = "twin/bumpless/config/vehicles"
NOTE = "<!-- Made by `make gen` from the declarations in twin/bumpless/config; edit those. -->"

MISSION = """\
A mission is a YAML file. Positions are NED (north, east, down) in metres; depth is positive down.
Numbers are decimal, with or without leading zeros (045 is 45). Fields marked required have no default.
What may stand in `parameters` is [a page of its own](parameters.md).
The JSON Schema is `missions/mission.schema.json`."""
VEHICLE = """\
A vehicle is a TOML file `<id>.toml`, with its control parameters in `<id>.control.toml` beside it.
Body axes: x forward, y starboard, z down. Fields that several actuators share stand once in
`[actuator_types.<type>]`, and each of those actuators says `type`.
What may stand in `control` is [a page of its own](parameters.md).
The JSON Schema is `vehicle.schema.json` beside the vehicles."""
PARAMETERS = """\
What the controller is tuned with: `[control.<section>]` in the vehicle's control file, `parameters:` in a
mission, `--set section.field=value` on the command line. What is marked live may change in flight.
The JSON Schema is `parameters.schema.json` beside the vehicles."""


def made() -> dict[str, str]:
    """Every generated file by its path from the root of the sources."""
    return {
        "missions/mission.schema.json": _json(SCHEMAS["mission"]()),
        f"{BESIDE}/vehicle.schema.json": _json(SCHEMAS["vehicle"]()),
        f"{BESIDE}/parameters.schema.json": _json(SCHEMAS["parameters"]()),
        "docs/reference/mission.md": _page("Mission files", MISSION, MODELS["mission"]),
        "docs/reference/vehicle.md": _page("Vehicle files", VEHICLE, MODELS["vehicle"]),
        "docs/reference/parameters.md": _page("Parameters", PARAMETERS, MODELS["parameters"]),
    }


def _json(schema: dict[str, Any]) -> str:
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _page(title: str, about: str, cls: type) -> str:
    return "\n".join([f"# {title}", "", NOTE, "", about, "", *tables(cls)]).rstrip("\n") + "\n"


def main(arguments: list[str]) -> int:
    """Write what is out of date; with --check say so and fail instead."""
    stale: list[str] = []
    for name, text in made().items():
        path = ROOT / name
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
            if "--check" not in arguments:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
    if stale and "--check" in arguments:
        print("Out of date, renew with `make gen`:", *stale, sep="\n  ", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
