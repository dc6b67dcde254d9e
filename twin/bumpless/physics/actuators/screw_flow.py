"""What flow does to a screw beyond eq. (8)-(12), of the simulated vehicle only.

Four quadrants. The published line, T = T_nn n|n| - T_nv |n| V, holds where the screw drives: n V >= 0 up to
V_0 = T_nn n / T_nv, where it gives no thrust. Beyond V_0 the screw is driven, and brakes by
T_vv (V - V_0)^2 besides: from T_vv V^2 when it is stopped the force passes without a corner into the line.
Against the flow, n V < 0, it is T_nn n|n| - T_no |n| V - T_vv V|V|. The same of the torque.

Source: van Lammeren, van Manen and Oosterveld 1969: thrust of B-series screws in four quadrants. Differs: one
parabola beyond zero thrust in place of a Fourier series over the angle of flow.
"""

import math
from math import exp, sqrt
from typing import TYPE_CHECKING

from bumpless.jit import inline
from bumpless.physics.actuators.geometry import inflow_along

if TYPE_CHECKING:
    import numpy as np

    from bumpless.config.vehicle.flow import ScrewFlow
    from bumpless.config.vehicle.parts import Screw


def fill_screw_flow(model: "np.record", i: int, screw: "Screw", flow: "ScrewFlow", hand: float) -> None:
    """Fill slot i of a MODEL record. hand: +-1 or 0, the sign of Q_nn."""
    rho, D, inflow = float(model["rho"]), screw.diameter_m, 1.0 - screw.wake_fraction
    disc = math.pi * D * D / 4.0
    pressure = 0.5 * rho * disc * inflow * inflow
    model["disc_area"][i] = disc
    model["inflow_share"][i] = inflow
    model["T_vv"][i] = pressure * flow.stopped_drag_coefficient
    model["Q_vv"][i] = hand * pressure * D * flow.stopped_torque_coefficient
    model["T_no"][i] = rho * D**3 * flow.opposed_thrust_slope * inflow
    model["Q_no"][i] = hand * rho * D**4 * flow.opposed_torque_slope * inflow
    model["deduction"][i] = flow.thrust_deduction
    model["deduction_astern"][i] = flow.thrust_deduction_astern
    model["cross_loss"][i] = flow.cross_flow_loss_s2pm2
    model["dead_band"][i] = flow.dead_band_rpm / 60.0
    model["least_speed"][i] = flow.least_speed_rpm / 60.0


@inline
def four_quadrants(nn, nv, no, vv, n, V):
    """Force or torque at shaft speed n >= 0, rev/s, and flow V against it, m/s: see the file's head."""
    if V < 0.0:
        return nn * n * n - no * n * V - vv * V * abs(V)
    total = nn * n * n - nv * n * V
    excess = V - nn * n / nv if nv != 0.0 else 0.0
    return total - vv * excess * excess if excess > 0.0 else total


@inline
def driven(model, i, n, V):
    """(T, Q) of screw i alone along its axis, N and N m; astern is ahead seen from behind."""
    s = 1.0 if n > 0.0 or (n == 0.0 and V >= 0.0) else -1.0
    T_nn = model.T_nn[i] if s > 0.0 else model.T_nn_reverse[i]
    T = four_quadrants(T_nn, model.T_nv[i], model.T_no[i], model.T_vv[i], s * n, s * V)
    Q = four_quadrants(model.Q_nn[i], model.Q_nv[i], model.Q_no[i], model.Q_vv[i], s * n, s * V)
    return s * T, s * Q


@inline
def in_flow(model, i, n, nu_r, ex, ey, ez):
    """(T, Q) of screw i on the hull: four quadrants, thrust deduction, loss across a flow."""
    V = inflow_along(model, i, nu_r, ex, ey, ez)
    T, Q = driven(model, i, n, V)
    if T * n > 0.0:
        T *= 1.0 - (model.deduction[i] if n > 0.0 else model.deduction_astern[i])
    if model.cross_loss[i] > 0.0:
        u = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0)
        v = inflow_along(model, i, nu_r, 0.0, 1.0, 0.0)
        w = inflow_along(model, i, nu_r, 0.0, 0.0, 1.0)
        left = exp(-model.cross_loss[i] * max(u * u + v * v + w * w - V * V, 0.0))
        T, Q = T * left, Q * left
    return T, Q


@inline
def wash(model, fin, screw, n, nu_r):
    """Speed through water that a screw adds at a fin along x_b, m/s, positive as of going ahead.

    Momentum theory: 2 rho A (V + w) w = |T|, V the flow in the jet's sense; along the axis
    w (1 + s / sqrt(s^2 + R^2)), s downstream of the disc, so that the jet has 2 w and suction fades.
    """
    ex = model.direction[screw, 0]
    V = model.inflow_share[screw] * inflow_along(model, screw, nu_r, ex, 0.0, 0.0)
    T, _ = driven(model, screw, n, V / model.inflow_share[screw])
    if T * n <= 0.0:
        return 0.0
    sense = ex if T > 0.0 else -ex
    along = max(V if T > 0.0 else -V, 0.0)
    area = model.disc_area[screw]
    w = 0.5 * (sqrt(along * along + 2.0 * abs(T) / (model.rho * area)) - along)
    s = (model.position[screw, 0] - model.position[fin, 0]) * sense
    return sense * w * (1.0 + s / sqrt(s * s + area / math.pi))


@inline
def turning(model, i, command):
    """Shaft speed that the motor of slot i makes of a command, rev/s: nothing in its dead-band, else at least
    its slowest."""
    speed = abs(command)
    if speed < model.dead_band[i]:
        return 0.0
    if speed < model.least_speed[i] and speed > 0.0:
        return model.least_speed[i] if command > 0.0 else -model.least_speed[i]
    return command
