"""A vehicle's coefficients as somebody published them, in the plant's arrangement.

Source: Prestero 2001, chapter 4. His lift coefficients are of hull, fins and Munk's moment together; in the
plant the fins are actuators and Munk's moment is in C_A(nu_r), so D_lift is what is left of his.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle.parts import Fin
from bumpless.config.vehicle.published import PublishedCoefficients

Array = NDArray[np.float64]
ROWS, RATES = "XYZKMN", "uvwpqr"
ADDED = ("X_udot", "Y_vdot", "Y_rdot", "Z_wdot", "Z_qdot", "K_pdot", "M_wdot", "M_qdot", "N_vdot", "N_rdot")
DRAG = ("X_uu", "Y_vv", "Y_rr", "Z_ww", "Z_qq", "K_pp", "M_ww", "M_qq", "N_vv", "N_rr")
LIFT = ("Y_uv", "Y_ur", "Z_uw", "Z_uq", "M_uw", "M_uq", "N_uv", "N_ur")


def place(name: str) -> tuple[int, int]:
    """(row, column) in a matrix of a coefficient that multiplies one rate, or u and one rate."""
    term = name[2:].removesuffix("dot")
    return ROWS.index(name[0]), RATES.index(term[-1])


def published_matrices(given: PublishedCoefficients, fins: Sequence[Fin], rho: float) -> tuple[Array, ...]:
    """(M_A, D_quadratic, D_lift), each (6, 6): see `Coefficients`."""
    by_symbol = given.by_symbol
    M_A, drag, lift = np.zeros((6, 6)), np.zeros((6, 6)), np.zeros((6, 6))
    for name in ADDED:
        M_A[place(name)] = -by_symbol[name]
    for name in DRAG:
        drag[place(name)] = -by_symbol[name]
    for name in LIFT:
        row, column = place(name)
        known = bilinear(lambda nu, row=row: flow_force(M_A, fins, rho, nu)[row], 0, column)
        lift[row, column] = known - by_symbol[name]
    return M_A, drag, lift


def flow_force(M_A: Array, fins: Sequence[Fin], rho: float, nu: Array) -> Array:
    """-C_A(nu) nu and the lift of fins amidships in forward flow, (6,): all terms nu_a nu_b."""
    u, v, w, _, q, r = nu
    a, b = np.split(M_A @ nu, 2)
    coriolis = np.concatenate([np.cross(nu[3:], a), np.cross(nu[:3], a) + np.cross(nu[3:], b)])
    if not fins:
        return -coriolis
    # a fin at x meets the angles (v + x r)/u and (w - x q)/u
    per_angle, x = fin_lift(fins, rho), fins[0].x_m
    return -coriolis - u * (per_angle[:, 1] * (v + x * r) + per_angle[:, 2] * (w - x * q))


def fin_lift(fins: Sequence[Fin], rho: float) -> Array:
    """(6, 6), columns 1 and 2: wrench of all fins per rad and u^2, turned to lift towards +y and +z."""
    lift = np.zeros((6, 6))
    for fin in fins:
        e = np.array(fin.direction)
        slope = 0.5 * rho * fin.planform_area_m2 * fin.lift_slope_per_rad
        for axis in (1, 2):
            force = slope * e[axis] * e
            lift[:, axis] += np.concatenate([force, np.cross(fin.position_m, force)])
    return lift


def bilinear(force: Callable[[Array], float], a: int, b: int) -> float:
    """Coefficient of nu_a nu_b in a quadratic function; of nu_a^2 when a = b."""
    unit = np.eye(6)
    if a == b:
        return float(force(unit[a]))
    return float(force(unit[a] + unit[b]) - force(unit[a]) - force(unit[b]))
