"""The checks of Proposition 1 find what breaks it, and nothing else."""

from collections.abc import Callable

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bumpless.contract.enums import FORWARD, MODES, REVERSE
from bumpless.metrics import Columns
from bumpless.metrics.proposition import demand_step_violations, increment_violations

MakeRun = Callable[..., Columns]
BOUND = np.full(7, 1.0)


def ramped(tau_plus: np.ndarray, switches: list[int], n_sw: int) -> dict[str, np.ndarray]:
    """Columns of a run that follows eqs. (54) and (55) for these raw demands and switch rows."""
    n = len(tau_plus)
    mode, kappa = np.full(n, FORWARD), np.ones(n)
    tau_d, tau_minus = np.zeros((n, 6)), np.zeros((n, 6))
    tau_d[0], k_s = tau_plus[0], -n_sw
    for k in range(1, n):
        mode[k], tau_minus[k] = mode[k - 1], tau_minus[k - 1]
        if k in switches:
            mode[k], tau_minus[k], k_s = FORWARD + mode[k] % len(MODES), tau_d[k - 1], k
        kappa[k] = min(1.0, (k - k_s) / n_sw)
        tau_d[k] = (1.0 - kappa[k]) * tau_minus[k] + kappa[k] * tau_plus[k]
    return {"mode": mode, "kappa": kappa, "tau_d": tau_d, "tau_plus": tau_plus, "tau_minus": tau_minus}


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    seed=st.integers(0, 2**32 - 1),
    switches=st.lists(st.integers(1, 118), max_size=5),
    n_sw=st.integers(1, 60),
)
def test_the_published_ramp_never_breaks_it(
    make_run: MakeRun, seed: int, switches: list[int], n_sw: int
) -> None:
    """Whatever is demanded, whenever modes change, also in the middle of a ramp."""
    tau_plus = np.random.default_rng(seed).normal(0.0, 5.0, (120, 6))
    assert demand_step_violations(make_run(120, **ramped(tau_plus, switches, n_sw))) == 0


def test_a_hard_switch_is_found_once(make_run: MakeRun) -> None:
    """Without the ramp the demand jumps at the switch, and only there."""
    tau_plus = np.zeros((60, 6))
    tau_plus[30:, 0] = 4.0
    columns = ramped(tau_plus, [], 1)
    columns["mode"][30:] = REVERSE
    assert demand_step_violations(make_run(60, **columns)) == 1


def test_a_jump_in_the_middle_of_a_ramp_is_found(make_run: MakeRun) -> None:
    """A demand that does not lie between its two ends is no ramp."""
    columns = ramped(np.ones((60, 6)), [20], 20)
    columns["tau_d"][30] += 0.5
    assert demand_step_violations(make_run(60, **columns)) == 2


def test_a_gap_excuses_a_step(make_run: MakeRun) -> None:
    """Of cycles that are not in the log nothing is known."""
    tau_plus = np.zeros((60, 6))
    tau_plus[30:, 0] = 4.0
    columns = ramped(tau_plus, [], 1)
    columns["mode"][30:] = REVERSE
    cycle = np.arange(60)
    cycle[30:] += 1
    assert demand_step_violations(make_run(60, cycle=cycle, **columns)) == 0


def test_increments_up_to_the_bound_pass(make_run: MakeRun) -> None:
    """Exactly the bound is within it, also after a conversion to degrees and back."""
    u = np.cumsum(np.full((40, 7), 0.02), axis=0)
    assert increment_violations(make_run(40, u=np.radians(np.degrees(u))), -BOUND, BOUND) == 0


def test_an_increment_beyond_the_bound_is_found(make_run: MakeRun) -> None:
    """One actuator in one cycle is enough."""
    u = np.zeros((40, 7))
    u[10:, 3] = 0.0201
    assert increment_violations(make_run(40, u=u), -BOUND, BOUND) == 1


def test_a_command_beyond_its_amplitude_is_found(make_run: MakeRun) -> None:
    """However slowly it got there; every cycle out there counts."""
    u = np.zeros((100, 7))
    u[:, 6] = np.minimum(0.011 * np.arange(100), 1.005)
    beyond = int((u[:, 6] > 1.0 + 2e-6).sum())
    assert beyond > 0
    assert increment_violations(make_run(100, u=u), -BOUND, BOUND) == beyond
