"""`bumpless identify` as a user types it: scales with intervals, a vehicle file to fly with, refusals."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import bumpless
from bumpless.campaign.plant import Alteration
from bumpless.config.vehicle.parts import Thruster
from bumpless.contract.exits import MISUSED, REFUSED
from bumpless_server.cli.main import app

WEAK = Alteration(thrust=0.88, fin_lift=0.8)


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A docking flight of a vehicle whose screws and fins are weaker than its file says."""
    path = tmp_path_factory.mktemp("flown") / "flown.mcap"
    return bumpless.fly("docking_target_lost", seed=3, alter=WEAK).save(path)


def identify(*arguments: object, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error of the command, which ends with `code`."""
    result = CliRunner().invoke(app, ["identify", *map(str, arguments)])
    assert result.exit_code == code, result.output
    return result.stdout, result.stderr


def test_a_weak_screw_is_told_with_its_interval(log: Path) -> None:
    """Protects: the scale, its interval and what it means in words; drag is told, not written."""
    text, _ = identify(log)
    line = next(line for line in text.splitlines() if "thrust of n_p" in line)
    assert "less than the file says" in line
    said = json.loads(identify(log, "--json")[0])
    found = {(one["what"], *one["actuators"][:1]): one for one in said["scales"]}
    screw, lift = found["thrust", "n_p"], found["lift", "delta_1"]
    assert screw["interval"][0] < 0.88 < screw["interval"][1] < 1.0
    assert lift["interval"][0] < 0.80 < lift["interval"][1] < 1.0
    assert {change["path"] for change in said["changes"]} == {
        "actuators[4].thrust_coefficient",
        "actuators[4].thrust_slope",
        "actuator_types.vertical.thrust_coefficient",
        "actuator_types.vertical.thrust_slope",
        "actuator_types.rudder.lift_slope_per_rad",
    }


def test_the_written_file_is_a_vehicle(log: Path, tmp_path: Path) -> None:
    """Protects: the file loads, flies, and its screw is as weak as was found."""
    out = tmp_path / "learned.toml"
    assert f"Written to {out}" in identify(log, "--out", out)[0]
    vehicle = bumpless.load_vehicle(str(out))
    screw = next(one for one in vehicle.actuators if one.name == "n_p")
    assert isinstance(screw, Thruster)
    assert screw.thrust_coefficient == pytest.approx(0.88 * 0.391, rel=0.05)
    assert vehicle.control == bumpless.load_vehicle("ts100").control


def test_a_file_with_a_control_file_beside_is_not_overwritten(log: Path, tmp_path: Path) -> None:
    """Protects: what is written holds the control parameters too, and would say them twice."""
    (tmp_path / "mine.control.toml").write_text("")
    _, said = identify(log, "--out", tmp_path / "mine.toml", code=MISUSED)
    assert "mine.control.toml lies beside" in said
    assert not (tmp_path / "mine.toml").exists()


def test_logs_of_two_vehicles_are_refused(log: Path, tmp_path: Path) -> None:
    """Protects: scales are of one file; logs that were flown with two don't mix."""
    other = bumpless.fly("remus_docking", seed=1).save(tmp_path / "remus.mcap")
    _, said = identify(log, other, code=REFUSED)
    assert "files differ" in said


def test_no_log_at_all_is_refused(tmp_path: Path) -> None:
    """Protects: one plain sentence for a file that is something else."""
    wrong = tmp_path / "wrong.mcap"
    wrong.write_bytes(b"no log")
    _, said = identify(wrong, code=REFUSED)
    assert said.startswith("bumpless identify: ")
    assert "Traceback" not in said
