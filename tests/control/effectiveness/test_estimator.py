"""The estimator on a plant flown open loop: what it finds, what it cannot see, what must not fool it."""

import math

import numpy as np
import pytest

from tests.control.effectiveness.open_loop import watch

DELTA_1, N_P, N_V1, N_V2 = 0, 4, 5, 6


def busy(t: float) -> list[float]:
    """Cruise at 0.7 m/s with every actuator at work: small fins, verticals against each other's wave."""
    wave = 0.05 * math.sin(0.9 * t)
    fins = [wave, -0.05 * math.sin(1.3 * t), 0.05 * math.sin(0.7 * t), -wave]
    return [*fins, 3.0 + 0.3 * math.sin(0.5 * t), 1.5 + math.sin(0.8 * t), 1.5 - math.sin(0.6 * t)]


def idle_fins(t: float) -> list[float]:
    """The same with every fin amidships."""
    return [0.0, 0.0, 0.0, 0.0, *busy(t)[4:]]


@pytest.mark.parametrize(("actuator", "bound_s"), [(DELTA_1, 4.0), (N_P, 4.0), (N_V1, 8.0), (N_V2, 11.0)])
def test_finds_the_faulty_actuator_and_how_much_is_left(actuator: int, bound_s: float) -> None:
    """Protects: detection in time, isolation, and an estimate that settles on the truth."""
    seen = watch(busy, 45.0, [(actuator, 20.0, 0.4)])
    assert 20.0 < seen.first_alarm(actuator) < 20.0 + bound_s
    assert {f for f in seen.faults if f} == {1 << actuator}
    assert np.mean([s[actuator] for s in seen.said[-100:]]) == pytest.approx(0.4, abs=0.06)


def test_a_whole_vehicle_is_left_alone_however_loud_its_sensors() -> None:
    """Protects: no false alarm in noise four times the sensors' own figures."""
    for seed in (1, 2, 3):
        assert not any(watch(busy, 60.0, seed=seed, noise_scale=4.0).faults)


def test_two_faults_one_after_the_other() -> None:
    """Protects: a second fault is found though the first one is being followed."""
    seen = watch(busy, 60.0, [(N_P, 15.0, 0.5), (N_V2, 35.0, 0.3)])
    assert seen.faults[-1] == 1 << N_P | 1 << N_V2
    assert seen.said[-1][N_P] == pytest.approx(0.5, abs=0.06)
    assert seen.said[-1][N_V2] == pytest.approx(0.3, abs=0.1)


def test_an_actuator_that_works_again_is_cleared() -> None:
    """Protects: a fault that is over does not keep the allocator from using the actuator."""
    seen = watch(busy, 60.0, [(N_P, 15.0, 0.4), (N_P, 35.0, 1.0)])
    assert any(seen.faults) and seen.faults[-1] == 0
    assert (seen.said[-1] == 1.0).all() and (seen.heard[-1] == 1.0).all()


def test_an_idle_fin_cannot_be_diagnosed() -> None:
    """Protects: the stated limit; what is not excited gets neither blame nor a number."""
    seen = watch(idle_fins, 45.0, [(DELTA_1, 20.0, 0.4)])
    assert not any(seen.faults)


def test_the_allocator_hears_of_a_loss_over_two_seconds() -> None:
    """Protects: reconfiguration is blended, so that no belief jumps in one cycle."""
    seen = watch(busy, 45.0, [(N_P, 20.0, 0.4)])
    heard = np.array(seen.heard)[:, N_P]
    alarm = round(seen.first_alarm(N_P) / 0.05)
    assert np.all(heard[:alarm] == 1.0)
    assert np.abs(np.diff(heard)).max() < 0.05
    assert heard[alarm + 20] > 0.6 > heard[alarm + 45]


def test_a_sample_that_is_no_number_begins_the_baseline_anew() -> None:
    """Protects: one broken sample neither poisons the filters nor makes a fault of what follows."""

    def spoil(t: float, m: np.void) -> None:
        if 25.0 <= t < 25.3:
            m["velocity"][0] = np.nan
            m["u_feedback"][N_P] = np.nan

    seen = watch(busy, 60.0, [(N_P, 40.0, 0.4)], spoil=spoil)
    assert 40.0 < seen.first_alarm(N_P) < 44.0
    assert np.isfinite(seen.said).all()
