"""Each figure equals what its definition gives by hand."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.metrics import Columns, as_dict, metrics_of
from bumpless.sim.log import LOG

MakeRun = Callable[..., Columns]


def test_residual_counts_controllable_components_only(make_run: MakeRun, ts100: Vehicle) -> None:
    """Sway (Y) has no actuator: what fins push sideways is no allocation error. RMS of a constant 5 is 5."""
    tau_d, tau_c = np.zeros((40, 6)), np.zeros((40, 6))
    tau_d[:, 0], tau_c[:, 4], tau_c[:, 1] = 3.0, 4.0, 100.0
    metrics = metrics_of(make_run(40, tau_d=tau_d, tau_c=tau_c), ts100)
    assert metrics.residual_rms == pytest.approx(5.0)
    assert metrics.residual_rms_true == pytest.approx(3.0)


def test_without_truth_its_figure_is_absent(make_run: MakeRun, ts100: Vehicle) -> None:
    """A real vehicle knows no true wrench: NaN, and null in JSON."""
    metrics = metrics_of(make_run(10, tau=np.full((10, 6), np.nan)), ts100)
    assert math.isnan(metrics.residual_rms_true)
    assert as_dict(metrics)["residual_rms_true"] is None


def test_saturation_counts_cycles_not_actuators(make_run: MakeRun, ts100: Vehicle) -> None:
    """Three actuators at their bounds in one cycle of ten are 10 %; near is not at."""
    u = np.zeros((10, 7))
    u[3, 0], u[3, 1], u[3, 4] = math.radians(15.0), -math.radians(15.0), 200.0 / 60.0
    u[5, 4] = 0.999 * 200.0 / 60.0
    assert metrics_of(make_run(10, u=u), ts100).saturation_ratio == pytest.approx(0.1)


def test_switch_steps_are_taken_over_bounds_and_within_two_seconds(make_run: MakeRun, ts100: Vehicle) -> None:
    """3 deg of 15 and 30 rpm of 200 are 0.2 and 0.15; what lies 3 s away does not count."""
    n = 200
    mode = np.where(np.arange(n) < 100, FORWARD, REVERSE)
    u = np.zeros((n, 7))
    u[110:, 0] = math.radians(3.0)
    u[110:, 4] = -30.0 / 60.0
    u[165:, 1] = math.radians(14.0)
    metrics = metrics_of(make_run(n, mode=mode, u=u), ts100)
    (switch,) = metrics.switches
    assert (switch.from_mode, switch.to_mode) == (pb.MODE_FORWARD, pb.MODE_REVERSE)
    assert switch.time_s == pytest.approx(5.0)
    assert switch.command_step_normalised == pytest.approx(math.hypot(0.2, 0.15))
    assert switch.command_step_raw == pytest.approx(math.hypot(3.0, 30.0))
    assert list(switch.actuator_step) == pytest.approx([3.0, 0, 0, 0, 30.0, 0, 0])
    assert metrics.d_u_fr == switch.command_step_normalised
    assert math.isnan(metrics.d_u_rh)


def test_mode_figures_are_about_each_stay(make_run: MakeRun, ts100: Vehicle) -> None:
    """Two stays in H at different depths: RMS about each one's own mean, peak-to-peak of the worse."""
    n = 120
    mode = np.full(n, HOVER)
    mode[40:80] = REVERSE
    depth = np.full(n, 2.0)
    depth[:40:2], depth[80::2] = 2.2, 3.0
    eta = np.zeros((n, 6))
    eta[:, 5] = math.pi - 0.001 + 0.002 * (np.arange(n) % 2)
    eta[:, 5] = np.where(eta[:, 5] > math.pi, eta[:, 5] - 2 * math.pi, eta[:, 5])
    hover = next(
        m
        for m in metrics_of(make_run(n, mode=mode, depth=depth, eta_hat=eta), ts100).modes
        if m.mode == HOVER
    )
    assert (hover.samples, hover.duration_s) == (80, pytest.approx(4.0))
    assert hover.depth_rms_m == pytest.approx(math.sqrt((0.1**2 + 0.5**2) / 2))
    assert hover.depth_peak_to_peak_m == pytest.approx(1.0)
    assert hover.yaw_rms_deg == pytest.approx(math.degrees(0.001))


def test_a_gap_in_the_log_is_counted_and_never_spanned(make_run: MakeRun, ts100: Vehicle) -> None:
    """Lost cycles must not look like a jump of the commands."""
    n = 40
    cycle = np.arange(n)
    cycle[20:] += 5
    u = np.zeros((n, 7))
    u[20:, 0] = 0.2
    mode = np.where(np.arange(n) < 20, FORWARD, REVERSE)
    metrics = metrics_of(make_run(n, cycle=cycle, u=u, mode=mode), ts100)
    assert metrics.missing_cycles == 5
    assert metrics.increment_violations == 0
    assert metrics.d_u_fr == 0.0


def test_solve_times_and_solved_share(make_run: MakeRun, ts100: Vehicle) -> None:
    """Percentiles in µs; only SOLVED counts as solved."""
    status = np.array([1] * 9 + [2])
    metrics = metrics_of(make_run(10, status=status, solve_time=np.arange(10) * 1e-6), ts100)
    assert metrics.solve_time_mean_us == pytest.approx(4.5)
    assert metrics.solve_time_max_us == pytest.approx(9.0)
    assert metrics.solved_ratio == pytest.approx(0.9)


def test_an_empty_run_has_no_figures(ts100: Vehicle) -> None:
    """A mission aborted before its first cycle is no error."""
    run = Columns.from_log(np.zeros(0, LOG), 7)
    assert (len(run), run.missing) == (0, 0)
    assert metrics_of(run, ts100).cycles == 0


def test_only_cycles_of_the_mission_count(ts100: Vehicle) -> None:
    """Idle, completed and aborted rows around a run are left out; paused ones belong to it."""
    log = np.zeros(6, LOG)
    log["phase"] = [1, 2, 2, 3, 4, 5]
    log["cycle"] = np.arange(6)
    assert list(Columns.from_log(log, 7).cycle) == [1, 2, 3]
