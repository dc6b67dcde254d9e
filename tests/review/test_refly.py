"""Counterfactuals: a run flown again is the same flight, and differs where it was told to."""

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import bumpless
from bumpless.config.parameters import ParameterError
from bumpless.review.refly import knows_truth, refly, seen
from bumpless_server.cli.main import app

MISSION = Path(__file__).parents[2] / "missions" / "docking_current.yaml"


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return bumpless.fly(MISSION, seed=3).save(tmp_path_factory.mktemp("logs") / "flown.mcap")


@pytest.fixture(scope="module")
def run(log: Path) -> bumpless.Run:
    return bumpless.open_run(log)


def test_with_nothing_changed_it_is_the_same_flight(run: bumpless.Run) -> None:
    """Protects every comparison with a counterfactual: what differs comes from what was changed alone."""
    again = refly(run)
    assert again.info.seed == 3
    np.testing.assert_array_equal(again.columns.eta, run.columns.eta)


def test_what_is_changed_is_flown_and_recorded(run: bumpless.Run) -> None:
    """Protects the new run's own word on what it was flown with."""
    again = refly(run, {"hover.lambda": 0.5, "allocation.allocator": "wls"})
    assert again.parameters is not None and again.parameters.allocation.allocator == "wls"
    assert not np.array_equal(again.columns.u, run.columns.u)


def test_as_seen_is_the_world_that_the_vehicle_believed_in(run: bumpless.Run) -> None:
    """Protects flying a real vehicle's log again: its current, target and start, said in the mission."""
    assert run.mission is not None and run.vehicle is not None
    world = seen(run, run.mission, run.vehicle)
    true = run.mission.environment.current_ned_mps
    assert world.environment.current_ned_mps == pytest.approx(true, abs=0.05)
    assert world.target.true_position_ned_m == pytest.approx(tuple(run.columns.target[-1, :3]), abs=1e-3)
    assert world.text != run.mission.text
    again = refly(run, as_seen=True)
    assert again.mission == world
    assert knows_truth(run)


def test_another_vehicle_flies_with_its_own_numbers(run: bumpless.Run) -> None:
    """Protects from weights of one vehicle on another."""
    other = bumpless.load_vehicle("bluerov2_heavy")
    again = refly(run, vehicle=other)
    assert again.info.vehicle == "bluerov2_heavy"


@pytest.mark.parametrize(
    "change", [{"hover.lamda": 1}, {"hover.lambda": -1}, {"hover": 1}, {"hover.lambda": "x"}]
)
def test_what_breaks_a_rule_is_refused(run: bumpless.Run, change: dict) -> None:
    """Protects from flying something else than was asked."""
    with pytest.raises(ParameterError):
        refly(run, change)


def test_the_command_compares_at_once(log: Path, tmp_path: Path) -> None:
    """Protects `bumpless refly`: one command from a log to what would have been, and refusals."""
    out = tmp_path / "again.mcap"
    done = CliRunner().invoke(app, ["refly", str(log), "--set", "hover.lambda=0.5", "-o", str(out)])
    assert done.exit_code == 0, done.output
    assert "parameters hover.lambda" in done.stdout and "Residual RMS" in done.stdout
    assert bumpless.open_run(out).outcome is not None
    refused = CliRunner().invoke(app, ["refly", str(log), "--set", "hover.lambda=-1", "-o", str(out)])
    assert refused.exit_code == 1 and "hover.lambda" in refused.stderr
    same = CliRunner().invoke(app, ["refly", str(log), "-o", str(log)])
    assert same.exit_code == 2 and "replace the log" in same.stderr
