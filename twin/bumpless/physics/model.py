"""Vehicle -> MODEL record: the numbers that compiled code works on, SI, radians and rev/s."""

import math

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.parts import Fin, Mass, Thruster
from bumpless.contract.units import WRENCH
from bumpless.physics.hydrodynamics import hull_coefficients
from bumpless.physics.model_record import FIN, MODEL, THRUSTER

HAND = {"right": -1.0, "left": 1.0, "balanced": 0.0}


def build_model(vehicle: Vehicle) -> np.record:
    """One record of type MODEL; unused actuator entries are zero."""
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
    model["n_u"] = len(vehicle.actuators)
    for i, actuator in enumerate(vehicle.actuators):
        if isinstance(actuator, Fin):
            _fin(model, i, actuator)
        else:
            _thruster(model, i, actuator, water.water_density_kgpm3)
    return model


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


def _fin(model: np.record, i: int, fin: Fin) -> None:
    model["kind"][i] = FIN
    model["position"][i] = fin.position_m
    model["direction"][i] = fin.direction
    model["command_min"][i] = -math.radians(fin.deflection_max_deg)
    model["command_max"][i] = math.radians(fin.deflection_max_deg)
    model["command_rate"][i] = math.radians(fin.deflection_rate_degps)
    model["time_constant"][i] = fin.time_constant_s
    model["fin_area"][i] = fin.planform_area_m2
    model["C_La"][i] = fin.lift_slope_per_rad
    model["C_D0"][i] = fin.drag_coefficient_zero
    model["C_D2"][i] = fin.drag_rise_per_rad2
    model["stall_angle"][i] = math.radians(fin.stall_angle_deg)
    model["reverse_lift"][i] = fin.reverse_lift_share


def _thruster(model: np.record, i: int, thruster: Thruster, rho: float) -> None:
    D, inflow = thruster.diameter_m, 1.0 - thruster.wake_fraction
    model["kind"][i] = THRUSTER
    model["position"][i] = thruster.position_m
    model["direction"][i] = np.array(thruster.direction) / np.linalg.norm(thruster.direction)
    model["command_min"][i] = thruster.shaft_speed_min_rpm / 60.0
    model["command_max"][i] = thruster.shaft_speed_max_rpm / 60.0
    model["command_rate"][i] = thruster.shaft_acceleration_rpmps / 60.0
    model["time_constant"][i] = thruster.time_constant_s
    model["T_nn"][i] = rho * D**4 * thruster.thrust_coefficient
    model["T_nn_reverse"][i] = model["T_nn"][i] * thruster.reverse_thrust_share
    model["T_nv"][i] = rho * D**3 * thruster.thrust_slope * inflow
    # a right-handed screw turns about its thrust; the water's torque on it, and so on the hull, is against
    hand = HAND[thruster.hand]
    model["Q_nn"][i] = hand * rho * D**5 * thruster.torque_coefficient
    model["Q_nv"][i] = hand * rho * D**4 * thruster.torque_slope * inflow
