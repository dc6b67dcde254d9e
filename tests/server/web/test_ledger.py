"""What is changed here is written down with its author, from what to what, also where nobody flies."""

from typing import Any

from bumpless.config.mission import missions_folder
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.access.who import Role
from bumpless_server.settings import Settings
from tests.server.access.people import Make, logged_in, staffed
from tests.server.serving import Running, serving

DOCKING = (missions_folder() / "docking.yaml").read_bytes()
LONGER = DOCKING.replace(b"duration_s: 90", b"duration_s: 95")


def audited(server: Running) -> list[dict[str, Any]]:
    """The audit's lines, oldest first."""
    return server.http.get("/api/audit").json()[::-1]


def test_each_kind_of_change_is_written_down_with_what_it_was_and_became(running: Running) -> None:
    """Protects: actions on missions, presets, charts and alarms stood nowhere."""
    http = running.http
    ada = {"x-operator": "Ada"}
    first = http.put("/api/missions/mine", content=DOCKING, headers=ada).json()["sha256"]
    second = http.put("/api/missions/mine", content=LONGER, headers=ada).json()["sha256"]
    http.put("/api/missions/mine/draft", content=b"work in progress").raise_for_status()
    http.put("/api/missions/mine/marks", json={"tags": ["tank"]}).raise_for_status()
    http.post("/api/missions/mine/rename", json={"to": "ours"}).raise_for_status()
    binned = http.delete("/api/missions/ours").json()["id"]
    http.post(f"/api/mission-bin/{binned}/restore").raise_for_status()
    active = http.get("/api/parameters").json()["active"]
    http.put("/api/presets/calm", json=active).raise_for_status()
    before = active["hover"]["ramp_cycles"]
    active["hover"]["ramp_cycles"] = before + 1
    http.put("/api/presets/calm", json=active).raise_for_status()
    http.delete("/api/presets/calm").raise_for_status()
    lines = audited(running)
    assert [line["verb"] for line in lines] == [
        "save_mission", "save_mission", "mark_mission", "rename_mission", "delete_mission", "restore_mission",
        "save_preset", "save_preset", "delete_preset",
    ]  # fmt: skip
    details = [line["details"] for line in lines]
    assert details[0] == {"name": "mine", "sha256": [None, first]}
    assert details[1] == {"name": "mine", "sha256": [first, second]}
    assert details[2] == {"name": "mine", "changes": {"tags": [[], ["tank"]]}}
    assert details[3]["name"] == ["mine", "ours"]
    assert details[4]["sha256"] == [second, None] and details[5]["sha256"] == [None, second]
    assert details[7] == {"name": "calm", "changes": {"hover.ramp_cycles": [before, before + 1]}}
    assert lines[0]["author"] == "Ada" and lines[2]["author"] == "a program at 127.0.0.1"
    assert {line["answer"] for line in lines} == {"accepted"} and lines[0]["address"] == "127.0.0.1"


def test_a_refusal_is_written_down_with_its_reason_and_nonsense_is_not(running: Running) -> None:
    """Protects: who tried to change what somebody else had changed is known; noise does not hide it."""
    http = running.http
    http.put("/api/missions/mine", content=DOCKING).raise_for_status()
    assert http.put("/api/missions/mine", params={"base": "0" * 64}, content=LONGER).status_code == 409
    assert http.put("/api/missions/mine", content=b"nonsense").status_code == 422
    assert http.delete("/api/presets/nobody").status_code == 404
    lines = audited(running)
    assert [line["answer"] for line in lines] == ["accepted", "refused"]
    assert "was changed or deleted by somebody" in lines[1]["said"]


def test_an_alarm_is_seen_in_the_name_of_the_account(make_settings: Make) -> None:
    """Protects: an alarm that somebody put aside or saw is one of the commands of the audit."""
    with staffed(make_settings(manage_node=False)) as server, logged_in(server, Role.operator) as otto:
        server.console.say(pb.SEVERITY_ALARM, "leak", "Water.", {})
        (alarm,) = server.until(server.console.alarms.open)
        said = {"x-operator": "somebody else"}
        otto.post(f"/api/alarms/{alarm.id}/shelve", json={"seconds": 60}, headers=said).raise_for_status()
        otto.post(f"/api/alarms/{alarm.id}/acknowledge", headers=said).raise_for_status()
        shelved, seen = [e for e in server.console.audit.entries() if e["verb"].endswith("alarm")]
    named = {"alarm": alarm.id, "code": "leak", "text": "Water."}
    assert (shelved["verb"], shelved["author"]) == ("shelve_alarm", "otto")
    assert shelved["details"] == {**named, "seconds": 60.0}
    assert (seen["verb"], seen["details"]) == ("acknowledge_alarm", named)


def test_what_was_changed_is_still_there_after_a_restart(make_settings: Make) -> None:
    """Protects: the line is on the disk before the answer goes."""
    settings: Settings = make_settings(manage_node=False)
    with serving(settings) as server:
        server.http.put("/api/missions/mine", content=DOCKING).raise_for_status()
        assert b"save_mission" in settings.data_dir.joinpath("audit.jsonl").read_bytes()
    with serving(settings) as again:
        assert [line["verb"] for line in audited(again)] == ["save_mission"]
