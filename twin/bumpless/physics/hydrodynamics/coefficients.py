"""All hydrodynamic coefficients of a vehicle in the plant's arrangement."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.parts import Fin, TabulatedHull
from bumpless.physics.hydrodynamics.added_mass import added_mass
from bumpless.physics.hydrodynamics.drag import appendage_drag, axial_drag, cross_flow_drag
from bumpless.physics.hydrodynamics.lift import body_lift
from bumpless.physics.hydrodynamics.myring import HullStrips
from bumpless.physics.hydrodynamics.published import published_matrices


@dataclass(frozen=True)
class Coefficients:
    """Matrices (6, 6) about O_b, SI, rows and columns in the order X Y Z K M N.

    tau_hydro = -M_A nu_dot - C_A nu - (D_linear + D_quadratic |nu_j| + D_lift s_i) nu, see MODEL.
    """

    M_A: NDArray[np.float64]
    D_linear: NDArray[np.float64]
    D_quadratic: NDArray[np.float64]
    D_lift: NDArray[np.float64]


def hull_coefficients(vehicle: Vehicle) -> Coefficients:
    """Coefficients of hull and appendages; fins add to the added mass only.

    The fins' lift and drag depend on deflection and local flow and come from `bumpless.physics.actuators`.
    Source: Prestero 2001, chapter 4, arranged as in Gao et al. 2026, eqs. (1)-(7).
    """
    hull, rho = vehicle.hull, vehicle.environment.water_density_kgpm3
    extra = appendage_drag(vehicle.appendages, rho)
    D_linear = np.diag(hull.linear_damping)
    if isinstance(hull, TabulatedHull):
        quadratic = np.diag(hull.quadratic_damping) + extra
        return Coefficients(np.diag(hull.added_mass), D_linear, quadratic, np.zeros((6, 6)))
    fins = [a for a in vehicle.actuators if isinstance(a, Fin)]
    if hull.coefficients:
        M_A, quadratic, lift = published_matrices(hull.coefficients, fins, rho)
        return Coefficients(M_A, D_linear, quadratic + extra, lift)
    strips = HullStrips(hull)
    quadratic = axial_drag(strips, rho) + cross_flow_drag(strips, rho) + extra
    return Coefficients(added_mass(strips, fins, rho), D_linear, quadratic, body_lift(strips, rho))
