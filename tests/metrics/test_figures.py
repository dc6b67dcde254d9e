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
    """Lost cycles must not look like a jump of the commands, nor a switch among them like a smooth one."""
    n = 40
    cycle = np.arange(n)
    cycle[20:] += 5
    u = np.zeros((n, 7))
    u[20:, 0] = 0.2
    mode = np.where(np.arange(n) < 20, FORWARD, REVERSE)
    metrics = metrics_of(make_run(n, cycle=cycle, u=u, mode=mode), ts100)
    assert metrics.missing_cycles == 5
    assert metrics.increment_violations == 0
    assert math.isnan(metrics.d_u_fr) and math.isnan(metrics.d_u_fr_settling)
    mode = np.where(np.arange(n) < 30, FORWARD, REVERSE)
    assert metrics_of(make_run(n, cycle=cycle, u=u, mode=mode), ts100).d_u_fr == 0.0


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


def test_a_step_after_the_ramp_is_not_hidden_by_the_window(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: what a ramp defers to its end counts; the paper's window shows nothing of it."""
    n = 1000  # 50 s
    mode = np.where(np.arange(n) < 100, FORWARD, REVERSE)  # at 5 s
    kappa = np.ones(n)
    kappa[100:200] = np.linspace(0.01, 1.0, 100)  # until 9.95 s, so the window ends at 24.95 s
    u, tau, nu = np.zeros((n, 7)), np.zeros((n, 6)), np.zeros((n, 6))
    u[220:, 0], u[510:, 1] = math.radians(3.0), math.radians(15.0)
    tau[300:, 0], tau[300:, 1], tau[310:, 5] = 0.3, 0.4, 0.2
    nu[330:, 0], nu[340:, 4] = 0.01, math.radians(0.2)  # 0.2 m/s^2 and 4 deg/s^2, in one cycle
    run = make_run(n, mode=mode, kappa=kappa, u=u, tau=tau, nu=nu)
    metrics = metrics_of(run, ts100)
    (switch,) = metrics.switches
    assert switch.command_step_normalised == 0.0
    assert switch.command_step_settling == metrics.d_u_fr_settling == pytest.approx(0.2)
    assert switch.settling_s == pytest.approx(19.95)
    assert (switch.force_step_n, switch.moment_step_nm) == (pytest.approx(0.5), pytest.approx(0.2))
    assert switch.acceleration_step_mps2 == pytest.approx(0.2)
    assert switch.angular_acceleration_step_degps2 == pytest.approx(4.0)
    blind = metrics_of(make_run(n, mode=mode, kappa=kappa, tau=np.full((n, 6), np.nan)), ts100).switches[0]
    assert math.isnan(blind.force_step_n) and blind.command_step_settling == 0.0


def test_settling_ends_with_the_next_switch_and_spans_no_gap(make_run: MakeRun, ts100: Vehicle) -> None:
    """The next switch's own step is its own; lost cycles are no jump."""
    n = 300
    mode = np.where(np.arange(n) < 100, FORWARD, np.where(np.arange(n) < 200, REVERSE, HOVER))
    u, cycle, nu = np.zeros((n, 7)), np.arange(n), np.zeros((n, 6))
    u[200:, 0] = math.radians(15.0)
    u[150:, 1], nu[150:, 0] = 0.1, 1.0
    cycle[150:] += 7
    first, second = metrics_of(make_run(n, mode=mode, u=u, cycle=cycle, nu=nu), ts100).switches
    assert (first.command_step_settling, first.acceleration_step_mps2) == (0.0, 0.0)
    assert first.settling_s == pytest.approx(4.95)
    assert second.command_step_settling == pytest.approx(1.0)


def test_tracking_is_about_the_reference_not_about_the_mean(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: a vehicle that holds the wrong depth perfectly still must not look good."""
    n = 40
    eta, nu, reference = np.zeros((n, 6)), np.zeros((n, 6)), np.zeros((n, 6))
    eta[:, 2], reference[:, 2] = 2.0, 1.5
    eta[:, 5], reference[:, 5] = -math.pi + 0.01, math.pi - 0.02  # 0.03 rad across the seam
    nu[:, 0], reference[:, 0] = 0.4, np.where(np.arange(n) % 2, 0.3, 0.6)
    run = make_run(n, eta_hat=eta, nu_hat=nu, reference=reference, cross_track=np.full(n, -0.2))
    (mode,) = metrics_of(run, ts100).modes
    assert mode.depth_rms_m == 0.0
    assert (mode.depth_error_rms_m, mode.depth_error_max_m) == (pytest.approx(0.5), pytest.approx(0.5))
    assert (mode.cross_track_error_rms_m, mode.cross_track_error_max_m) == (pytest.approx(0.2), 0.2)
    assert mode.heading_error_max_deg == pytest.approx(math.degrees(0.03))
    assert mode.speed_error_rms_mps == pytest.approx(math.sqrt((0.1**2 + 0.2**2) / 2))
    assert mode.speed_error_max_mps == pytest.approx(0.2)


def test_cost_is_the_work_of_the_shafts_the_way_of_the_fins_and_reversals(
    make_run: MakeRun, ts100: Vehicle
) -> None:
    """By hand: Q = rho D^5 K_Q n^2 at rest, less with inflow; a screw at rest has no sense to change."""
    n = 100
    u, flow = np.zeros((n, 7)), np.zeros((n, 3))
    u[:, 4] = 2.0  # rev/s
    u[50:, 0] = math.radians(3.0)
    u[60:, 0] = math.radians(-1.0)
    u[:, 5] = np.where(np.arange(n) % 20 < 10, 0.5, -0.5)
    u[:, 6] = np.where(np.arange(n) % 2, 0.01, -0.01)  # trembles about zero
    metrics = metrics_of(make_run(n, u_feedback=u), ts100)
    main = 2 * math.pi * 2.0 * 1000.0 * 0.18**5 * 0.0286 * 2.0**2
    small = 2 * math.pi * 0.5 * 1000.0 * 0.107**5 * 0.016 * 0.5**2
    still = 2 * math.pi * 0.01 * 1000.0 * 0.107**5 * 0.016 * 0.01**2
    assert metrics.shaft_energy_j == pytest.approx((main + small + still) * 5.0)
    assert metrics.fin_travel_deg == pytest.approx(7.0)
    assert metrics.screw_reversals == 9
    flow[:, 0] = 0.2
    ahead = metrics_of(make_run(n, u_feedback=u, nu_r_hat=flow), ts100).shaft_energy_j
    less = 2 * math.pi * 2.0 * 1000.0 * 0.18**4 * 0.016 * 2.0 * 0.7 * 0.2
    assert metrics.shaft_energy_j - ahead == pytest.approx(less * 5.0)
