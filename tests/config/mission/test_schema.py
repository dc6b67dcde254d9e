"""The published schema and the parser agree about what a mission is."""

import copy
import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ruamel.yaml import YAML

from bumpless.config.declare import Unread, read
from bumpless.config.declare.catalogue import catalogue
from bumpless.config.mission import MissionError, mission_json_schema, parse_mission
from bumpless.config.mission.model import Document
from bumpless.config.parameters import ParameterError, default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle, load_vehicle

FOLDER = Path(__file__).parents[3] / "missions"


def valid(text: str) -> bool:
    document: Any = YAML(typ="safe", pure=True).load(text)
    return jsonschema.Draft202012Validator(mission_json_schema()).is_valid(document)


def test_the_published_schema_is_up_to_date() -> None:
    """Refresh it with: bumpless validate --schema > missions/mission.schema.json"""
    published = json.loads((FOLDER / "mission.schema.json").read_text(encoding="utf-8"))
    assert published == mission_json_schema()
    jsonschema.Draft202012Validator.check_schema(published)


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.yaml")), ids=lambda path: path.stem)
def test_shipped_missions_satisfy_the_schema(path: Path) -> None:
    """An editor with the schema shows no fault in files that fly."""
    assert valid(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    "change",
    [
        ("[22, 0, 2.5]", "[22, 0, -2.5]"),
        ("duration_s: 60", "duration_s: 60 s"),
        ("duration_s: 60", "duration_s: 0"),
        ("name: short", "name: a b"),
        ("version: 1", "version: 2"),
        ("version: 1", "version: 1\nwhatever: 2"),
        ("version: 1", "version: 1\nfaults: [{actuator: x, at_s: 1, effectiveness: 2}]"),
        ("version: 1", "version: 1\nparameters: {hover: {lambda: 0}}"),
        ("version: 1", "version: 1\nparameters: {allocation: {solver: magic}}"),
        ("version: 1", "version: 1\nparameters: {hover: {kp: [1]}}"),
        (", standoff_m: 1.5", ""),
        ("standoff_m: 1.5", "standoff_m: 1.5, true_offset_ned_m: [1, 2]"),
        ("standoff_m: 1.5", "standoff_m: 1.5, true_offset_ned_m: [0, 0, 200]"),
        ("0.7", "[0.7]"),
    ],
)
def test_schema_and_parser_refuse_the_same(good: str, ts100: Vehicle, change: tuple[str, str]) -> None:
    """What concerns a single field is in both; rules between fields are the parser's alone."""
    text = good.replace(*change)
    assert valid(good)
    assert not valid(text)
    with pytest.raises(MissionError):
        parse_mission(text, vehicle=ts100)


WHOLE: dict[str, Any] = {
    "version": 1,
    "name": "whole",
    "vehicle": "ts100",
    "duration_s": 60,
    "title": "All fields",
    "seed": 3,
    "start": {"position_ned_m": [0, 0, 2], "heading_deg": 0, "speed_mps": 0.5},
    "legs": [{"to_ned_m": [20, 0, 2.5], "speed_mps": 0.7}],
    "target": {
        "position_ned_m": [22, 0, 2.5],
        "heading_deg": 90,
        "standoff_m": 3.0,
        "dock": {
            "entry_before_marker_m": 1.4,
            "entry_radius_m": 0.4,
            "tube_radius_m": 0.13,
            "cone_length_m": 0.6,
            "tube_length_m": 0.4,
            "capture_depth_m": 0.85,
            "friction": 0.1,
        },
        "motion": {"amplitude_ned_m": [0, 0.1, 0.1], "period_s": 8},
    },
    "actuator_flow": True,
    "environment": {
        "current_ned_mps": [0.1, 0, 0],
        "current_variation": {"std_mps": 0.01, "time_constant_s": 30},
        "wave": {"height_m": 0.1, "period_s": 4, "direction_deg": 10, "second_order": True},
        "current_profile": [{"depth_m": 3, "current_ned_mps": [0.1, 0, 0]}],
        "shelter": {"width_m": 0.5, "drag_coefficient": 0.9, "growth": 0.05, "turbulence": 0.2},
        "water_depth_m": 60,
        "beam_attenuation_per_m": 1.0,
    },
    "sensors": {
        "noise_scale": 2,
        "detection": {"range_max_m": 9, "latency_s": 0.2},
        "outages": [{"from_s": 1, "to_s": 2}],
        "ins": {"heading_drift_degprth": 0.5},
        "dvl": {"scale_error": 0.01, "altitude_max_m": 50},
        "dvl_outages": [{"from_s": 1, "to_s": 2, "water_track": False}],
        "near_camera": {
            "position_m": [1, 0, 0],
            "pitch_down_deg": 20,
            "field_of_view_half_deg": 60,
            "range_min_m": 0.1,
            "range_max_m": 2,
            "field_of_view": "cone",
        },
        "usbl": {
            "rate_hz": 1,
            "position_m": [1, 0, 0],
            "range_max_m": 100,
            "range_noise_m": 0.1,
            "angle_noise_deg": 1,
        },
    },
    "faults": [{"actuator": "n_p", "at_s": 3, "effectiveness": 0.5}],
    "mishaps": [{"at_s": 3, "what": "battery", "battery": 0.1}],
    "parameters": {
        "hover": {"lambda": 0.01, "kp": [1, 1, 1, 1, 1, 1], "r_diagonal": [1, 1]},
        "supervisor": {"dwell_cycles": 10},
        "bumpless": {"ramp": False, "integral_at_switch": "keep"},
    },
    "end": {"hover_hold_s": 10},
    "keep_out": [
        {
            "corners": [{"north_m": n, "east_m": e} for n, e in ((50, 0), (60, 0), (60, 9))],
            "name": "wreck",
            "from_depth_m": 1,
            "to_depth_m": 9,
        }
    ],
    "keep_in": {"corners": [{"north_m": n, "east_m": e} for n, e in ((-90, -90), (90, -90), (0, 90))]},
    "origin": {"latitude_deg": 63.4, "longitude_deg": 10.4, "heading_deg": 30},
    "sea_floor": {"clearance_m": 2, "grid": "fjord.asc", "water_level_m": 0.5},
    "trim": {"buoyancy_n": 1, "weights": [{"mass_kg": 0.6, "from_m": [0.3, 0, 0], "to_m": [0.35, 0, 0]}]},
}
SCHEMA = jsonschema.Draft202012Validator(mission_json_schema())
DEFAULTS = default_parameters(load_vehicle("ts100"))


def readable(tree: Any) -> bool:
    """Whether the reader takes every single field; rules between fields are not asked."""
    try:
        with_overrides(DEFAULTS, read(Document, tree).parameters)
    except (Unread, ParameterError):
        return False
    return True


def places(tree: Any) -> list[tuple[str | int, ...]]:
    keys = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    return [(key, *rest) for key, value in keys for rest in ((), *places(value))]


_EDGES = sorted(
    {
        float(edge) + step
        for entry in catalogue(Document)
        for bound in (entry.get("min"), entry.get("max"))
        for edge in (bound if isinstance(bound, tuple) else (bound,))
        if edge is not None
        for step in (-1, -0.5, 0, 0.5, 1)
    }
)
_JUNK = st.one_of(
    st.sampled_from(_EDGES),
    st.sampled_from([None, True, "", "x", "1", "5 m", "keep", "n_p", [], [1], [1, 2, 3], {}, {"x": 1}, [{}]]),
    st.integers(-3, 70),
    st.floats(-1e6, 1e6),
    st.lists(st.floats(-2, 2) | st.integers(-2, 2), min_size=3, max_size=7),
)


@given(
    st.lists(
        st.tuples(st.sampled_from(places(WHOLE)), st.sampled_from(["set", "drop", "add", "double"]), _JUNK),
        max_size=2,
    )
)
def test_schema_and_reader_agree_on_any_document(changes: list[tuple[tuple[Any, ...], str, Any]]) -> None:
    """Protects: an editor with the schema and the reader never contradict each other about a field."""
    tree = copy.deepcopy(WHOLE)
    for path, change, value in changes:
        around: Any = tree
        for key in path[:-1]:
            try:
                around = around[key]
            except (KeyError, IndexError, TypeError):
                break
        if not isinstance(around, dict | list) or isinstance(around, list) != isinstance(path[-1], int):
            continue
        if change == "add" and isinstance(around, dict):
            around["extra"] = value
        elif change == "double" and isinstance(around, list):
            around *= 2
        elif isinstance(around, dict) or path[-1] < len(around):
            if change == "drop" and (isinstance(around, list) or path[-1] in around):
                del around[path[-1]]
            else:
                around[path[-1]] = value
    assert SCHEMA.is_valid(tree) == readable(tree), [*SCHEMA.iter_errors(tree)]


def test_all_fields_are_in_the_document_that_is_changed() -> None:
    """Protects: the agreement is asked about the format as it is, not as it was."""
    assert SCHEMA.is_valid(WHOLE) and readable(WHOLE)
    assert set(WHOLE) | {"summary"} == set(mission_json_schema()["properties"])
