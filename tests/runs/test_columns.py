"""A recorded run gives the same figures as the simulation it came from."""

import math
from pathlib import Path
from typing import Any

import pytest

from bumpless import NoFigures, fly, load_mission, open_run
from bumpless.config.mission import parse_mission
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Columns, as_dict, figures_of
from tests.runs.flights import Flight, begin, record

OF_TRUTH = (
    "force_step_n",
    "moment_step_nm",
    "acceleration_step_mps2",
    "angular_acceleration_step_degps2",
)


def same(one: Any, other: Any, path: str = "") -> None:
    """Equal up to the rounding of rad to deg and back."""
    if isinstance(one, dict):
        assert one.keys() == other.keys()
        for key in one:
            same(one[key], other[key], f"{path}.{key}")
    elif isinstance(one, list):
        assert len(one) == len(other), path
        for i, (a, b) in enumerate(zip(one, other, strict=True)):
            same(a, b, f"{path}[{i}]")
    elif isinstance(one, float):
        assert other == pytest.approx(one, rel=1e-9, abs=1e-9), path
    else:
        assert one == other, path


def test_metrics_from_the_file_are_the_simulations(flight: Flight) -> None:
    """One definition, two ways to the numbers: memory, and the bus's messages on a disk."""
    result = flight.result
    columns = Columns.from_log(result.log, len(result.vehicle.commands))
    direct, _ = figures_of(
        columns, result.vehicle, result.mission, "completed", run_id=flight.run.info.run_id
    )
    stored = open_run(flight.path).metrics
    assert direct.cycles == len(result.log)
    same(as_dict(direct), as_dict(stored))
    assert flight.run.metrics == stored


def test_the_flight_obeys_proposition_1(flight: Flight) -> None:
    """No increment beyond its bound and no step of the demand, in a flight through all three modes."""
    metrics = open_run(flight.path).metrics
    assert [(s.from_mode, s.to_mode) for s in metrics.switches] == [(1, 2), (2, 3)]
    assert metrics.increment_violations == 0
    assert metrics.demand_step_violations == 0


def test_without_truth_only_its_figure_is_missing(flight: Flight, tmp_path: Path) -> None:
    """A real vehicle's log has no truth/state: nothing else changes, and the outcome says what judged it."""
    path = tmp_path / "real.mcap"
    record(path, [told for told in flight.bus if told[1] != "truth/state"])
    found, full = open_run(path).metrics, open_run(flight.path).metrics
    assert as_dict(found)["residual_rms_true"] is None
    assert (found.outcome.basis, full.outcome.basis) == ("believed", "true")
    assert found.outcome.believed_errors == full.outcome.believed_errors
    for metrics in (found, full):
        metrics.ClearField("outcome")
        metrics.ClearField("residual_rms_true")
        for switch in metrics.switches:
            for name in OF_TRUTH:
                assert math.isnan(getattr(switch, name)) == (metrics is found)
                switch.ClearField(name)
    assert found == full


def is_lost(topic: str, payload: bytes) -> bool:
    return topic == "tlm/control" and pb.Control.FromString(payload).stamp.cycle in (100, 101, 500)


def test_cycles_with_a_lost_message_are_missing_cycles(flight: Flight, tmp_path: Path) -> None:
    """A dropped message costs its cycle, not the run."""
    path = tmp_path / "lossy.mcap"
    record(path, [told for told in flight.bus if not is_lost(told[1], told[3])], flush_every=3000)
    metrics = open_run(path).metrics
    assert metrics.missing_cycles == 3
    assert metrics.cycles == len(flight.result.log) - 3


def test_every_cycle_says_what_the_checks_need(flight: Flight) -> None:
    """Phase and frozen demand of each cycle: without them idle cycles count and ramps look like jumps."""
    rows = iter(flight.result.log)
    controls = iter(flight.result.log)
    for _, topic, _, payload in flight.bus:
        if topic == "tlm/supervisor":
            assert pb.Supervisor.FromString(payload).phase == next(rows)["phase"]
        elif topic == "tlm/control":
            frozen = pb.Control.FromString(payload).frozen
            kept = (frozen.x_n, frozen.y_n, frozen.z_n, frozen.k_nm, frozen.m_nm, frozen.n_nm)
            assert kept == tuple(next(controls)["tau_minus"])


def test_the_vehicle_comes_from_the_file(flight: Flight) -> None:
    """No vehicle folder is needed to read a log of another machine."""
    assert open_run(flight.path).vehicle == flight.result.vehicle


def test_a_log_without_a_mission_has_no_metrics(tmp_path: Path) -> None:
    """Nothing to measure is no error."""
    path = tmp_path / "idle.mcap"
    begin(path).finish("complete", "nothing was flown")
    with pytest.raises(NoFigures):
        open_run(path).metrics  # noqa: B018


def test_a_capture_is_the_same_from_the_file(tmp_path: Path) -> None:
    """Protects: docked by a latch, with force, seat time and offset, in memory as in a log."""
    run = fly(load_mission("docking_funnel"))
    stored = open_run(run.save(tmp_path / "funnel.mcap"))
    assert run.outcome.ending == stored.outcome.ending == "docked"
    same(as_dict(run.metrics), as_dict(stored.metrics))
    capture = stored.metrics.capture
    assert capture.captured and 0.0 < capture.force_max_n < capture.force_most_n == 300.0
    assert 5.0 < capture.seat_time_s < 15.0 and 0.0 < capture.entry_offset_m < 0.2
    assert not open_run(make_plain(tmp_path)).metrics.HasField("capture")


def make_plain(folder: Path) -> Path:
    """The log of a flight without a dock to enter."""
    text = load_mission("docking").text.replace("duration_s: 90", "duration_s: 2")
    return fly(parse_mission(text, "plain.yaml")).save(folder / "plain.mcap")
