"""What is made from the one declaration of a number: check, words, record, catalogue, schema, pages."""

import pickle
import re
from dataclasses import FrozenInstanceError, replace
from math import radians
from typing import Annotated, Any, Literal

import jsonschema
import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from bumpless.config.declare import Choice, Number, Row, Switch, Unread, fields_of, model, read
from bumpless.config.declare.catalogue import catalogue
from bumpless.config.declare.record import codes, fill_record, record_dtype
from bumpless.config.declare.reference import tables
from bumpless.config.generate import ROOT, made
from bumpless.config.mission.model import Document as MissionDocument
from bumpless.config.parameters import RANGES, Parameters, default_parameters, with_overrides
from bumpless.config.parameters.records import section_dtype, word_codes
from bumpless.config.vehicle import load_vehicle
from bumpless.config.vehicle.model import Document as VehicleDocument

ALL = (MissionDocument, VehicleDocument, Parameters)
UNITS = {  # how a field's name ends when its numbers have this unit
    "m": "_m",
    "s": "_s",
    "m/s": "_mps",
    "m/s²": "_mps2",
    "deg": "_deg",
    "deg/s": "_degps",
    "kg": "_kg",
    "m²": "_m2",
    "m³": "_m3",
    "kg/m³": "_kgpm3",
    "kg·m²": "_kgm2",
    "rpm": "_rpm",
    "rpm/s": "_rpmps",
    "Hz": "_hz",
    "1/rad": "_per_rad",
    "1/rad²": "_per_rad2",
}


@model
class Tuned:
    """A section with one field of each sort."""

    angle_deg: Annotated[float, Number("Angle", "deg", -90.0, 90.0, record="angle")]
    rates_degps: Annotated[
        tuple[float, ...], Row("Rates", "deg/s", 0.0, names=("p", "q", "r"), record="rates")
    ] = (0.0, 0.0, 0.0)
    kp: Annotated[tuple[float, ...], Row("K_P", names=("p", "q", "r"), record="gains[0]")] = (1.0,) * 3
    kd: Annotated[tuple[float, ...], Row("K_D", names=("p", "q", "r"), record="gains[1]")] = (2.0,) * 3
    shares: Annotated[tuple[float, ...], Row("Shares", "", 0.0, 1.0, most=4, record="shares")] = (0.5,)
    cycles: Annotated[int, Number("Cycles", "cycles", 0, 9, record="cycles", stored=float)] = 3
    frames: Annotated[int, Number("Frames", "frames", 0, 9, live=True, record="frames")] = 3
    law: Annotated[Literal["first", "second"], Choice("Law", record="law")] = "first"
    on: Annotated[bool, Switch("On", record="on", help="Off is the default.")] = False
    note: Annotated[float, Number("In no record", above=0.0)] = 1.0


def broken(**said: Any) -> dict[str, str]:
    with pytest.raises(Unread) as caught:
        read(Tuned, {"angle_deg": 0} | said)
    return {one.path: one.rule for one in caught.value.broken}


def test_a_model_is_frozen_checked_and_a_dataclass() -> None:
    """Protects: no number out of its range is ever held, whoever makes the instance."""
    tuned = read(Tuned, {"angle_deg": 45, "frames": 2.0})
    assert (tuned.angle_deg, type(tuned.angle_deg), tuned.frames, type(tuned.frames)) == (45.0, float, 2, int)
    assert replace(tuned, note=2).note == 2.0
    assert pickle.loads(pickle.dumps(tuned)) == tuned
    with pytest.raises(FrozenInstanceError):
        tuned.note = 3.0  # type: ignore[misc]
    with pytest.raises(ValidationError):
        replace(tuned, angle_deg=91.0)


@pytest.mark.parametrize(
    ("field", "value", "path", "rule"),
    [
        ("angle_deg", 91, "angle_deg", "must be between -90 and 90 in deg"),
        ("angle_deg", "5 deg", "angle_deg", "must be a number in deg, without its unit"),
        ("angle_deg", "fast", "angle_deg", "must be a number in deg"),
        ("angle_deg", True, "angle_deg", "must be a number in deg"),
        ("angle_deg", None, "angle_deg", "must be a number in deg"),
        ("angle_deg", float("nan"), "angle_deg", "must be a finite number in deg"),
        ("angle_deg", -float("inf"), "angle_deg", "must be a finite number in deg"),
        ("angle_deg", 10**400, "angle_deg", "must be a finite number in deg"),
        ("frames", 10**400, "frames", "must be a finite number in frames"),
        ("frames", 2.5, "frames", "must be a whole number in frames"),
        ("frames", 10, "frames", "must be between 0 and 9 in frames"),
        ("note", 0, "note", "must be > 0"),
        ("rates_degps", [0, 0], "rates_degps", "must be a list of 3 numbers in deg/s: [p, q, r]"),
        ("rates_degps", 3, "rates_degps", "must be a list of 3 numbers in deg/s: [p, q, r]"),
        ("rates_degps", [0, -1, 0], "rates_degps[1]", "must be >= 0 in deg/s"),
        ("shares", [0.1] * 5, "shares", "must be a list of numbers, one per command"),
        ("shares", [0.1, 2], "shares[1]", "must be between 0 and 1"),
        ("law", "third", "law", "must be one of first, second"),
        ("law", ["first"], "law", "must be one of first, second"),
        ("on", 1, "on", "must be true or false"),
        ("nots", 1, "nots", "unknown field; did you mean note?"),
        ("zzzzzz", 1, "zzzzzz", "unknown field; one of angle_deg, rates_degps, kp, kd, shares, cycles, "
         "frames, law, on, note"),
    ],
)  # fmt: skip
def test_each_fault_has_its_own_words(field: str, value: Any, path: str, rule: str) -> None:
    """Protects: what a person reads says what is wrong and what would be right."""
    assert broken(**{field: value}) == {path: rule}


def test_all_faults_of_a_table_come_at_once() -> None:
    """Protects: nobody mends a file one fault at a time."""
    assert set(broken(angle_deg="x", frames=-1, on=3, law=0)) == {"angle_deg", "frames", "on", "law"}
    with pytest.raises(Unread, match="angle_deg: is missing: Angle in deg"):
        read(Tuned, {})


def test_the_record_is_si_and_made_from_the_declaration() -> None:
    """Protects: names, types, rows and radians of what compiled code reads."""
    dtype = record_dtype(Tuned)
    assert dtype.names == ("angle", "rates", "gains", "shares", "cycles", "frames", "law", "on")
    assert dtype["gains"].shape == (2, 3) and dtype["shares"].shape == (4,)
    assert (dtype["cycles"], dtype["frames"], dtype["law"], dtype["on"]) == ("f8", "i8", "i8", "i8")
    out = np.full(1, 7, dtype)
    fill_record(read(Tuned, {"angle_deg": 30, "rates_degps": [1, 2, 3], "law": "second", "on": True}), out[0])
    assert out["angle"][0] == radians(30)
    assert out["rates"][0].tolist() == [radians(1), radians(2), radians(3)]
    assert out["gains"][0].tolist() == [[1.0] * 3, [2.0] * 3]
    assert out["shares"][0].tolist() == [0.5, 0.0, 0.0, 0.0]
    assert (out["law"][0], out["on"][0], out["cycles"][0]) == (1, 1, 3.0)
    assert codes(Tuned, "law") == (0, 1)


def test_sections_fill_records_of_their_own() -> None:
    """Protects: the control modules' records, which are these calls."""
    parameters = default_parameters(load_vehicle("ts100"))
    parameters = with_overrides(parameters, {"navigation": {"fix_gate_m": 1.0}})  # 0 by default
    for name in fields_of(Parameters):
        out = np.zeros(1, section_dtype(name))
        fill_record(getattr(parameters, name), out[0])
        assert out[0].tobytes().strip(b"\0")
    assert (section_dtype("supervisor").names or ())[:6] == (
        "d_rh_l",
        "d_rh_u",
        "d_fr_l",
        "d_fr_u",
        "d_hf_u",
        "n_dwell",
    )
    assert word_codes("allocation", "allocator") == (0, 1, 2)


def test_the_schema_says_types_units_and_ranges() -> None:
    """Protects: editors and forms know what the reader knows."""
    schema = TypeAdapter(Tuned).json_schema()
    angle = schema["properties"]["angle_deg"]
    assert (angle["minimum"], angle["maximum"], angle["unit"], angle["title"]) == (
        -90.0,
        90.0,
        "deg",
        "Angle",
    )
    assert schema["properties"]["note"]["exclusiveMinimum"] == 0.0
    assert schema["properties"]["law"]["enum"] == ["first", "second"]
    assert schema["required"] == ["angle_deg"]
    jsonschema.Draft202012Validator.check_schema(schema)


def test_the_page_has_a_line_for_each_field() -> None:
    """Protects: the reference page can't forget a field."""
    page = "\n".join(tables(Tuned))
    assert "| `angle_deg` | number | deg | -90 to 90 | required |  | Angle |" in page
    assert "| `frames` | integer | frames | 0 to 9 | `3` | yes | Frames |" in page
    assert "| `on` | true or false |  |  | `false` |  | On. Off is the default. |" in page
    assert all(f"`{key}`" in page for key in fields_of(Tuned))


@pytest.mark.parametrize("cls", ALL)
def test_every_field_says_what_a_form_needs(cls: type) -> None:
    """Protects: a form can be built from the catalogue alone; names and units do not disagree."""
    entries = catalogue(cls)
    assert len({(entry["path"], entry["kind"]) for entry in entries}) == len(entries)
    for entry in entries:
        assert entry["label"] and entry["type"]
        ending = UNITS.get(entry["unit"])
        name = entry["path"].rpartition(".")[2]
        assert ending is None or name.endswith(ending) or re.search(f"{ending}_|_x_m$|per_s$", name), entry
        if entry["type"] in ("number", "integer") and cls is not VehicleDocument:
            assert entry["min"] is not None and entry["max"] is not None, entry["path"]


def test_parts_lists_and_kinds_have_paths_of_their_own() -> None:
    """Protects: what a form asks for by path."""
    mission = {entry["path"]: entry for entry in catalogue(MissionDocument)}
    assert mission["legs[].speed_mps"]["unit"] == "m/s" and mission["legs"]["most"] == 511
    assert mission["parameters.hover.lambda"]["live"] and mission["environment.wave"]["nullable"]
    assert mission["target.position_ned_m"]["min"] == (-1e5, -1e5, 0.0)
    vehicle = {(entry["path"], entry["kind"]) for entry in catalogue(VehicleDocument)}
    assert {("hull.size_m", "tabulated"), ("actuators[].span_m", "fin")} <= vehicle
    assert {r.path for r in RANGES} <= {entry["path"] for entry in catalogue(Parameters)}


def test_what_is_generated_is_up_to_date() -> None:
    """Protects: published schemas and reference pages follow the declarations. Renew them with `make gen`."""
    stale = [name for name, text in made().items() if (ROOT / name).read_text(encoding="utf-8") != text]
    assert stale == []
