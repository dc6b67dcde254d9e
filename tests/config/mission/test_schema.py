"""The published schema and the parser agree about what a mission is."""

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from ruamel.yaml import YAML

from bumpless.config.mission import MissionError, mission_json_schema, parse_mission
from bumpless.config.vehicle import Vehicle

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
