"""Vehicle -> MODEL record: the numbers that compiled code works on, SI, radians and rev/s."""

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.flow import ScrewFlow
from bumpless.config.vehicle.parts import Fin, Mass, MyringHull
from bumpless.contract.units import WRENCH
from bumpless.physics.actuators import fill_actuator
from bumpless.physics.actuators.screw_flow import fill_screw_flow
from bumpless.physics.actuators.thruster import HAND
from bumpless.physics.dock.contact import hull_rings
from bumpless.physics.hydrodynamics import hull_coefficients
from bumpless.physics.hydrodynamics.myring import HullStrips
from bumpless.physics.model_record import MODEL


def build_model(vehicle: Vehicle) -> np.record:
    """One record of type MODEL; unused entries are zero.

    Raises: ValueError when an actuator's kind is not known.
    """
    model = np.zeros(1, MODEL)[0]
    water, mass = vehicle.environment, vehicle.mass
    model["rho"] = water.water_density_kgpm3
    model["weight"] = mass.mass_kg * water.gravity_mps2
    model["buoyancy"] = water.water_density_kgpm3 * mass.displaced_volume_m3 * water.gravity_mps2
    model["r_g"] = mass.center_of_gravity_m
    model["r_b"] = mass.center_of_buoyancy_m
    coefficients = hull_coefficients(vehicle)
    model["M_RB"] = rigid_body_mass(mass)
    model["M_A"] = coefficients.M_A
    model["M_inv"] = np.linalg.inv(model["M_RB"] + coefficients.M_A)
    model["D_linear"] = coefficients.D_linear
    model["D_quadratic"] = coefficients.D_quadratic
    model["D_lift"] = coefficients.D_lift
    model["controllable"] = [float(name in vehicle.controllable) for name in WRENCH]
    model["half_height"] = vehicle.hull.diameter_m / 2.0
    if isinstance(vehicle.hull, MyringHull):
        strips = HullStrips(vehicle.hull)
        model["rings"] = hull_rings(strips.x[::-1], strips.radius[::-1])[0]
    end = 0
    for actuator in vehicle.actuators:
        end = fill_actuator(model, end, actuator, water.water_density_kgpm3)
    model["n_u"] = end
    return model


def fill_flow(model: np.record, vehicle: Vehicle) -> None:
    """Add to a MODEL record what the vehicle's file says of flow at screws and fins, and switch it on."""
    first = first_slots(vehicle)
    model["flow"] = 1
    for i, actuator in zip(first.values(), vehicle.actuators, strict=True):
        if isinstance(actuator, Fin):
            if actuator.wash:
                model["washed_by"][i] = 1 + first[actuator.wash.screw]
                model["washed_share"][i] = actuator.wash.share
        else:
            fill_screw_flow(model, i, actuator, actuator.flow or ScrewFlow(), HAND[actuator.hand])


def first_slots(vehicle: Vehicle) -> dict[str, int]:
    """The first slot of each actuator, by its name."""
    ends = np.cumsum([len(actuator.commands) for actuator in vehicle.actuators])
    return {a.name: int(end) - len(a.commands) for a, end in zip(vehicle.actuators, ends, strict=True)}


def rigid_body_mass(mass: Mass) -> NDArray[np.float64]:
    """M_RB about O_b, (6, 6). Source: Fossen 2021, eq. (3.49)."""
    m, S = mass.mass_kg, skew(mass.center_of_gravity_m)
    inertia = np.diag(mass.moments_of_inertia_kgm2)
    inertia[0, 2] = inertia[2, 0] = -mass.product_of_inertia_xz_kgm2
    M = np.zeros((6, 6))
    M[:3, :3] = m * np.eye(3)
    M[:3, 3:] = -m * S
    M[3:, :3] = m * S
    M[3:, 3:] = inertia - m * S @ S
    return M


def skew(r: tuple[float, float, float]) -> NDArray[np.float64]:
    """S(r) with S(r) a = r x a, (3, 3)."""
    x, y, z = r
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
