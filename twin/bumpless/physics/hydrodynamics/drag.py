"""Quadratic drag of a Myring hull: skin and form drag along its axis, cross-flow drag across it.

Each function returns D with tau_i = -D_ij |nu_j| nu_j, shape (6, 6), N s^2/m^2 | N s^2/m | N m s^2.
"""

# pyright: reportConstantRedefinition=false
# the source's symbols are capitals

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle.parts import Appendage, Fin
from bumpless.physics.hydrodynamics.myring import HullStrips

Array = NDArray[np.float64]


def axial_drag_coefficient(strips: HullStrips) -> float:
    """c_d on the frontal area: skin friction on a cylinder's skin, raised by the hull's form.

    Source: Prestero 2001, section 4.2 (axial drag), after Triantafyllou.
    """
    hull = strips.hull
    slimness = hull.diameter_m / hull.length_m
    planform = hull.length_m * hull.diameter_m
    form = 1.0 + 60.0 * slimness**3 + 0.0025 / slimness
    return hull.skin_friction_coefficient * math.pi * planform / strips.frontal_area * form


def axial_drag(strips: HullStrips, rho: float) -> Array:
    """-X_uu alone. Source: Prestero 2001, section 4.2 (axial drag)."""
    D = np.zeros((6, 6))
    D[0, 0] = 0.5 * rho * axial_drag_coefficient(strips) * strips.frontal_area
    return D


def cross_flow_drag(strips: HullStrips, rho: float) -> Array:
    """Drag of the sections in the flow across them, separated into terms of v, w, q and r.

    Source: Prestero 2001, section 4.2 (crossflow drag), hull part.
    """
    x, strip = strips.x, 0.5 * rho * strips.hull.cross_flow_drag_coefficient * 2 * strips.radius
    zero = strips.integral(strip)
    first = strips.integral(strip * x)
    second = strips.integral(strip * x * np.abs(x))
    third = strips.integral(strip * np.abs(x) ** 3)
    return _across(zero, first, second, third)


def fin_cross_flow_drag(fins: Sequence[Fin], rho: float) -> Array:
    """The same for fins as plates across the flow, and their drag in roll.

    A plate whose normal makes an angle with the motion meets cos of it squared and gives cos of it, so a
    plate counts |cos|^3. Only for vehicles without fin actuators in the plant, such as the comparison with
    Prestero 2001: there the fin's own forces come from `bumpless.physics.actuators`.
    Source: Prestero 2001, section 4.2 (crossflow and rolling drag), fin part.
    """
    D = np.zeros((6, 6))
    for fin in fins:
        plate = 0.5 * rho * fin.planform_area_m2 * fin.cross_flow_drag_coefficient
        _, side, down = np.abs(fin.direction) ** 3 * plate
        x = fin.x_m
        D += _across(1.0, x, x * abs(x), abs(x) ** 3) * _rows(side, down)
        D[3, 3] += plate * fin.arm_m**3
    return D


def appendage_drag(appendages: Sequence[Appendage], rho: float) -> Array:
    """Drag of bodies off the hull, each at its own local velocity, diagonal terms only."""
    D = np.zeros((6, 6))
    for part in appendages:
        x, y, z = np.abs(part.position_m)
        kx, ky, kz = 0.5 * rho * np.array(part.drag_area_m2)
        D += np.diag([kx, ky, kz, kz * y**3 + ky * z**3, kx * z**3 + kz * x**3, kx * y**3 + ky * x**3])
    return D


def _across(zero: float, first: float, second: float, third: float) -> Array:
    """D of a body whose moments of c_d-weighted area along x are given; sway uses v + x r, heave w - x q."""
    D = np.zeros((6, 6))
    D[1, 1] = D[2, 2] = zero
    D[5, 1], D[4, 2] = first, -first
    D[1, 5], D[2, 4] = second, -second
    D[4, 4] = D[5, 5] = third
    return D


def _rows(side: float, down: float) -> Array:
    """Weights of the horizontal-plane rows (Y, N) and the vertical-plane rows (Z, M)."""
    return np.array([0.0, side, down, 0.0, down, side])[:, None]
