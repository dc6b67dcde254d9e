"""A fixed screw. Its decision variable is *bollard thrust* T_nn n|n| over its largest: it answers from rest.

In shaft speed the map has zero slope at n = 0 and Gauss-Newton could not start a stopped thruster. Bounds in
x are exact images of those in shaft speed, because n -> n|n| is monotone.

Source: Gao et al. 2026, eq. (8)-(12), (23)-(34).
Differs: K_T and K_Q are taken linear in the advance ratio, so that T = rho D^4 K_T(J) n|n| becomes
T_nn n|n| - T_nv |n| V_A, finite at n = 0. In the allocator's map the term T_nv |n| V_A is taken at the
previous command, one cycle old. As an option (`smoothing`, x_0) a screw passes through zero with a finite
slope: n|n| = x holds far from zero only, n ~ x (x^2 + x_0^2)^-1/4 everywhere, which misses at most 0.3 x_0 of
the largest thrust.
"""

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from bumpless.jit import inline
from bumpless.physics.actuators.geometry import add_force, inflow_along
from bumpless.physics.actuators.screw_flow import in_flow

if TYPE_CHECKING:
    from bumpless.config.vehicle.parts import Screw, Thruster

KIND = 1
GROUP, GRID = "thrusters", 100  # of Table 3 of the paper: its name there, and levels of a command
HAND = {"right": -1.0, "left": 1.0, "balanced": 0.0}
_LEAST = 1e-3  # thrust share at which a screw that is not eased counts as one that is, in the price


def fill(model: np.record, i: int, thruster: "Thruster", rho: float) -> None:
    """Fill slot i of a MODEL record from the vehicle file's entry; rpm become rev/s."""
    model["direction"][i] = np.array(thruster.direction) / np.linalg.norm(thruster.direction)
    fill_screw(model, i, thruster, rho)


def fill_screw(model: np.record, i: int, screw: "Screw", rho: float) -> None:
    """All of a screw but for where it pushes. Source: eq. (11)-(12), (35)-(36)."""
    D, inflow = screw.diameter_m, 1.0 - screw.wake_fraction
    model["position"][i] = screw.position_m
    model["command_min"][i] = screw.shaft_speed_min_rpm / 60.0
    model["command_max"][i] = screw.shaft_speed_max_rpm / 60.0
    model["command_rate"][i] = screw.shaft_acceleration_rpmps / 60.0
    model["time_constant"][i] = screw.time_constant_s
    model["steers"][i], model["trust"][i] = 0, 1.0
    model["T_nn"][i] = rho * D**4 * screw.thrust_coefficient
    model["T_nn_reverse"][i] = model["T_nn"][i] * screw.reverse_thrust_share
    model["T_nv"][i] = rho * D**3 * screw.thrust_slope * inflow
    # a right-handed screw turns about its thrust; the water's torque on it, and so on the hull, is against
    hand = HAND[screw.hand]
    model["Q_nn"][i] = hand * rho * D**5 * screw.torque_coefficient
    model["Q_nv"][i] = hand * rho * D**4 * screw.torque_slope * inflow


@inline
def bollard_thrust(model, i, n):
    """T_nn n|n|: thrust of thruster i at shaft speed n (rev/s) in still water, N."""
    return (model.T_nn[i] if n >= 0.0 else model.T_nn_reverse[i]) * n * abs(n)


@inline
def shaft_speed(model, i, thrust):
    """Inverse of `bollard_thrust`, rev/s."""
    if thrust >= 0.0:
        return sqrt(thrust / model.T_nn[i])
    return -sqrt(-thrust / model.T_nn_reverse[i])


@inline
def thrust_scale(model, i):
    """Bollard thrust at the upper command bound, N: the unit of a thruster's x."""
    return model.T_nn[i] * model.command_max[i] * model.command_max[i]


@inline
def thrust_and_torque(model, i, n, inflow):
    """(T, Q): thrust (N) and shaft torque (N m) along the screw's axis, along which the water flows at
    `inflow`, m/s. Source: eq. (8)-(10)."""
    thrust = bollard_thrust(model, i, n) - model.T_nv[i] * abs(n) * inflow
    torque = model.Q_nn[i] * n * abs(n) - model.Q_nv[i] * abs(n) * inflow
    return thrust, torque


@inline
def on_hull(model, i, n, nu_r, ex, ey, ez):
    """(T, Q) of the screw on the hull along (ex, ey, ez): published, or with all that flow does to it."""
    if model.flow == 1:
        return in_flow(model, i, n, nu_r, ex, ey, ez)
    return thrust_and_torque(model, i, n, inflow_along(model, i, nu_r, ex, ey, ez))


@inline
def axial_wrench(model, i, force, torque, ex, ey, ez):
    """(X, Y, Z, K, M, N) of a force and a torque along (ex, ey, ez) at actuator i."""
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    fx, fy, fz = force * ex, force * ey, force * ez
    return (
        fx,
        fy,
        fz,
        y * fz - z * fy + torque * ex,
        z * fx - x * fz + torque * ey,
        x * fy - y * fx + torque * ez,
    )


@inline
def wrench(model, i, u, nu_r):
    """(X, Y, Z, K, M, N) at the commands u (8,) as they are now. Source: eq. (23)-(26)."""
    ex, ey, ez = model.direction[i, 0], model.direction[i, 1], model.direction[i, 2]
    force, torque = on_hull(model, i, u[i], nu_r, ex, ey, ez)
    return axial_wrench(model, i, force, torque, ex, ey, ez)


@inline
def to_x(model, i, command):
    """Decision variable of a shaft speed, rev/s."""
    x = bollard_thrust(model, i, command) / thrust_scale(model, i)
    if model.smoothing > 0.0:
        y = x * x
        x = sqrt(0.5 * (y + sqrt(y * (y + 4.0 * model.smoothing**2)))) * (1.0 if x >= 0.0 else -1.0)
    return x


@inline
def to_command(model, i, x):
    """Shaft speed (rev/s) of a decision variable."""
    if model.smoothing > 0.0:
        x *= abs(x) / sqrt(x * x + model.smoothing**2)
    return shaft_speed(model, i, x * thrust_scale(model, i))


@inline
def add_map(model, i, x, u_previous, alpha, nu_r, tau, column):
    """Add alpha times the wrench at x (8,) to tau (6,), and its derivative to column[i] (6,).

    Source: eq. (27)-(34).
    """
    e, scale = model.direction[i], thrust_scale(model, i)
    z = x[i] * scale
    speed = abs(u_previous[i])
    inflow = inflow_along(model, i, nu_r, e[0], e[1], e[2])
    thrust = alpha * (z - model.T_nv[i] * speed * inflow)
    arm = model.Q_nn[i] / (model.T_nn[i] if z >= 0.0 else model.T_nn_reverse[i])
    torque = alpha * (arm * z - model.Q_nv[i] * speed * inflow)
    add_force(model, i, thrust * e[0], thrust * e[1], thrust * e[2], tau)
    g = alpha * scale
    add_force(model, i, g * e[0], g * e[1], g * e[2], column[i])
    for k in range(3):
        tau[3 + k] += torque * e[k]
        column[i, 3 + k] += g * arm * e[k]


@inline
def curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling):
    """Second-order term of the wrench: none, the map is linear in thrust."""


@inline
def command_slope(model, i, x):
    """d(command over its largest)/dx: a screw near zero, where its speed changes fastest, pays most."""
    y = x**2
    z = max(model.smoothing, _LEAST) ** 2
    return (0.5 * y + z) / (y + z) ** 1.25


@inline
def missed_share(model, i, n):
    """Share of the largest thrust between n|n| = x and what easing gives at shaft speed n, faded out near
    zero."""
    x = to_x(model, i, n)
    y, z = x * x, model.smoothing**2
    return (x - x * abs(x) / sqrt(y + z)) * y / (y + z)


@inline
def add_missed(model, i, u, alpha, out):
    """Add the wrench that easing misses at the commands u (8,) to out (6,)."""
    force = alpha * thrust_scale(model, i) * missed_share(model, i, u[i])
    e = model.direction[i]
    add_force(model, i, force * e[0], force * e[1], force * e[2], out)
