"""One flight has one outcome: in memory, in its log, and where the log tells no end or no numbers."""

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from bumpless import Ending, Run, fly, load_mission, open_run
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import decoded, encoded
from bumpless.runs.summary import summarise
from tests.runs.flights import START_NS, Told, on_bus, record

Change = Callable[[Any], None]


@pytest.fixture(scope="module")
def docked() -> Run:
    """A flight that docks; of 90 s."""
    return fly("docking", started_ns=START_NS)


def log_of(path: Path, bus: list[Told]) -> Run:
    """The run of a log of what the bus carried."""
    record(path, bus)
    return open_run(path)


def end_of(bus: list[Told], schema: str, from_s: float, change: Change | None) -> list[Told]:
    """The bus with each message of a kind changed from a mission time on; None: not said any more."""
    told = []
    for time_ns, topic, kind, payload in bus:
        message: Any = decoded(kind, payload)
        if kind == schema and message.stamp.mission_time_s >= from_s:
            if change is None:
                continue
            change(message)
            payload = encoded(message)
        told.append((time_ns, topic, kind, payload))
    return told


def without_truth(bus: list[Told]) -> list[Told]:
    """As a real vehicle's log is."""
    return [one for one in bus if one[1] != "truth/state"]


def broken(model: np.void, truth: np.void) -> None:
    """A plant that comes to no numbers in its first cycles."""
    model["T_nn"][:] = 1e308


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_a_simulation_that_breaks_down_ends_alike_in_memory_and_log(tmp_path: Path) -> None:
    """Protects: what ended "aborted" for `bumpless run` was "time over" in its report and its metrics."""
    run = fly(replace(load_mission("docking"), duration_s=5.0), alter=broken)
    again = open_run(run.save(tmp_path / "broken.mcap"))
    assert run.outcome.ending is Ending.ABORTED and run.columns.lost
    assert again.outcome == run.outcome and again.metrics == run.metrics
    assert len(again.columns) == len(run.columns)


def test_a_vehicle_that_ends_without_numbers_has_not_docked(docked: Run, tmp_path: Path) -> None:
    """Protects: a vehicle whose position was NaN for the last seconds was docked by what it said before."""
    bus = without_truth(on_bus(docked))
    whole = log_of(tmp_path / "whole.mcap", bus).outcome
    assert (whole.ending, whole.basis) == (Ending.DOCKED, "believed")

    def nowhere(message: pb.Navigation) -> None:
        message.position_ned_m.x = math.nan

    found = log_of(tmp_path / "nan.mcap", end_of(bus, "bumpless.Navigation", 88.0, nowhere))
    assert (found.outcome.ending, found.outcome.basis) == (Ending.ABORTED, "believed")
    assert "no number any more" in found.outcome.reason and found.outcome.true_errors is None
    assert summarise(tmp_path / "nan.mcap").outcome == "aborted"
    slip = log_of(tmp_path / "slip.mcap", end_of(bus, "bumpless.Navigation", 89.8, nowhere))
    assert slip.outcome.ending is Ending.DOCKED


def test_seconds_that_nobody_recorded_are_not_judged(docked: Run, tmp_path: Path) -> None:
    """Protects: a flight whose last seconds are not in the log was judged as if it had ended before them."""
    bus, path = without_truth(on_bus(docked)), tmp_path / "silent.mcap"
    outcome = log_of(path, end_of(bus, "bumpless.Navigation", 79.97, None)).outcome
    assert outcome.ending is Ending.INTERRUPTED
    assert outcome.reason == "the last 10.0 s of the flight were not recorded"
    told = summarise(path)
    assert (told.outcome, told.outcome_reason) == ("interrupted", outcome.reason)


def test_a_log_without_the_last_word_of_the_truth_is_judged_by_it(docked: Run, tmp_path: Path) -> None:
    """Protects: a cut between two messages of one cycle turned a flight's judge from truth to belief."""
    said = end_of(on_bus(docked), "bumpless.TruthState", docked.columns.time[-1], None)
    found = log_of(tmp_path / "cut.mcap", said)
    assert (found.outcome.basis, found.outcome.ending) == ("true", docked.outcome.ending)
    assert len(found.columns) == len(docked.columns) - 1


def test_a_mere_glimpse_of_the_truth_judges_nothing(docked: Run, tmp_path: Path) -> None:
    """Protects: cycles are not left out because somebody said the truth of a few of them."""
    found = log_of(tmp_path / "glimpse.mcap", end_of(on_bus(docked), "bumpless.TruthState", 5.0, None))
    assert found.outcome.basis == "believed" and found.outcome.true_errors is None
    assert len(found.columns) == len(docked.columns)


def strange_cycle(message: Any) -> None:
    message.stamp.cycle = 2**62


def strange_mode(message: pb.Supervisor) -> None:
    message.mode = 99  # type: ignore[assignment]


@pytest.mark.parametrize(("kind", "change"), [("Supervisor", strange_mode), ("Navigation", strange_cycle)])
def test_what_no_contract_knows_costs_the_end_and_not_the_judge(
    docked: Run, tmp_path: Path, kind: str, change: Change
) -> None:
    """Protects: a mode of another contract, or an absurd count, left a run without any outcome."""
    bus = without_truth(on_bus(docked))
    found = log_of(tmp_path / "odd.mcap", end_of(bus, f"bumpless.{kind}", 70.0, change))
    assert found.outcome.ending is Ending.INTERRUPTED and found.metrics.cycles == len(found.columns)


@pytest.mark.parametrize("elapsed_s", [math.nan, math.inf, -1e300, 1e300])
def test_a_mission_time_that_is_none_costs_no_recording(
    docked: Run, tmp_path: Path, elapsed_s: float
) -> None:
    """Protects: a status with NaN for its time ended the recording before it began."""

    def change(message: pb.MissionStatus) -> None:
        message.elapsed_s = elapsed_s

    path = tmp_path / "timeless.mcap"
    found = log_of(path, end_of(without_truth(on_bus(docked)), "bumpless.MissionStatus", 0.0, change))
    assert found.outcome.ending is Ending.DOCKED
    told = summarise(path)
    assert told.outcome == "docked" and told.started_ns > 0


@pytest.mark.parametrize("leap_s", [-60.0, 3600.0, 1e12])
def test_a_leap_of_the_missions_time_makes_no_stay_longer(docked: Run, tmp_path: Path, leap_s: float) -> None:
    """Protects: a vehicle that hovered for two seconds and whose time then leapt had docked for an hour."""

    def leap(bus: list[Told]) -> list[Told]:
        said = []
        for time_ns, topic, kind, payload in bus:
            message: Any = decoded(kind, payload)
            if message.stamp.mission_time_s >= 87.975:
                message.stamp.mission_time_s += leap_s
                payload = encoded(message)
            said.append((time_ns, topic, kind, payload))
        return said

    outcome = log_of(tmp_path / "leap.mcap", leap(without_truth(on_bus(docked)))).outcome
    assert outcome.ending is Ending.HELD
    assert outcome.held_s == pytest.approx(2.0, abs=1e-3)
