"""A fin: lift and drag at any angle of attack. Its decision variable is its deflection over the largest.

Source: Gao et al. 2026, eq. (13)-(20), (27)-(34).
Differs: a fin's force keeps the full drift angle beta, so that it is right in reversed flow and at rest; the
paper sets alpha = delta.
"""

import math
from math import atan, atan2, cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from bumpless.jit import inline, jit
from bumpless.physics.actuators.geometry import add_force, force_against, inflow_along
from bumpless.physics.actuators.screw_flow import wash
from bumpless.physics.frames import wrap

if TYPE_CHECKING:
    import numpy as np

    from bumpless.config.vehicle.parts import Fin

KIND = 2
GROUP, GRID = "rudder", 20  # of Table 3 of the paper: its name there, and levels of a command
STALL_WIDTH = 0.12  # rad over which attached flow gives way to a flat plate's
TRUST = (
    0.4  # share of evidence that counts: the flow at a fin is known only by estimated velocity and current
)


def fill(model: "np.record", i: int, fin: "Fin", rho: float) -> None:
    """Fill slot i of a MODEL record from the vehicle file's entry; angles become radians.

    Source: eq. (13), (35)-(36).
    """
    model["position"][i] = fin.position_m
    model["direction"][i] = fin.direction
    model["command_min"][i] = -math.radians(fin.deflection_max_deg)
    model["command_max"][i] = math.radians(fin.deflection_max_deg)
    model["command_rate"][i] = math.radians(fin.deflection_rate_degps)
    model["time_constant"][i] = fin.time_constant_s
    model["steers"][i], model["trust"][i] = 1, TRUST
    model["fin_area"][i] = fin.planform_area_m2
    model["C_La"][i] = fin.lift_slope_per_rad
    model["C_D0"][i] = fin.drag_coefficient_zero
    model["C_D2"][i] = fin.drag_rise_per_rad2
    model["stall_angle"][i] = math.radians(fin.stall_angle_deg)
    model["reverse_lift"][i] = fin.reverse_lift_share


@inline
def drift_angle(u, v):
    """beta = atan2(v, u), rad; where it will do by the arctangent of one number, in half the time."""
    return atan(v / u) if u > abs(v) else atan2(v, u)


@inline
def fin_coefficients(model, i, alpha):
    """(C_L, C_D, dC_L/dalpha, dC_D/dalpha) of fin i at angle of attack alpha, rad, any alpha.

    Attached flow: C_L linear, C_D parabolic. Beyond the stall angle: a flat plate,
    C_L = sin 2 alpha, C_D = 2 sin^2 alpha, blended in over 0.12 rad. Flow from the trailing edge
    leaves only the share `reverse_lift` of the lift slope.
    """
    a = wrap(alpha)
    slope = model.C_La[i]
    if a > 0.5 * pi:
        a -= pi
        slope *= model.reverse_lift[i]
    elif a < -0.5 * pi:
        a += pi
        slope *= model.reverse_lift[i]
    c_l, d_l = slope * a, slope
    c_d, d_d = model.C_D0[i] + model.C_D2[i] * a * a, 2.0 * model.C_D2[i] * a
    excess = abs(a) - model.stall_angle[i]
    if excess > 0.0:
        sa, ca = sin(a), cos(a)
        plate_l, plate_dl = 2.0 * sa * ca, 2.0 * (ca * ca - sa * sa)
        plate_d, plate_dd = model.C_D0[i] + 2.0 * sa * sa, 4.0 * sa * ca
        t = min(1.0, excess / STALL_WIDTH)
        s = t * t * (3.0 - 2.0 * t)
        ds = 6.0 * t * (1.0 - t) / STALL_WIDTH * (1.0 if a > 0.0 else -1.0)
        d_l = (1.0 - s) * d_l + s * plate_dl + ds * (plate_l - c_l)
        d_d = (1.0 - s) * d_d + s * plate_dd + ds * (plate_d - c_d)
        c_l = (1.0 - s) * c_l + s * plate_l
        c_d = (1.0 - s) * c_d + s * plate_d
    return c_l, c_d, d_l, d_d


@jit
def fin_coefficient_curvature(model, i, alpha):
    """(d2C_L/dalpha2, d2C_D/dalpha2) of fin i at angle of attack alpha, rad: of `fin_coefficients`."""
    a = wrap(alpha)
    slope = model.C_La[i]
    if abs(a) > 0.5 * pi:
        a -= pi if a > 0.0 else -pi
        slope *= model.reverse_lift[i]
    dd_l, dd_d = 0.0, 2.0 * model.C_D2[i]
    excess = abs(a) - model.stall_angle[i]
    if excess > 0.0:
        t = min(1.0, excess / STALL_WIDTH)
        s = t * t * (3.0 - 2.0 * t)
        ds = 6.0 * t * (1.0 - t) / STALL_WIDTH * (1.0 if a > 0.0 else -1.0)
        dds = 6.0 * (1.0 - 2.0 * t) / STALL_WIDTH**2 if t < 1.0 else 0.0
        gap_l = sin(2.0 * a) - slope * a
        gap_d = 2.0 * sin(a) ** 2 - model.C_D2[i] * a * a
        dgap_l = 2.0 * cos(2.0 * a) - slope
        dgap_d = 2.0 * sin(2.0 * a) - 2.0 * model.C_D2[i] * a
        dd_l = -4.0 * s * sin(2.0 * a) + 2.0 * ds * dgap_l + dds * gap_l
        dd_d = (1.0 - s) * dd_d + 4.0 * s * cos(2.0 * a) + 2.0 * ds * dgap_d + dds * gap_d
    return dd_l, dd_d


@inline
def fin_force(model, i, delta, nu_r, stream):
    """(F_x, F_e, dF_x/ddelta, dF_e/ddelta): force of fin i along x_b and along its lift direction, N.

    delta in rad, nu_r (6,) relative velocity in body axes, stream: what a screw adds to it along x_b, m/s.
    Source: eq. (14)-(20).
    """
    e = model.direction[i]
    u = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0) + stream
    v = inflow_along(model, i, nu_r, e[0], e[1], e[2])
    speed2 = u * u + v * v
    if speed2 < 1e-12:
        return 0.0, 0.0, 0.0, 0.0
    c_l, c_d, d_l, d_d = fin_coefficients(model, i, delta - drift_angle(u, v))
    qa = 0.5 * model.rho * sqrt(speed2) * model.fin_area[i]
    cb, sb = u, v  # times the speed that q lacks: no division
    return (
        qa * (-c_d * cb - c_l * sb),
        qa * (-c_d * sb + c_l * cb),
        qa * (-d_d * cb - d_l * sb),
        qa * (-d_d * sb + d_l * cb),
    )


@inline
def wrench(model, i, u, nu_r):
    """(X, Y, Z, K, M, N) at the commands u (8,) as they are now. Source: eq. (23)-(26)."""
    ex, ey, ez = model.direction[i, 0], model.direction[i, 1], model.direction[i, 2]
    x, y, z = model.position[i, 0], model.position[i, 1], model.position[i, 2]
    axial, force, _, _ = fin_force(model, i, u[i], nu_r, 0.0)
    if model.flow == 1 and model.washed_by[i] > 0:
        screw, share = model.washed_by[i] - 1, model.washed_share[i]
        added = wash(model, i, screw, u[screw], nu_r)
        washed_axial, washed_force, _, _ = fin_force(model, i, u[i], nu_r, added)
        axial += share * (washed_axial - axial)
        force += share * (washed_force - force)
    fx, fy, fz = axial + force * ex, force * ey, force * ez
    return fx, fy, fz, y * fz - z * fy, z * fx - x * fz, x * fy - y * fx


@inline
def yaw_damping(model, i, u):
    """-dN/dr of fin i at rest in a flow u along x_b, m/s: what it takes from a turn, N m s/rad.

    Attached flow: a lever x meets the turn's flow r x at the angle r x / u, and its lift slope does the rest.
    """
    lever = model.position[i, 0] * model.direction[i, 1]
    return 0.5 * model.rho * model.fin_area[i] * model.C_La[i] * abs(u) * lever * lever


@inline
def to_x(model, i, command):
    """Decision variable of a deflection, rad."""
    return command / model.command_max[i]


@inline
def to_command(model, i, x):
    """Deflection (rad) of a decision variable."""
    return x * model.command_max[i]


@inline
def add_map(model, i, x, u_previous, alpha, nu_r, tau, column):
    """Add alpha times the wrench at x (8,) to tau (6,), and its derivative to column[i] (6,).

    With model.fins_coast the drag is taken as given, at the last command: fins do not brake.

    Source: eq. (27)-(34).
    """
    e, scale = model.direction[i], model.command_max[i]
    fx, fe, dx, de = fin_force(model, i, x[i] * scale, nu_r, 0.0)
    if model.fins_coast == 1:
        fx, _, _, _ = fin_force(model, i, u_previous[i], nu_r, 0.0)
        dx = 0.0
    add_force(model, i, alpha * (fx + fe * e[0]), alpha * fe * e[1], alpha * fe * e[2], tau)
    g = alpha * scale
    add_force(model, i, g * (dx + de * e[0]), g * de * e[1], g * de * e[2], column[i])


@inline
def curve(model, i, x, u_previous, alpha, nu_r, weight, out, coupling):
    """out[i] = -sum_k weight_k d2G_k/dx_i2: matters in slow flow, where fins stall and brake."""
    e, scale = model.direction[i], model.command_max[i]
    u = inflow_along(model, i, nu_r, 1.0, 0.0, 0.0)
    v = inflow_along(model, i, nu_r, e[0], e[1], e[2])
    speed2 = u * u + v * v
    if speed2 >= 1e-12:
        dd_l, dd_d = fin_coefficient_curvature(model, i, x[i] * scale - atan2(v, u))
        g = alpha * scale * scale * 0.5 * model.rho * sqrt(speed2) * model.fin_area[i]
        fx, fe = g * (-dd_d * u - dd_l * v), g * (-dd_d * v + dd_l * u)
        if model.fins_coast == 1:
            fx = 0.0
        out[i] = force_against(model, i, fx + fe * e[0], fe * e[1], fe * e[2], weight)


@inline
def command_slope(model, i, x):
    """d(command over its largest)/dx: what prices an increment of x as one of the command."""
    return 1.0


@inline
def add_missed(model, i, u, alpha, out):
    """Add the wrench that easing misses to out (6,): fins are not eased."""
