"""A twin put where a vehicle is now: it goes on as the vehicle does, and refuses what it can't go on from."""

import numpy as np
import pytest
from google.protobuf.message import Message

from bumpless import Run, fly
from bumpless.contract.enums import ENTRY
from bumpless.sim.present import PresentTwin, Said


@pytest.fixture(scope="module")
def run() -> Run:
    return fly("docking", started_ns=0)


def said(run: Run, time_s: float) -> Said:
    """The newest messages at that time."""
    latest: dict[str, Message] = {}
    for topic, message in run.messages():
        if message.stamp.mission_time_s > time_s + 1e-6:  # type: ignore[attr-defined]
            break
        latest[topic.removeprefix("tlm/")] = message
    return Said(**{name: latest[name] for name in Said.__dataclass_fields__})  # type: ignore[arg-type]


def twin(run: Run, told: Said) -> PresentTwin:
    assert run.vehicle and run.mission and run.parameters
    return PresentTwin(run.vehicle, run.mission, run.parameters, told)


@pytest.mark.parametrize("time_s", [5.0, 28.0, 30.0, 33.0, 35.0, 70.0])
def test_it_goes_on_as_the_vehicle_does(run: Run, time_s: float) -> None:
    """Protects the forecast: the same demand at once, and for 10 s the same place and depth, in all modes."""
    log = twin(run, said(run, time_s)).ahead(201)
    first = round(time_s / 0.05)
    columns = run.columns
    np.testing.assert_allclose(log["tau_plus"][0], columns.tau_plus[first], atol=0.02)
    apart = np.linalg.norm(log["eta"][:, :2] - columns.eta_hat[first : first + 201, :2], axis=1)
    assert apart.max() < 0.25
    assert np.abs(log["eta"][:, 2] - columns.eta_hat[first : first + 201, 2]).max() < 0.05
    assert int(log["mode"][0]) == int(columns.mode[first])


@pytest.mark.parametrize("time_s", [25.0, 55.0])
def test_it_goes_on_round_as_the_vehicle_does(time_s: float) -> None:
    """Protects the forecast on a way round: it knew neither side nor turn, and was 3 m off in 10 s."""
    run = fly("docking_into_current", started_ns=0)
    log, first = twin(run, said(run, time_s)).ahead(201), round(time_s / 0.05)
    assert int(run.columns.stage[first]) == ENTRY
    apart = np.linalg.norm(log["eta"][:, :2] - run.columns.eta_hat[first : first + 201, :2], axis=1)
    assert apart.max() < 0.25


def test_the_switch_ahead_is_the_one_that_comes(run: Run) -> None:
    """Protects the answer to "when does it go into reverse": from 15 s before, to half a second."""
    columns = run.columns
    switch = int(np.flatnonzero(np.diff(columns.mode))[0]) + 1
    at = switch * 0.05
    log = twin(run, said(run, at - 15.0)).ahead(500)
    ahead = int(np.flatnonzero(np.diff(log["mode"]))[0]) + 1
    assert ahead * 0.05 == pytest.approx(15.0, abs=0.5)
    assert log["mode"][ahead] == columns.mode[switch]


def test_trials_leave_nothing_behind(run: Run) -> None:
    """Protects "as it is" beside a draft: two twins of one moment fly the same to the bit."""
    told = said(run, 20.0)
    one, other = (twin(run, told).ahead(100) for _ in range(2))
    assert one["eta"].tobytes() == other["eta"].tobytes()


def test_what_cannot_be_flown_on_is_refused(run: Run) -> None:
    """Protects from forecasts out of nothing: no mission, no numbers, another vehicle's actuators."""
    idle = said(run, 20.0)
    idle.supervisor.phase = 1  # type: ignore[assignment]
    with pytest.raises(ValueError, match="no mission is running"):
        twin(run, idle)
    strange = said(run, 20.0)
    strange.navigation.position_ned_m.x = float("nan")
    with pytest.raises(ValueError, match="not finite"):
        twin(run, strange)
    other = said(run, 20.0)
    del other.actuators.actuators[-1]
    with pytest.raises(ValueError, match="other actuators"):
        twin(run, other)
