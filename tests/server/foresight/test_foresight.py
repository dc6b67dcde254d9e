"""What a planner is told: the flight to come, the findings, the fan, and nothing of older edits."""

import asyncio
import os
import signal
import sys
from dataclasses import replace
from pathlib import Path

import psutil
import pytest
from typer.testing import CliRunner

import bumpless
from bumpless.campaign.flight import Hangar, fly_number
from bumpless.config.mission import missions_folder, parse_mission
from bumpless.config.parameters import default_parameters, to_message, with_overrides
from bumpless_server.cli.main import app
from bumpless_server.foresight import fan
from bumpless_server.foresight.forecast import digest_of
from bumpless_server.foresight.foresight import Foresight
from bumpless_server.foresight.plan import plan_of
from bumpless_server.foresight.wanted import ForesightRequest
from tests.server.foresight.conftest import Planner, joined

DOCKING = (missions_folder() / "docking.yaml").read_text()
ABEAM = DOCKING.split("\nenvironment:")[0] + "\nenvironment:\n  current_ned_mps: [0, 0.1, 0]\n"


def _workers() -> list[psutil.Process]:
    children = psutil.Process().children(recursive=True)
    return [c for c in children if "bumpless_server.foresight.worker" in " ".join(c.cmdline())]


@pytest.mark.parametrize("name", ["docking", "docking_current", "s6_fault_tolerant", "rov_docking"])
async def test_the_forecast_is_the_flight_to_the_bit(planner: Planner, tmp_path: Path, name: str) -> None:
    """Protects: what the planner sees is what `bumpless run` flies and logs, every column of it."""
    path, log = missions_folder() / f"{name}.yaml", tmp_path / "run.mcap"
    planner.ask(1, path.read_text(), seed=7)
    nominal = next(m for m in await planner.until_end(1) if m["kind"] == "nominal")
    shown = CliRunner().invoke(app, ["run", str(path), "--seed", "7", "--out", str(log)])
    assert shown.exit_code == 0
    flown = bumpless.open_run(log)
    assert nominal["digest"] == digest_of(flown.columns)
    assert nominal["outcome"]["ending"] == flown.outcome.ending.value
    assert nominal["outcome"]["reason"] == flown.outcome.reason
    assert (nominal["sha256"], nominal["seed"]) == (flown.info.mission_sha256, 7)
    track = nominal["track"]
    assert track.pop("floor_m") == track.pop("clearance_m") == []  # the mission names no sea floor
    assert len({len(track[key]) for key in track}) == 1 and 100 < len(track["t_s"]) <= 600
    assert track["t_s"][-1] == pytest.approx(flown.columns.time[-1], abs=1e-3)
    assert [s["to"] for s in nominal["switches"]][:2] == ["R", "H"]
    assert all(0.0 <= value <= 1.0 for key in ("saturation", "margin") for value in track[key])


async def test_a_text_that_cannot_be_read_is_told_with_places(planner: Planner) -> None:
    """Protects: a typo while typing is marked where it stands and starts nothing."""
    planner.ask(1, DOCKING.replace("speed_mps: 0.7}", "speed_mps: 70}", 1), flights=5)
    told = await planner.until_end(1)
    assert [m["kind"] for m in told] == ["problems"]
    problem = told[0]["problems"][0]
    assert problem["field"] == "legs[0].speed_mps" and problem["line"] > 1 and problem["column"] > 1
    assert problem["value"] == "70" and "must be" in problem["rule"] and "70" in problem["message"]


async def test_findings_come_with_their_mends(planner: Planner) -> None:
    """Protects: what can't work is told with its place, its reason and a change that mends it."""
    planner.ask(1, ABEAM)
    told = {m["kind"]: m for m in await planner.until_end(1)}
    found = told["findings"]["findings"][0]
    assert found["severity"] == "hard" and found["path"] == "target.heading_deg" and found["mends"]
    assert DOCKING.splitlines()[found["line"] - 1].strip().startswith("heading_deg")
    assert told["nominal"]["outcome"]["ending"] != "docked"


async def test_what_if_is_flown_in_place_of_the_document(planner: Planner) -> None:
    """Protects: other parameters, current and vehicle change the forecast, not the document's hash."""
    planner.ask(1, DOCKING, overrides={"current": [0, 0.1, 0], "parameters": {"hover.lambda": 0.02}})
    changed = {m["kind"]: m for m in await planner.until_end(1)}
    assert changed["findings"]["findings"][0]["code"] == "current_not_holdable"
    planner.ask(2, DOCKING, overrides={"vehicle": "bluerov2_heavy"})
    other = {m["kind"]: m for m in await planner.until_end(2)}
    assert other["nominal"]["sha256"] == changed["nominal"]["sha256"]
    assert other["nominal"]["digest"] != changed["nominal"]["digest"]
    planner.ask(3, DOCKING, overrides={"parameters": {"hover.nonsense": 1}})
    assert (await planner.until_end(3))[0]["problems"][0]["field"] == "hover.nonsense"


async def test_the_fan_flies_every_number_once(planner: Planner) -> None:
    """Protects: no drawn flight is lost or counted twice, and each is the campaign's flight of its number."""
    planner.ask(1, DOCKING, seed=3, flights=30)
    fans = [m for m in await planner.until_end(1) if m["kind"] == "fan"]
    flights = [flight for m in fans for flight in m["flights"]]
    assert sorted(f["number"] for f in flights) == list(range(30))
    assert [m["done"] for m in fans] == sorted(m["done"] for m in fans) and fans[-1]["done"] == 30
    assert all(m["of"] == 30 for m in fans) and len(fans) > 2
    chance = fans[-1]["chance"]
    assert chance["of"] == 30 == sum(chance["counts"].values())
    assert chance["docked"] == chance["counts"].get("docked", 0)
    assert 0.0 <= chance["low"] <= chance["docked"] / 30 <= chance["high"] <= 1.0
    drawn = fan.prepared(plan_of(ForesightRequest.model_validate({"id": 1, "text": DOCKING, "seed": 3})))
    for flight in flights[:3]:
        row = fly_number(drawn, flight["number"], Hangar())
        assert (flight["seed"], flight["outcome"], flight["end_s"]) == (
            row["seed"],
            row["outcome"],
            row["duration_s"],
        )
        assert len(flight["north_m"]) == len(flight["depth_m"]) <= 60


async def test_the_newest_edit_wins(planner: Planner) -> None:
    """Protects: dragging a waypoint never waits for the fans of older places, nor hears of them again."""
    edits = [DOCKING.replace("duration_s: 90", f"duration_s: {90 + n}") for n in range(6)]
    for n, text in enumerate(edits, 1):
        planner.ask(n, text, flights=1000)
        await asyncio.sleep(0)
    planner.ask(7, DOCKING, flights=4)
    told = await planner.until_end(7)
    assert told[-1]["kind"] == "done" and sum(len(m["flights"]) for m in told if m["kind"] == "fan") == 4
    planner.ask(8, DOCKING)
    while (message := await planner.told.get())["kind"] != "done":
        assert message["id"] == 8
    assert planner.told.empty()


async def test_two_planners_take_turns(foresight: Foresight) -> None:
    """Protects: one planner's long fan keeps nobody else from a forecast."""
    join = joined(foresight)
    async with join() as one, join() as two:
        one.ask(1, DOCKING, flights=1000)
        two.ask(1, DOCKING, flights=20)
        told = await two.until_end(1)
        assert told[-1]["kind"] == "done" and one.told.qsize() > 0
        assert one.client.job is not None  # its fan still flies


async def test_a_worker_that_dies_costs_one_request(planner: Planner) -> None:
    """Protects: a crash is told, and the next edit is foreseen by another process."""
    planner.ask(1, DOCKING)
    await planner.until_end(1)
    planner.ask(2, DOCKING, flights=1000)
    while (await planner.told.get())["kind"] != "fan":
        pass
    for worker in _workers():
        worker.send_signal(signal.SIGKILL)
    assert (await planner.until_end(2))[-1]["kind"] == "failed"
    planner.ask(3, DOCKING)
    assert (await planner.until_end(3))[-1]["kind"] == "done"


async def test_workers_give_way_and_leave_nothing_behind(foresight: Foresight) -> None:
    """Protects: foresight runs below everything else's priority, and ends with its server."""
    async with joined(foresight)() as planner:
        planner.ask(1, DOCKING)
        await planner.until_end(1)
        workers = _workers()
        assert len(workers) == 2
        assert [w.nice() for w in workers] == [min(os.nice(0) + 10, 19)] * 2
    await foresight.stop()
    assert _workers() == []


async def test_too_long_a_mission_is_refused_with_the_reason(planner: Planner) -> None:
    """Protects: a day's mission does not fill the machine's memory, and the findings come all the same."""
    planner.ask(1, DOCKING.replace("duration_s: 90", "duration_s: 90000"))
    assert "90000 s" in (await planner.until_end(1))[-1]["reason"]


async def test_what_is_no_request_is_answered(planner: Planner) -> None:
    """Protects: a client of another version learns what was wrong with its words."""
    planner.client.ask('{"id": 4, "text": "", "flights": 2000}')
    assert (await planner.until_end(4))[0]["kind"] == "failed"
    planner.client.ask("[1")
    assert (await planner.until_end(0))[0]["kind"] == "failed"


def test_a_plan_keeps_its_text(tmp_path: Path) -> None:
    """Protects: the hash is that of the bytes, whatever was overridden."""
    request = ForesightRequest.model_validate(
        {"id": 1, "text": "\ufeff" + DOCKING.replace("\n", "\r\n"), "overrides": {"current": [0.1, 0, 0]}}
    )
    plan = plan_of(request)
    assert plan.mission.sha256 == parse_mission(request.text.encode()).sha256
    assert plan.mission.environment == replace(plan.mission.environment, current_ned_mps=(0.1, 0.0, 0.0))


def test_a_tuned_vehicle_is_foreseen_as_it_is_tuned() -> None:
    """Protects: the forecast takes what the vehicle will fly with, under the mission's own parameters, and
    defaults stay equal to the bit on their way through the contract."""
    vehicle = bumpless.load_vehicle("ts100")
    own = default_parameters(vehicle)
    request = ForesightRequest.model_validate({"id": 1, "text": DOCKING})
    tuned = to_message(with_overrides(own, {"hover": {"lambda": 0.033}}))
    plan = plan_of(request, vehicle, tuned.SerializeToString())
    assert plan.tuned and plan.parameters != plan_of(request, vehicle).parameters
    same = plan_of(request, vehicle, to_message(own).SerializeToString())
    assert same.parameters == plan_of(request).parameters
    other = plan_of(request, bumpless.load_vehicle("remus100"), tuned.SerializeToString())
    assert not other.tuned and other.parameters == plan_of(request).parameters


async def test_workers_that_never_come_up_are_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: where no process comes up, a planner is told so and does not wait for ever."""
    monkeypatch.setattr("bumpless_server.foresight.foresight.COMMAND", (sys.executable, "-c", "pass"))
    broken = Foresight(workers=2)
    async with joined(broken)() as planner:
        planner.ask(1, DOCKING)
        assert (await planner.until_end(1))[-1]["kind"] == "failed"
    await broken.stop()
