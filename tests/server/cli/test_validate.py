"""`bumpless validate` and `run` with a sea floor, and with files that can't be read."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from bumpless.config.mission import missions_folder
from bumpless_server.cli.main import app
from tests.server.plan.charts.files import ASC, SLOPE, tiff

DOCKING = (missions_folder() / "docking.yaml").read_text()
FLOORED = DOCKING + "sea_floor: {clearance_m: 5, grid: basin}\n"


def _validate(*words: object, code: int) -> list[dict]:
    result = CliRunner().invoke(app, ["validate", "--json", *map(str, words)])
    assert result.exit_code == code, result.output
    return json.loads(result.stdout)


def _codes(told: dict) -> list[str]:
    return [finding["code"] for finding in told["findings"] if finding["severity"] == "hard"]


def test_every_file_is_answered_whatever_the_others_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a folder, a lost file or one that breaks a check costs no answer of the others."""
    good, odd = tmp_path / "good.yaml", tmp_path / "odd.yaml"
    good.write_text(DOCKING)
    odd.write_text(DOCKING.replace("name: docking", "name: odd"))
    from bumpless_server.foresight import checked

    plain = checked.findings_of

    def breaks(mission, vehicle=None):  # type: ignore[no-untyped-def]
        if mission.name == "odd":
            raise ZeroDivisionError("by an odd file")
        return plain(mission, vehicle)

    monkeypatch.setattr(checked, "findings_of", breaks)
    told = _validate(tmp_path, tmp_path / "lost.yaml", odd, good, code=1)
    assert [one["ok"] for one in told] == [False, False, False, True]
    assert "ZeroDivisionError" in told[2]["problems"][0]["rule"]


def test_the_depth_grid_beside_a_mission_counts(tmp_path: Path) -> None:
    """Protects: the command line finds what the console would: too near, missing, of another kind."""
    mission = tmp_path / "deep.yaml"
    mission.write_text(FLOORED)
    assert _codes(_validate(mission, code=1)[0]) == ["sea_floor_unknown"]
    (tmp_path / "basin.asc").write_bytes(ASC)
    assert "too_near_the_floor" in _codes(_validate(mission, code=1)[0])
    (tmp_path / "basin.asc").write_bytes(ASC.replace(b"4", b"9"))
    assert _validate(mission, code=0)[0]["ok"]
    (tmp_path / "basin.asc").write_bytes(b"ncols 2")
    broken = _validate(mission, code=1)[0]["problems"][0]
    assert broken["field"] == "sea_floor.grid" and "basin.asc" in broken["rule"]


def test_a_geotiff_is_found_in_a_folder_of_charts(tmp_path: Path) -> None:
    """Protects: a survey as it comes from a sounder is enough, wherever it lies."""
    charts, mission = tmp_path / "charts", tmp_path / "lake.yaml"
    charts.mkdir()
    (charts / "basin.tif").write_bytes(tiff(SLOPE))
    origin = "origin: {latitude_deg: 47.4985, longitude_deg: 8.502}\n"
    mission.write_text(FLOORED.replace("clearance_m: 5", "clearance_m: 1") + origin)
    assert _codes(_validate(mission, code=1)[0]) == ["sea_floor_unknown"]
    told = _validate("--charts", charts, mission, code=0)[0]
    assert told["ok"] and not _codes(told)
