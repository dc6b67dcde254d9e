"""A screw in a pod that turns: at the angle 0 it pushes along x_b, at +90 deg along y_b.

Two commands in a row, shaft speed and angle, that act together: G(x) = T(x_n, a) e(a). The decision variables
are polar, bollard thrust over its largest as of a fixed screw, and angle over its bound, so that bounds map
exactly. At no thrust the angle has no effect: the gradient of both may vanish though thrust at another angle
would help. There the coupling d2G/dx_n dx_a shows the way out of the saddle. An angle's stop somewhat beyond
90 deg is a trap that no local method leaves: the same force with the screw reversed lies on its other side.

Source: Fossen 2021, Handbook of Marine Craft Hydrodynamics and Motion Control, 2nd ed., sec. 9.4 and 11.2.1.
Differs: thrust and angle are the variables, not the components of thrust along x_b and y_b, whose admissible
set is not a box.
"""

import math
from math import cos, sin
from typing import TYPE_CHECKING

from bumpless.jit import inline
from bumpless.physics.actuators import thruster
from bumpless.physics.actuators.geometry import add_force, force_against, inflow_along
from bumpless.physics.actuators.thruster import axial_wrench, missed_share, on_hull, thrust_scale

if TYPE_CHECKING:
    import numpy as np

    from bumpless.config.vehicle.parts import Azimuth

KIND = 3
GROUP, GRID = "azimuths", 21  # sampled levels of each command; the paper has none of this kind


def fill(model: "np.record", i: int, pod: "Azimuth", rho: float) -> None:
    """Fill slots i (shaft speed, rev/s) and i + 1 (angle, rad) of a MODEL record from a vehicle file's entry.

    The direction of slot i + 1 is that of thrust a quarter turn on.
    """
    thruster.fill_screw(model, i, pod, rho)
    model["direction"][i], model["direction"][i + 1] = pod.direction, (0.0, 1.0, 0.0)
    limit = math.radians(pod.angle_max_deg)
    model["command_min"][i + 1], model["command_max"][i + 1] = -limit, limit
    model["command_rate"][i + 1] = math.radians(pod.angle_rate_degps)
    model["time_constant"][i + 1] = pod.angle_time_constant_s


@inline
def heading(model, i, angle):
    """(e, e'): unit vector of thrust at `angle`, rad, and its derivative, in body axes."""
    c, s = cos(angle), sin(angle)
    d, q = model.direction[i], model.direction[i + 1]
    e = (c * d[0] + s * q[0], c * d[1] + s * q[1], c * d[2] + s * q[2])
    return e, (c * q[0] - s * d[0], c * q[1] - s * d[1], c * q[2] - s * d[2])


@inline
def wrench(model, i, u, nu_r):
    """(X, Y, Z, K, M, N) at the commands u (8,) as they are now: eq. (9) of Gao et al. 2026 along e."""
    e, _ = heading(model, i, u[i + 1])
    force, torque = on_hull(model, i, u[i], nu_r, e[0], e[1], e[2])
    return axial_wrench(model, i, force, torque, e[0], e[1], e[2])


@inline
def to_x(model, i, command):
    """Decision variable of a shaft speed (rev/s) or an angle (rad)."""
    return thruster.to_x(model, i, command) if model.part[i] == 0 else command / model.command_max[i]


@inline
def to_command(model, i, x):
    """Shaft speed (rev/s) or angle (rad) of a decision variable."""
    return thruster.to_command(model, i, x) if model.part[i] == 0 else x * model.command_max[i]


@inline
def loads(model, i, x, u_previous, nu_r, angle):
    """(T, Q, dT/dangle, dQ/dangle, Q/T of the bollard pull) of the allocator's map, e and e' at `angle`."""
    e, t = heading(model, i, angle)
    z, speed = x[i] * thrust_scale(model, i), abs(u_previous[i])
    along = inflow_along(model, i, nu_r, e[0], e[1], e[2])
    across = inflow_along(model, i, nu_r, t[0], t[1], t[2])
    arm = model.Q_nn[i] / (model.T_nn[i] if z >= 0.0 else model.T_nn_reverse[i])
    a, b = model.T_nv[i] * speed, model.Q_nv[i] * speed
    return z - a * along, arm * z - b * along, -a * across, -b * across, arm, e, t


@inline
def add_axial(model, i, force, torque, e, out):
    """Add a force and a torque along e at actuator i to the wrench out (6,)."""
    add_force(model, i, force * e[0], force * e[1], force * e[2], out)
    for k in range(3):
        out[3 + k] += torque * e[k]


@inline
def add_map(model, i, x, u_previous, alpha, nu_r, tau, column):
    """Add alpha times the wrench at x (8,) to tau (6,), its derivatives to column[i] and column[i + 1]."""
    limit = model.command_max[i + 1]
    T, Q, dT, dQ, arm, e, t = loads(model, i, x, u_previous, nu_r, x[i + 1] * limit)
    add_axial(model, i, alpha * T, alpha * Q, e, tau)
    g = alpha * thrust_scale(model, i)
    add_axial(model, i, g, g * arm, e, column[i])
    g = alpha * limit
    add_axial(model, i, g * dT, g * dQ, e, column[i + 1])
    add_axial(model, i, g * T, g * Q, t, column[i + 1])


@inline
def axial_against(model, i, force, torque, e, weight):
    """-weight . wrench of a force and a torque along e at actuator i."""
    s = force_against(model, i, force * e[0], force * e[1], force * e[2], weight)
    return s - torque * (weight[3] * e[0] + weight[4] * e[1] + weight[5] * e[2])


@inline
def curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling):
    """Second-order term: none in thrust alone, (T e)'' in the angle, coupled by e'."""
    limit = model.command_max[i + 1]
    T, Q, dT, dQ, arm, e, t = loads(model, i, x, u_previous, nu_r, x[i + 1] * limit)
    z = x[i] * thrust_scale(model, i)
    g = alpha * limit * limit  # T'' = z - T: what inflow takes turns with e
    out[i + 1] = axial_against(model, i, g * (z - 2.0 * T), g * (arm * z - 2.0 * Q), e, weight)
    out[i + 1] += axial_against(model, i, 2.0 * g * dT, 2.0 * g * dQ, t, weight)
    g = alpha * limit * thrust_scale(model, i)
    coupling[i] = axial_against(model, i, g, g * arm, t, weight)


@inline
def command_slope(model, i, x):
    """d(command over its largest)/dx."""
    return thruster.command_slope(model, i, x) if model.part[i] == 0 else 1.0


@inline
def add_missed(model, i, u, alpha, out):
    """Add the wrench that easing misses at the commands u (8,) to out (6,), along the present angle."""
    force = alpha * thrust_scale(model, i) * missed_share(model, i, u[i])
    e, _ = heading(model, i, u[i + 1])
    add_force(model, i, force * e[0], force * e[1], force * e[2], out)
