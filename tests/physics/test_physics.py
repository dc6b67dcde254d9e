"""The plant obeys the laws it is built from: frames, energy, symmetry, order of the integrator."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.physics.actuators import total_wrench
from bumpless.physics.actuators.fin import fin_force
from bumpless.physics.dynamics import coriolis_force, damping_force, restoring_force
from bumpless.physics.faults import FAULTS
from bumpless.physics.frames import body_to_ned, euler_rates, ned_to_body
from bumpless.physics.plant import PLANT, observe_plant, state_rate, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.physics.water import ENVIRONMENT, water_velocity

CALM, WHOLE = np.zeros(1, ENVIRONMENT)[0], np.zeros(1, FAULTS)[0]  # water at rest, nothing broken

angle = st.floats(-3.1, 3.1)
pitch = st.floats(-1.4, 1.4)
speed = st.floats(-1.5, 1.5)
vector3 = st.tuples(speed, speed, speed).map(np.array)
vector6 = st.tuples(speed, speed, speed, speed, speed, speed).map(np.array)


@given(angle, pitch, angle, vector3)
def test_rotation_agrees_with_scipy_and_inverts(phi, theta, psi, v):
    """Protects: the one home of every frame change."""
    out, back = np.zeros(3), np.zeros(3)
    body_to_ned(phi, theta, psi, v, out)
    expected = Rotation.from_euler("ZYX", [psi, theta, phi]).apply(v)
    np.testing.assert_allclose(out, expected, atol=1e-12)
    ned_to_body(phi, theta, psi, out, back)
    np.testing.assert_allclose(back, v, atol=1e-12)


@given(angle, pitch, angle, vector3)
def test_euler_rates_turn_the_body_as_scipy_does(phi, theta, psi, omega):
    """Protects: attitude kinematics, eq. (7): a small rotation by omega dt moves the angles by T omega dt."""
    dt = 1e-6
    rates = np.array(euler_rates(phi, theta, *omega))
    after = Rotation.from_euler("ZYX", [psi, theta, phi]) * Rotation.from_rotvec(omega * dt)
    turned = after.as_euler("ZYX")[::-1] - np.array([phi, theta, psi])
    turned = (turned + np.pi) % (2 * np.pi) - np.pi
    np.testing.assert_allclose(turned / dt, rates, atol=2e-4 / np.cos(theta) ** 2)


@given(vector6)
def test_coriolis_forces_do_no_work(model, nu):
    """Protects: C(nu) skew, so Coriolis terms neither make nor take energy."""
    for M in (model["M_RB"], model["M_A"]):
        force = np.zeros(6)
        coriolis_force(M, nu, force)
        assert abs(force @ nu) < 1e-10 * (1 + np.abs(M).max())


@given(vector6)
def test_damping_takes_energy(model, nu):
    """Protects: D(nu) nu opposes motion for every direction of motion, ahead and astern."""
    force = np.zeros(6)
    damping_force(model, nu, force)
    assert force @ nu <= 1e-12


@given(angle, pitch)
def test_restoring_force_derives_from_a_potential(model, phi, theta):
    """Protects: g(eta) is the gradient of weight and buoyancy's potential energy, so it conserves energy."""

    def potential(phi, theta):
        up = np.zeros(3)
        total = 0.0
        for r, weight in ((model["r_g"], model["weight"]), (model["r_b"], -model["buoyancy"])):
            body_to_ned(phi, theta, 0.0, np.array(r), up)
            total -= weight * up[2]
        return total

    force = np.zeros(6)
    restoring_force(model, phi, theta, force)
    h = 1e-6
    # generalised moments: virtual rotations p and q change (phi, theta) by T(phi, theta) [p q 0]
    for axis, moment in ((0, force[3]), (1, force[4])):
        omega = np.zeros(3)
        omega[axis] = 1.0
        d_phi, d_theta, _ = euler_rates(phi, theta, *omega)
        slope = (
            potential(phi + h * d_phi, theta + h * d_theta) - potential(phi - h * d_phi, theta - h * d_theta)
        ) / (2 * h)
        assert moment == pytest.approx(-slope, abs=1e-5)


def free_plant(nu, eta=None):
    plant = np.zeros(1, PLANT)
    plant[0]["nu"] = nu
    plant[0]["eta"] = [0, 0, 20, 0, 0, 0] if eta is None else eta
    plant[0]["effectiveness"] = 1.0
    return plant


def energy(model, plant):
    p = plant[0]
    M = model["M_RB"] + model["M_A"]
    down = np.zeros(3)
    total = 0.5 * p["nu"] @ M @ p["nu"]
    for r, weight in ((model["r_g"], model["weight"]), (model["r_b"], -model["buoyancy"])):
        body_to_ned(p["eta"][3], p["eta"][4], p["eta"][5], np.array(r), down)
        total -= weight * (p["eta"][2] + down[2])
    return total


@settings(max_examples=30, deadline=None)
@given(vector6.map(lambda v: v * np.array([1, 0.5, 0.5, 0.3, 0.3, 0.3])))
def test_energy_never_grows_unforced(model, nu):
    """Protects: with propellers stopped and fins amidships the whole plant is passive."""
    plant = free_plant(nu)
    noise, command = np.zeros(N_NOISE), np.zeros(MAX_ACTUATORS)
    before = energy(model, plant)
    for _ in range(100):
        step_plant(model, CALM, WHOLE, plant[0], command, 0.02, 1, noise)
        after = energy(model, plant)
        assert after <= before + 1e-7 * (1 + abs(before))
        before = after


def test_energy_is_conserved_without_damping_or_fins(model):
    """Protects: rigid body, added mass, Coriolis and restoring terms agree with each other."""
    ideal = model.copy()
    for name in ("D_linear", "D_quadratic", "D_lift", "fin_area", "T_nv", "Q_nv"):
        ideal[name] = 0.0
    plant = free_plant([0.6, 0.2, -0.1, 0.2, 0.15, -0.1])
    noise, command = np.zeros(N_NOISE), np.zeros(MAX_ACTUATORS)
    start = energy(ideal, plant)
    for _ in range(1000):
        step_plant(ideal, CALM, WHOLE, plant[0], command, 0.02, 2, noise)
    assert energy(ideal, plant) == pytest.approx(start, rel=1e-7)


def test_integrator_is_of_fourth_order(model):
    """Protects: halving the step cuts the error of a smooth manoeuvre about sixteen times."""
    noise = np.zeros(N_NOISE)

    def end(substeps):
        plant = free_plant([0.5, 0.02, 0.01, 0.05, 0.02, -0.03])
        command = np.zeros(MAX_ACTUATORS)
        for _ in range(10):
            step_plant(model, CALM, WHOLE, plant[0], command, 0.4, substeps, noise)
        return np.concatenate([plant[0]["eta"], plant[0]["nu"]])

    exact = end(64)
    errors = [np.abs(end(n) - exact).max() for n in (2, 4, 8)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders.min() > 3.5


def test_a_steady_current_carries_the_vehicle_along(model):
    """Protects: only velocity through water makes hydrodynamic force: drifting with the water is free."""
    plant = free_plant([0.3, -0.2, 0, 0, 0, 0])
    stream = np.zeros(1, ENVIRONMENT)[0]
    stream["current"] = [0.3, -0.2, 0.0]
    noise, command = np.zeros(N_NOISE), np.zeros(MAX_ACTUATORS)
    for _ in range(200):
        step_plant(model, stream, WHOLE, plant[0], command, 0.05, 2, noise)
    np.testing.assert_allclose(plant[0]["nu"], [0.3, -0.2, 0, 0, 0, 0], atol=1e-9)
    np.testing.assert_allclose(plant[0]["eta"][:2], [3.0, -2.0], atol=1e-8)


def test_waves_carry_a_vehicle_as_heavy_as_its_water_along(model):
    """Protects: accelerated water pushes the displaced volume too: at the water's own speed and turned any
    way, a neutrally buoyant vehicle gets the water's own acceleration."""
    afloat = model.copy()
    afloat["buoyancy"], afloat["r_b"] = afloat["weight"], afloat["r_g"]
    sea, plant = np.zeros(1, ENVIRONMENT)[0], free_plant(np.zeros(6))
    sea["wave_height"], sea["wave_period"], sea["wave_direction"] = 0.4, 5.0, 0.7
    velocity, acceleration, rate = np.zeros(3), np.zeros(3), np.zeros(20)
    command = np.zeros(MAX_ACTUATORS)
    x = np.zeros(20)
    x[:6] = [1.0, 2.0, 1.5, 0.0, 0.0, 0.9]
    for time in np.linspace(0.0, 5.0, 7):
        water_velocity(sea, plant[0]["gust"], time, x[:6], velocity, acceleration)
        ned_to_body(0.0, 0.0, 0.9, velocity, x[6:9])
        healthy = plant[0]["effectiveness"]
        state_rate(afloat, sea, plant[0]["gust"], healthy, time, x, command, rate)
        expected = np.zeros(3)
        ned_to_body(0.0, 0.0, 0.9, acceleration, expected)
        np.testing.assert_allclose(rate[6:12], [*expected, 0, 0, 0], atol=1e-9)


def test_turning_circles_to_port_and_starboard_mirror_each_other(model):
    """Protects: port-starboard symmetry of hull, fins and their signs (shaft torque taken away)."""
    even = model.copy()
    even["Q_nn"] = even["Q_nv"] = 0.0
    ends = []
    for side in (1.0, -1.0):
        plant = free_plant([0.6, 0, 0, 0, 0, 0])
        noise, command = np.zeros(N_NOISE), np.zeros(MAX_ACTUATORS)
        jacobian = yaw_column(even)
        for i in range(4):
            command[i] = side * 0.15 * np.sign(jacobian[i])
        command[4] = 3.0
        for _ in range(400):
            step_plant(even, CALM, WHOLE, plant[0], command, 0.05, 2, noise)
        ends.append(plant[0]["eta"].copy())
    starboard, port = ends
    assert abs(starboard[5]) > 0.2
    np.testing.assert_allclose(starboard * [1, -1, 1, -1, 1, -1], port, atol=1e-9)


def yaw_column(model):
    """dN/ddelta of each fin at 0.6 m/s."""
    nu = np.array([0.6, 0, 0, 0, 0, 0.0])
    out = []
    for i in range(4):
        _, _, _, slope = fin_force(model, i, 0.0, nu, 0.0)
        out.append(model["position"][i, 0] * slope * model["direction"][i, 1])
    return np.array(out)


def test_forward_speed_settles_where_thrust_meets_drag(model):
    """Protects: the simulated top speed equals the root of thrust minus drag found independently."""
    from scipy.optimize import brentq

    u = np.zeros(MAX_ACTUATORS)
    u[4] = 2.5
    healthy = np.ones(MAX_ACTUATORS)

    def surplus(speed):
        nu, tau, drag = np.array([speed, 0, 0, 0, 0, 0.0]), np.zeros(6), np.zeros(6)
        total_wrench(model, u, healthy, nu, tau)
        damping_force(model, nu, drag)
        return tau[0] + drag[0]

    expected = brentq(surplus, 0.05, 3.0)
    calm = model.copy()
    calm["Q_nn"] = calm["Q_nv"] = 0.0  # no heel, so that the balance is in surge alone
    plant, noise = free_plant(np.zeros(6)), np.zeros(N_NOISE)
    for _ in range(4000):
        step_plant(calm, CALM, WHOLE, plant[0], u, 0.05, 2, noise)
    assert plant[0]["nu"][0] == pytest.approx(expected, rel=1e-6)


@settings(deadline=None)
@given(st.floats(-3.2, 3.2), vector6, st.integers(0, 3))
def test_fin_slopes_equal_finite_differences(model, delta, nu, i):
    """Protects: the analytic slopes that the allocator's Jacobian is made of, stall and reversed flow too."""
    h = 1e-6
    _, _, dx, de = fin_force(model, i, delta, nu, 0.0)
    up, down = (fin_force(model, i, delta + x, nu, 0.0) for x in (h, -h))
    scale = 1e-4 * (1 + abs(dx) + abs(de))
    # C_D and C_L are smooth except at the wrap to the trailing edge, where a flat plate's drag has its peak
    alpha = (delta - np.arctan2(*_flow(model, i, nu)[::-1]) + np.pi) % (2 * np.pi) - np.pi
    if abs(abs(alpha) - np.pi / 2) > 1e-3:
        assert (up[0] - down[0]) / (2 * h) == pytest.approx(dx, abs=scale)
        assert (up[1] - down[1]) / (2 * h) == pytest.approx(de, abs=scale)


def _flow(model, i, nu):
    r, e = model["position"][i], model["direction"][i]
    velocity = nu[:3] + np.cross(nu[3:], r)
    return velocity[0], velocity @ e


def test_the_actuator_wrench_seen_by_the_log_is_the_plants(model):
    """Protects: `observe_plant` reports the wrench that moves the vehicle."""
    plant = free_plant([0.4, 0.01, 0, 0, 0, 0])
    plant[0]["u"][:7] = [0.1, -0.1, 0.05, 0.0, 2.0, 1.0, -1.0]
    expected = np.zeros(6)
    total_wrench(model, plant[0]["u"], plant[0]["effectiveness"], plant[0]["nu"], expected)
    observe_plant(model, CALM, plant[0])
    np.testing.assert_allclose(plant[0]["seen"]["tau"], expected, atol=1e-12)
