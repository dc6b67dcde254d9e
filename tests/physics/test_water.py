"""The sea: a current that changes with depth, the wake of a dock, suction under waves."""

import numpy as np
import pytest

from bumpless.physics.plant import PLANT, state_rate
from bumpless.physics.sensors import N_NOISE
from bumpless.physics.water import ENVIRONMENT, GRAVITY, step_gust, water_velocity


def sea(**said: object) -> np.void:
    out = np.zeros(1, ENVIRONMENT)[0]
    for name, value in said.items():
        out[name] = value
    return out


def at(environment: np.void, *place: float, time: float = 0.0, gust: np.ndarray | None = None) -> tuple:
    velocity, acceleration = np.zeros(3), np.zeros(3)
    stirred = np.zeros(6) if gust is None else gust
    water_velocity(environment, stirred, time, np.array([*place, 0.0, 0.0, 0.0]), velocity, acceleration)
    return velocity, acceleration


def test_the_current_follows_its_profile() -> None:
    """Protects: linear between the depths of the profile, constant above and below, on top of the mean."""
    water = sea(current=[0.1, 0.0, 0.0], n_profile=3)
    water["profile_depth"][:3] = 2.0, 6.0, 10.0
    water["profile_current"][:3] = [[0.2, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.0]]
    for depth, expected in ((0, (0.3, 0)), (2, (0.3, 0)), (4, (0.2, 0.05)), (6, (0.1, 0.1)), (8, (0.1, 0.05)),
                            (10, (0.1, 0)), (50, (0.1, 0))):  # fmt: skip
        np.testing.assert_allclose(at(water, 3.0, 4.0, depth)[0], [*expected, 0.0], atol=1e-12)
    water["n_profile"] = 1
    np.testing.assert_allclose(at(water, 0.0, 0.0, 9.0)[0], [0.3, 0.0, 0.0])


WAKE = {"shelter_width": 1.2, "shelter_drag": 0.9, "shelter_growth": 0.06, "shelter_place": [5.0, -2.0, 4.0]}


def behind(flow: np.ndarray, x: float, y: float, z: float) -> tuple[float, float, float]:
    """A place x m downstream of the dock, y to starboard of the flow, z below."""
    n, e = flow[:2] / np.hypot(*flow[:2])
    return 5.0 + x * n - y * e, -2.0 + x * e + y * n, 4.0 + z


@pytest.mark.parametrize("x", [1.5, 4.0, 12.0])
def test_the_wake_has_lost_the_momentum_that_the_drag_took(x: float) -> None:
    """Protects: at every section the momentum lost is the dock's drag, 1/2 rho C_D U^2 A (conservation)."""
    flow = np.array([-0.12, 0.09, 0.0])  # 0.15 m/s, and not along an axis
    water, grid = sea(current=flow, **WAKE), np.linspace(-6.0, 6.0, 121)
    lost = 0.0
    for y in grid:
        for z in grid:
            u = np.hypot(*at(water, *behind(flow, x, y, z))[0][:2])
            lost += u * (0.15 - u) * (grid[1] - grid[0]) ** 2
    assert lost == pytest.approx(0.5 * 0.9 * 0.15**2 * np.pi / 4 * 1.2**2, rel=1e-3)


def test_a_wake_is_behind_and_nowhere_else() -> None:
    """Protects: no shelter upstream, aside or without a current; no jump where one passes the dock."""
    flow = np.array([0.15, 0.0, 0.0])
    water = sea(current=flow, **WAKE)
    for place in ((-0.5, 0.0, 0.0), (3.0, 5.0, 0.0), (3.0, 0.0, 5.0)):
        np.testing.assert_allclose(at(water, *behind(flow, *place))[0], flow, atol=1e-6)
    line = np.array([at(water, *behind(flow, x, 0.1, 0.0))[0][0] for x in np.arange(-1.0, 8.0, 0.01)])
    assert np.abs(np.diff(line)).max() < 0.002 and line.min() < 0.09
    np.testing.assert_array_equal(at(sea(**WAKE), *behind(flow, 1.0, 0.0, 0.0))[0], np.zeros(3))


def test_eddies_have_the_strength_and_the_time_of_the_wake() -> None:
    """Protects: deviation as the share said of the current taken away, correlated as long as water passes."""
    flow, rng, gust = np.array([0.3, 0.0, 0.0]), np.random.default_rng(3), np.zeros(6)
    water = sea(current=flow, shelter_turbulence=0.4, **WAKE)
    still = at(water, *behind(flow, 4.0, 0.0, 0.0))[0][0]
    heard = []
    for _ in range(60_000):
        step_gust(water, gust, 0.2, rng.standard_normal(N_NOISE))
        heard.append(at(water, *behind(flow, 4.0, 0.0, 0.0), gust=gust)[0])
    eddies = np.array(heard) - [still, 0.0, 0.0]
    np.testing.assert_allclose(eddies.std(axis=0), 0.4 * (0.3 - still), rtol=0.08)
    lag = round(1.2 / 0.3 / 0.2)
    assert np.corrcoef(eddies[:-lag, 1], eddies[lag:, 1])[0, 1] == pytest.approx(np.exp(-1), abs=0.06)


WAVE = {"wave_height": 0.6, "wave_period": 4.0, "wave_direction": 0.8}


def test_the_second_order_is_the_convective_acceleration() -> None:
    """Protects: what the switch adds is (u . grad) u of the wave's own velocity, by finite differences."""
    place, h = np.array([3.0, 1.0, 2.5]), 1e-4
    for time in (0.0, 0.7, 1.9):
        velocity, first = at(sea(**WAVE), *place, time=time)
        gradient = np.zeros((3, 3))
        for j in range(3):
            ahead, back = place.copy(), place.copy()
            ahead[j] += h
            back[j] -= h
            gradient[:, j] = (
                at(sea(**WAVE), *ahead, time=time)[0] - at(sea(**WAVE), *back, time=time)[0]
            ) / (2 * h)
        second = at(sea(**WAVE, wave_second_order=1), *place, time=time)[1]
        np.testing.assert_allclose(second - first, gradient @ velocity, atol=1e-7)


def test_waves_suck_a_hull_held_below_them_upwards(model: np.record) -> None:
    """Protects: the mean force on a body held still is (rho V + M_A33) k u^2 upwards, u the orbital speed:
    2 rho A k (a omega e^-kz)^2 a metre of a circular cylinder (Ogilvie 1963 in long waves); none without."""
    omega, depth = 2 * np.pi / 4.0, 2.0
    k = omega**2 / GRAVITY
    u = 0.3 * omega * np.exp(-k * depth)
    plant, rate, x = np.zeros(1, PLANT)[0], np.zeros(20), np.zeros(20)
    x[2], x[5] = depth, 0.8
    hull = model.copy()
    for name in ("D_linear", "D_quadratic", "D_lift", "fin_area", "T_nn", "T_nv", "T_nn_reverse"):
        hull[name] = 0.0  # what is left is inertia and pressure
    hull["r_b"], hull["r_g"] = 0.0, 0.0
    inertia = hull["M_RB"] + hull["M_A"]
    pull = {}
    for order in (0, 1):
        water, mean = sea(**WAVE, wave_second_order=order), 0.0
        for time in np.linspace(0.0, 4.0, 400, endpoint=False):
            state_rate(hull, water, np.zeros(6), plant["effectiveness"], time, x, np.zeros(8), rate)
            mean += (inertia @ rate[6:12])[2] / 400
        pull[order] = mean
    displaced = hull["M_RB"][0, 0] * hull["buoyancy"] / hull["weight"]
    expected = -(displaced + hull["M_A"][2, 2]) * k * u**2
    assert pull[1] - pull[0] == pytest.approx(expected, rel=1e-6)
    assert abs(pull[0]) < 0.02 * abs(expected)
