"""Contact with a dock: springs that conserve energy, friction that only takes, forces as in closed form."""

from math import atan2, radians, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.vehicle import load_vehicle
from bumpless.physics.dock.contact import N_WORK, POINTS, dock_contact, hull_rings
from bumpless.physics.dock.record import CONTACT, DOCK
from bumpless.physics.frames import body_to_ned, euler_rates
from bumpless.physics.hydrodynamics.myring import HullStrips

HULL = HullStrips(load_vehicle("ts100").hull)  # type: ignore[arg-type]
RINGS = hull_rings(HULL.x[::-1], HULL.radius[::-1])
NOSE_M = float(HULL.x[-1])


def dock(**changes) -> np.ndarray:
    """A funnel of 1 m entry narrowing to 0.24 m over 1 m, on the axis north, frictionless springs."""
    out = np.zeros(1, DOCK)
    values = {
        "present": 1, "entry_radius": 0.5, "tube_radius": 0.12, "cone_length": 1.0, "tube_length": 0.6,
        "wall": 0.1, "capture_depth": 1.2, "stiffness": 5000.0, "slip_speed": 0.01,
    }  # fmt: skip
    for name, value in {**values, **changes}.items():
        out[0][name] = value
    return out


def touch(d: np.ndarray, eta, nu=(0.0,) * 6, time: float = 0.0) -> np.void:
    out = np.zeros(1, CONTACT)
    dock_contact(d[0], RINGS[0], np.array(eta, float), np.array(nu, float), time, out[0], np.zeros(N_WORK))
    return out[0]


def nose_at(depth: float, aside: float = 0.0, down: float = 0.0, psi: float = 0.0, theta: float = 0.0):
    """eta with the nose at a depth behind the entry and off the axis; the dock's axis points north."""
    x = depth - NOSE_M * np.cos(psi) * np.cos(theta)
    y = aside - NOSE_M * np.sin(psi) * np.cos(theta)
    return [x, y, down + NOSE_M * np.sin(theta), 0.0, theta, psi]


def test_free_before_and_in_the_middle_of_the_funnel():
    """Protects: nothing is felt that is not touched; depth and offset of the nose are told."""
    for depth in (-30.0, -0.1, 0.5):
        out = touch(dock(), nose_at(depth, 0.05))
        assert not out["wrench"].any() and out["force"] == 0.0
        assert out["nose_depth"] == pytest.approx(depth) and out["nose_offset"] == pytest.approx(0.05)


@given(
    depth=st.floats(0.2, 1.59), aside=st.floats(-0.3, 0.3), down=st.floats(-0.3, 0.3),
    psi=st.floats(-0.4, 0.4), theta=st.floats(-0.4, 0.4),
)  # fmt: skip
def test_without_friction_the_wrench_is_the_slope_of_the_stored_energy(depth, aside, down, psi, theta):
    """Protects: contact makes no energy: work done on the hull is what the springs lose."""
    d, eta = dock(), np.array(nose_at(depth, aside, down, psi, theta))
    here = touch(d, eta)
    rng = np.random.default_rng(1)
    rate = rng.standard_normal(6)
    rate[3:] *= 0.3
    eta_dot = np.zeros(6)
    body_to_ned(eta[3], eta[4], eta[5], rate, eta_dot)
    eta_dot[3:] = euler_rates(eta[3], eta[4], *rate[3:])
    h = 1e-7
    ahead, behind = touch(d, eta + h * eta_dot), touch(d, eta - h * eta_dot)
    power = -(ahead["energy"] - behind["energy"]) / (2 * h)
    smooth = abs(ahead["energy"] + behind["energy"] - 2 * here["energy"]) < 1e-9
    if smooth:  # not across the edge where the shortest way out changes
        assert here["wrench"] @ rate == pytest.approx(power, rel=1e-3, abs=1e-2)


@given(st.integers(0, 10_000))
def test_damping_and_friction_only_take_energy(seed):
    """Protects: a hull cannot be thrown by the dock harder than the springs alone would."""
    rng = np.random.default_rng(seed)
    eta = nose_at(rng.uniform(0, 1.6), *rng.uniform(-0.3, 0.3, 2), *rng.uniform(-0.3, 0.3, 2))
    nu = rng.uniform(-1, 1, 6) * 0.5
    spring = touch(dock(), eta, nu)
    lossy = touch(dock(damping=1.5, friction=0.3), eta, nu)
    assert lossy["wrench"] @ nu <= spring["wrench"] @ nu + 1e-9
    assert lossy["force"] >= 0.0


def test_peak_force_of_a_straight_run_into_the_cone():
    """Protects: the peak of a frictionless bounce: v sqrt(k m), k = n k_point sin^2 of the cone."""
    d, m, speed, dt = dock(), 80.0, 0.2, 1e-4
    x, v, peak = -0.4, speed, 0.0
    slope = 0.38
    # only the ring that touches first: a hull of one ring
    one = hull_rings(np.array([1.0, 0.0]), np.array([0.2, 0.2]))
    one[0]["n"] = 1
    out, work = np.zeros(1, CONTACT), np.zeros(N_WORK)
    for _ in range(200_000):
        dock_contact(
            d[0], one[0], np.array([x, 0, 0, 0, 0, 0.0]), np.array([v, 0, 0, 0, 0, 0.0]), 0.0, out[0], work
        )
        push = out[0]["wrench"][0]
        peak = max(peak, -push)
        v += dt * push / m
        x += dt * v
        if v < 0 and push == 0.0:
            break
    sine = slope / sqrt(1 + slope * slope)
    assert peak == pytest.approx(speed * sqrt(POINTS * 5000.0 * sine**2 * m), rel=5e-3)
    assert v == pytest.approx(-speed, rel=1e-3)


def test_off_the_axis_the_cone_pushes_to_the_middle_and_back():
    """Protects: a funnel leads in: sideways force towards the axis, axial force out, in the cone's ratio."""
    out = touch(dock(), nose_at(0.8, 0.17))
    assert out["wrench"][0] < 0.0 and out["wrench"][1] < 0.0 and abs(out["wrench"][2]) < 1e-9
    assert atan2(-out["wrench"][0], -out["wrench"][1]) == pytest.approx(atan2(0.38, 1.0), abs=1e-2)


def test_rim_outside_and_end():
    """Protects: a hull beside the dock is kept out of it, one that meets the rim is stopped by it."""
    assert touch(dock(), nose_at(0.03, 0.55))["wrench"][0] < 0.0
    beside = touch(dock(), nose_at(0.3, 0.6))
    assert beside["wrench"][1] > 0.0
    assert touch(dock(), nose_at(1.62))["wrench"][0] < 0.0
    assert not touch(dock(), nose_at(1.0, 2.0))["wrench"].any()


def test_turned_and_moving_docks():
    """Protects: the same touch gives the same force wherever the dock looks, and its own motion counts."""
    straight = touch(dock(), nose_at(0.8, 0.17))
    psi = radians(70.0)
    eta = np.array(nose_at(0.8, 0.17))
    c, s = np.cos(psi), np.sin(psi)
    turned = [c * eta[0] - s * eta[1] + 5.0, s * eta[0] + c * eta[1] - 3.0, eta[2] + 2.0, 0.0, 0.0, psi]
    out = touch(dock(entry=[5.0, -3.0, 2.0], heading=psi), turned)
    assert out["wrench"] == pytest.approx(straight["wrench"], abs=1e-6)
    hung = dock(amplitude=[0.0, 0.1, 0.0], period=8.0, damping=1.0)
    meeting, leaving = (touch(hung, nose_at(0.8, 0.17), time=t) for t in (4.0, 0.0))
    assert meeting["force"] > leaving["force"] > 0.0
    moved = touch(hung, nose_at(0.8, 0.27), time=2.0)
    assert moved["nose_offset"] == pytest.approx(0.17)
