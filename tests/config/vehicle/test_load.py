"""A shipped vehicle loads as its file says, and one text carries all of it."""

import pickle
from pathlib import Path

import pytest

from bumpless.config.vehicle import FOLDER, load_vehicle, parse_vehicle, vehicle_names
from bumpless.config.vehicle.parts import Fin, Thruster

NAMES = vehicle_names()


def test_ts100_has_the_papers_actuators_in_the_papers_order() -> None:
    """u = [delta_1..delta_4, n_p, n_v1, n_v2] of eq. (35) with the bounds of eq. (36)."""
    vehicle = load_vehicle("ts100")
    assert [a.name for a in vehicle.actuators] == [
        "delta_1",
        "delta_2",
        "delta_3",
        "delta_4",
        "n_p",
        "n_v1",
        "n_v2",
    ]
    assert [a.kind for a in vehicle.actuators] == ["fin"] * 4 + ["thruster"] * 3
    assert [c.unit for c in vehicle.commands] == ["deg"] * 4 + ["rpm"] * 3
    assert [c.upper for c in vehicle.commands] == [15.0] * 4 + [200.0] * 3
    assert [c.lower for c in vehicle.commands] == [-15.0] * 4 + [-200.0] * 3
    assert vehicle.controllable == ("X", "Z", "K", "M", "N")


@pytest.mark.parametrize("name", NAMES)
def test_the_text_alone_gives_the_same_vehicle(name: str) -> None:
    """The description message carries `text`: a listener must be able to rebuild the vehicle from it."""
    vehicle = load_vehicle(name)
    again = parse_vehicle(vehicle.text, vehicle.source)
    assert again == vehicle
    assert again.sha256 == vehicle.sha256
    assert vehicle.id == name


@pytest.mark.parametrize("name", NAMES)
def test_a_vehicle_can_be_sent_to_another_process(name: str) -> None:
    """Campaigns pickle vehicles."""
    vehicle = load_vehicle(name)
    assert pickle.loads(pickle.dumps(vehicle)) == vehicle


def test_control_tables_come_from_the_file_beside(tmp_path: Path) -> None:
    """`<id>.control.toml` is merged, is part of the text and changes the hash."""
    body = (FOLDER / "ts100.toml").read_text(encoding="utf-8")
    path = tmp_path / "mine.toml"
    path.write_text(body, encoding="utf-8")
    bare = load_vehicle(path)
    (tmp_path / "mine.control.toml").write_text("[control.forward]\nlambda = 0.25\n", encoding="utf-8")
    tuned = load_vehicle(path)
    assert bare.control == {}
    assert tuned.control == {"forward": {"lambda": 0.25}}
    assert "lambda = 0.25" in tuned.text
    assert tuned.sha256 != bare.sha256


def test_fins_lift_along_their_tangent() -> None:
    """e_L = [0, cos lambda, sin lambda] with lambda = radial direction + 90 deg, at the given arm."""
    for fin in load_vehicle("ts100").actuators:
        if isinstance(fin, Fin):
            x, y, z = fin.position_m
            ex, ey, ez = fin.direction
            assert x == fin.x_m and ex == 0.0
            assert (y * ey + z * ez) == pytest.approx(0.0, abs=1e-12)
            assert (y * ez - z * ey) == pytest.approx(fin.arm_m)  # r x e_L points along +x: all roll one way


@pytest.mark.parametrize("name", NAMES)
def test_every_number_says_where_it_comes_from(name: str) -> None:
    """A number without a source cannot be argued with: each table of a file names its sources."""
    words = ("identified", "published", "assumed", "computed")
    text = (FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    for block in text.split("\n\n"):
        if block.strip().startswith("[") and "actuators]]" not in block and "appendages]]" not in block:
            table = block.strip().splitlines()[0]
            sensors_said = "all assumed" in text and table.startswith("[sensors")
            assert sensors_said or any(word in block for word in words), f"{name}: {table}"


def test_bluerov2_heavy_is_eight_thrusters_for_six_components() -> None:
    """The second family of vehicles that nothing may name: no fins, all six components."""
    vehicle = load_vehicle("bluerov2_heavy")
    assert len(vehicle.actuators) == 8
    assert all(isinstance(a, Thruster) for a in vehicle.actuators)
    assert vehicle.controllable == ("X", "Y", "Z", "K", "M", "N")
