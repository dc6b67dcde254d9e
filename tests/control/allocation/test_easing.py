"""Easing of a screw: what it misses away from zero is made up for; increments are priced as commands."""

import numpy as np
import pytest

from bumpless.config.vehicle import load_vehicle
from bumpless.control.allocation.easing import missed_wrench
from bumpless.control.allocation.mdca import increment_prices
from bumpless.physics.actuators import FIN, to_command, to_x
from bumpless.physics.actuators.thruster import thrust_scale
from bumpless.physics.model import build_model


@pytest.fixture
def model():
    out = build_model(load_vehicle("ts100"))
    out["smoothing"] = 0.07
    return out


def screw(model) -> int:
    """The main propeller: it pushes along x alone."""
    return 4


def thrust(model, n: float) -> float:
    """Bollard thrust over its largest at n rev/s."""
    return float(n * abs(n) / model["command_max"][screw(model)] ** 2)


@pytest.mark.parametrize("wanted", [-0.9, -0.3, 0.2, 0.6, 0.95])
def test_a_steady_demand_away_from_zero_is_met(model: np.ndarray, wanted: float) -> None:
    """Protects: asked for once more in every cycle, what easing misses comes, and does not run away."""
    i, u, missed = screw(model), np.zeros(8), np.zeros(6)
    scale = thrust_scale(model, i)
    for _ in range(200):
        missed_wrench(model, u, np.ones(8), missed)
        u[i] = to_command(model, i, wanted + missed[0] / scale)
    eased = thrust(model, to_command(model, i, wanted))
    assert abs(thrust(model, u[i]) - wanted) < 0.3 * abs(eased - wanted)
    assert missed[1:].any() == 0


def test_commands_near_zero_stay_as_calm_as_without(model: np.ndarray) -> None:
    """Protects: within the eased range next to nothing is asked for: no screw is driven to and fro."""
    i, u, missed = screw(model), np.zeros(8), np.zeros(6)
    for x in (-0.01, 0.0, 0.01):
        u[i] = to_command(model, i, x)
        missed_wrench(model, u, np.ones(8), missed)
        assert abs(missed[0]) <= 0.03 * abs(x) * thrust_scale(model, i)


def test_without_easing_nothing_is_missed(model: np.ndarray) -> None:
    """Protects: the map that is not eased is left alone, and fins always are."""
    u, missed = np.full(8, 0.1), np.ones(6)
    model["smoothing"] = 0.0
    missed_wrench(model, u, np.ones(8), missed)
    assert not missed.any()


@pytest.mark.parametrize("x", [-0.8, -0.05, 0.003, 0.1, 0.7])
def test_price_is_that_of_commands(model: np.ndarray, x: float) -> None:
    """Protects: mu ||u - u_prev||^2 in the decision variables, by a difference of the map itself."""
    price, point = np.zeros(8), np.full(8, x)
    increment_prices(model, 3.0, point, model["n_u"], price)
    for i in range(model["n_u"]):
        ends = [to_command(model, i, x + side) / model["command_max"][i] for side in (1e-6, -1e-6)]
        slope = (ends[0] - ends[1]) / 2e-6
        assert price[i] == pytest.approx(3.0 * slope**2, rel=1e-4), model["kind"][i] == FIN
        assert to_x(model, i, to_command(model, i, x)) == pytest.approx(x)


def test_no_price_is_no_price(model: np.ndarray) -> None:
    """Protects: outside ramps, and with the price off, the published cost."""
    price = np.ones(8)
    increment_prices(model, 0.0, np.zeros(8), model["n_u"], price)
    assert not price[: model["n_u"]].any()
