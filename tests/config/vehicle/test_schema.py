"""The published schema of vehicle files and their reader agree."""

import copy
import tomllib
from typing import Any

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.declare import Unread, read
from bumpless.config.formats import parameters_json_schema
from bumpless.config.parameters import as_dict, default_parameters
from bumpless.config.vehicle import FOLDER, load_vehicle, vehicle_names
from bumpless.config.vehicle.model import Document
from bumpless.config.vehicle.schema import vehicle_json_schema
from bumpless.config.vehicle.shared import with_shared_fields

SCHEMA = jsonschema.Draft202012Validator(vehicle_json_schema())
TREE: dict[str, Any] = tomllib.loads((FOLDER / "ts100.toml").read_text(encoding="utf-8"))
PLAIN = {**TREE, "actuators": with_shared_fields(TREE)[0]["actuators"]}
del PLAIN["actuator_types"]
JUNK: list[Any] = [
    None,
    True,
    0,
    0.0,
    -1,
    0.5,
    61,
    1e9,
    "",
    "fin",
    "X",
    [],
    [1],
    [0, 0, 0],
    [1, 2, 3],
    {},
    [{}],
]


def places(tree: Any) -> list[tuple[str | int, ...]]:
    keys = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    return [(key, *rest) for key, value in keys for rest in ((), *places(value))]


@pytest.mark.parametrize("name", vehicle_names())
def test_shipped_vehicles_satisfy_the_schemas(name: str) -> None:
    """Protects: an editor with the schema shows no fault in files that fly."""
    vehicle = load_vehicle(name)
    SCHEMA.validate(tomllib.loads(vehicle.text))
    parameters = jsonschema.Draft202012Validator(parameters_json_schema())
    parameters.validate(vehicle.control)
    parameters.validate(as_dict(default_parameters(vehicle)))
    assert not parameters.is_valid({"hover": {"kp": [1]}})
    assert not parameters.is_valid({"hoover": {}})


@given(
    st.sampled_from(places(PLAIN)),
    st.sampled_from(
        [None, True, 0, 0.0, -1, 0.5, 61, 1e9, "", "fin", "X", [], [1], [0, 0, 0], [1, 2, 3], {}, [{}]]
    ),
    st.booleans(),
)
def test_schema_and_reader_agree_on_any_change(path: tuple[Any, ...], value: Any, drop: bool) -> None:
    """Protects: the same verdict on each field, wherever one of them is changed or lost."""
    tree = copy.deepcopy(PLAIN)
    around: Any = tree
    for key in path[:-1]:
        around = around[key]
    if drop:
        del around[path[-1]]
    else:
        around[path[-1]] = value
    try:
        read(Document, tree)
        readable = True
    except Unread:
        readable = False
    assert SCHEMA.is_valid(tree) == readable, (path, value, drop)


def test_shared_fields_are_in_the_schema() -> None:
    """Protects: a type's table is checked field by field, and an actuator must be whole or name a type."""

    def verdict(change: Any) -> bool:
        tree = copy.deepcopy(TREE)
        change(tree)
        return SCHEMA.is_valid(tree)

    assert verdict(lambda tree: None)
    assert not verdict(lambda tree: tree["actuator_types"]["rudder"].update(span_m=-1))
    assert not verdict(lambda tree: tree["actuator_types"]["rudder"].update(nonsense=1))
    assert not verdict(lambda tree: tree["actuators"][0].pop("type"))
