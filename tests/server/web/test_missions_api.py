"""Mission files over HTTP: what is wrong is told with line and rule, and nothing bad is kept."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from bumpless.config.mission import MissionError, missions_folder
from bumpless.config.vehicle import load_vehicle, parse_vehicle
from bumpless_server.plan.missions import Missions
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

DOCKING = (missions_folder() / "docking.yaml").read_text()


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False, upload_bytes=20_000)) as server:
        yield server


def test_builtin_missions_are_there_and_valid(alone: Running) -> None:
    """A newcomer finds something to fly."""
    missions = alone.http.get("/api/missions").json()
    assert {"docking", "docking_current", "docking_target_lost"} <= {m["name"] for m in missions}
    assert all(m["builtin"] and m["valid"] and m["duration_s"] > 0 for m in missions)
    whole = alone.http.get("/api/missions/docking.yaml").json()
    assert whole["yaml"] == DOCKING


def test_an_upload_is_kept_listed_replaced_on_demand_and_deleted(alone: Running) -> None:
    """The life of an uploaded mission."""
    upload = alone.http.post("/api/missions", params={"name": "mine.yaml"}, content=DOCKING)
    assert upload.status_code == 201 and upload.headers["location"] == "/api/missions/mine"
    again = alone.http.post("/api/missions", params={"name": "mine"}, content=DOCKING)
    assert again.status_code == 409
    longer = DOCKING.replace("duration_s: 90", "duration_s: 95")
    replaced = alone.http.post("/api/missions", params={"name": "mine", "replace": 1}, content=longer)
    assert replaced.json()["duration_s"] == 95
    listed = {m["name"]: m for m in alone.http.get("/api/missions").json()}
    assert listed["mine"]["builtin"] is False and listed["mine"]["sha256"] == replaced.json()["sha256"]
    assert alone.http.delete("/api/missions/mine").json()["name"] == "mine"
    assert alone.http.delete("/api/missions/mine").status_code == 404
    assert alone.http.get("/api/missions/mine").status_code == 404


def test_a_bad_file_is_refused_with_line_field_value_and_rule(alone: Running, tmp_path: Path) -> None:
    """The operator is told what to change and where, and the folder stays as it was."""
    bad = DOCKING.replace("speed_mps: 0.7}", "speed_mps: 70}", 1)
    line = next(i for i, text in enumerate(bad.splitlines(), 1) if "speed_mps: 70" in text)
    answer = alone.http.post("/api/missions", params={"name": "bad.yaml"}, content=bad)
    assert answer.status_code == 422
    problem = answer.json()["problems"][0]
    assert (problem["file"], problem["line"], problem["field"]) == ("bad.yaml", line, "legs[0].speed_mps")
    assert problem["value"] == "70" and "must be" in problem["rule"]
    assert alone.http.get("/api/missions/bad").status_code == 404


@pytest.mark.parametrize(
    ("name", "content", "status"),
    [
        ("../evil", DOCKING.encode(), 422),
        (".hidden", DOCKING.encode(), 422),
        ("a/b", DOCKING.encode(), 422),
        ("", DOCKING.encode(), 422),
        ("docking", DOCKING.encode(), 409),
        ("big", b"#" * 20_001, 413),
        ("binary", b"\xff\xfe\x00", 422),
        ("empty", b"", 422),
    ],
)
def test_names_and_contents_that_are_no_missions(
    alone: Running, name: str, content: bytes, status: int
) -> None:
    """Every refusal has a sentence, and none is a server error."""
    answer = alone.http.post("/api/missions", params={"name": name, "replace": 1}, content=content)
    assert answer.status_code == status
    assert answer.json()["detail"]


def test_builtin_missions_stay(alone: Running) -> None:
    """What comes with the package cannot be deleted from the page."""
    assert alone.http.delete("/api/missions/docking").status_code == 409
    assert alone.http.get("/api/missions/docking").status_code == 200


def test_a_faulty_file_put_there_by_hand_is_listed_with_its_problems(alone: Running) -> None:
    """It is shown as unusable and cannot be started; the others still can."""
    (alone.console.data.missions / "hand.yaml").write_text("version: 1\n")
    listed = {m["name"]: m for m in alone.http.get("/api/missions").json()}
    assert not listed["hand"]["valid"] and listed["hand"]["problems"]
    assert alone.http.post("/api/mission/start", json={"name": "hand"}).status_code == 422


def test_without_a_vehicle_commands_fail_clearly(alone: Running) -> None:
    """An empty answer is a failure, never a success."""
    for path, body in (("start", {"name": "docking"}), ("pause", None), ("abort", None)):
        answer = alone.http.post(f"/api/mission/{path}", json=body)
        assert answer.status_code == 503
        assert answer.json()["accepted"] is False and "ts100" in answer.json()["detail"]
    assert alone.http.get("/api/vehicle").status_code == 404
    assert alone.http.get("/api/parameters").status_code == 404
    assert alone.http.get("/api/status").json()["link"] == "LINK_STATE_WAITING"
    assert alone.http.post("/api/mission/explode").status_code == 404


def test_the_vehicle_decides(running: Running) -> None:
    """Accepted and refused are the vehicle's words, passed on with its reason."""
    http = running.http
    assert http.post("/api/mission/pause").status_code == 409
    started = http.post("/api/mission/start", json={"name": "docking", "seed": 7}).json()
    assert started["accepted"] and started["run_id"]
    second = http.post("/api/mission/start", json={"name": "docking"})
    assert (second.status_code, second.json()["detail"]) == (409, "a mission is being flown")
    assert http.post("/api/mission/pause").json()["accepted"]
    assert http.post("/api/mission/resume").json()["accepted"]
    assert http.post("/api/mission/abort").json()["accepted"]
    status = running.until(
        lambda: (m := http.get("/api/status").json()["mission"])["phase"].endswith("ABORTED") and m
    )
    assert (status["run_id"], status["seed"]) == (started["run_id"], 7)
    assert http.post("/api/mission/start", json={"name": "docking", "sead": 7}).status_code == 422
    assert http.post("/api/mission/start", json={"name": "nowhere"}).status_code == 404


def test_a_vehicle_that_does_not_answer_is_a_failure(make_settings: Callable[..., Settings]) -> None:
    """Alive but deaf: the operator is told, and the server goes on."""
    with serving(make_settings("--deaf", command_timeout_s=0.5)) as server:
        server.until(lambda: server.console.state.latest("parameters"))
        assert server.http.post("/api/mission/abort").status_code == 503


def test_a_mission_for_the_vehicle_on_the_bus_is_kept_though_its_file_is_not_ours(tmp_path: Path) -> None:
    """An operator with a vehicle file of their own can upload missions for it, and only for it."""
    own = parse_vehicle(
        load_vehicle("ts100").text.replace('id = "ts100"', 'id = "harbour7"'), "harbour7.toml"
    )
    text = DOCKING.replace("vehicle: ts100", "vehicle: harbour7")
    with pytest.raises(MissionError, match="no such vehicle"):
        Missions(tmp_path).save("mine", text.encode(), replace=False)
    missions = Missions(tmp_path, vehicle=lambda: own)
    assert missions.save("mine", text.encode(), replace=False).mission is not None
    with pytest.raises(MissionError, match="no such vehicle"):
        missions.save("other", text.replace("harbour7", "harbour8").encode(), replace=False)
    with pytest.raises(MissionError, match="duration_s"):
        missions.save("other", text.replace("duration_s: 90", "duration_s: -1").encode(), replace=False)


def test_what_is_no_file_is_no_mission(tmp_path: Path) -> None:
    """A folder or a link to nothing among the uploads hides none of the missions."""
    (tmp_path / "folder.yaml").mkdir()
    (tmp_path / "dangling.yaml").symlink_to(tmp_path / "nowhere")
    (tmp_path / "faulty.yaml").write_bytes(b"\xff\xff")
    files = {file.name: file for file in Missions(tmp_path).all()}
    assert files["docking"].mission is not None and files["faulty"].mission is None
    assert "folder" not in files and "dangling" not in files
