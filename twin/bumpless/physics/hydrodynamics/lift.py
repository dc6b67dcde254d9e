"""Body lift: the side force of a hull in oblique flow, and its moment against Munk's."""

import numpy as np
from numpy.typing import NDArray

from bumpless.physics.hydrodynamics.myring import HullStrips


def body_lift(strips: HullStrips, rho: float) -> NDArray[np.float64]:
    """D_lift (6, 6): tau_i = -D_ij s_i nu_j with s = |u| in the force rows and u in the moment rows.

    Force -L |u| [v w], L = rho d^2 c_ydb / 2. It acts at x_cp in forward flow and as far ahead of O_b in
    reverse flow, so its moment changes sign with u. The Munk moment is not here: it is part of C_A(nu_r).
    Fin lift is not here: it belongs to the fins.
    Source: Prestero 2001, section 4.4, after Hoerner 1965.
    """
    hull = strips.hull
    L = 0.5 * rho * hull.diameter_m**2 * hull.body_lift_slope_per_rad
    D = np.zeros((6, 6))
    D[1, 1] = D[2, 2] = L
    D[4, 2] = -hull.body_lift_x_m * L
    D[5, 1] = hull.body_lift_x_m * L
    return D
