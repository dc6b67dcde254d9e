"""What a run cost its actuators: work at the shafts, way of the fins, reversals of the screws."""

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from bumpless.config.vehicle.parts import Azimuth, Screw, Thruster
from bumpless.contract.units import DEG, RPM
from bumpless.metrics.columns import Columns, Floats, dots

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

TURNING = 0.02  # of the largest shaft speed: slower than this a screw counts as standing


@dataclass(frozen=True)
class Cost:
    """Over a whole run, all actuators together."""

    shaft_energy_j: float
    fin_travel_deg: float
    screw_reversals: int


def cost_of(run: Columns, vehicle: "Vehicle") -> Cost:
    """From the measured shaft speeds and deflections; no cycle that is missing counts.

    Work is 2 pi n Q by the vehicle's own torque law with the believed flow; a screw that the water drives
    gives nothing back.
    """
    energy, travel, reversals, slot = 0.0, 0.0, 0, 0
    density = vehicle.environment.water_density_kgpm3
    for actuator in vehicle.actuators:
        told = run.u_feedback[:, slot : slot + len(actuator.commands)]
        slot += len(actuator.commands)
        if isinstance(actuator, Thruster | Azimuth):
            n = told[:, 0]
            power = 2.0 * pi * n * shaft_torque(actuator, density, n, _inflow(run, actuator, told[:, 1:]))
            energy += float(np.sum(np.maximum(power, 0.0))) * vehicle.control_period_s
            fastest = max(actuator.shaft_speed_max_rpm, -actuator.shaft_speed_min_rpm) / RPM
            reversals += _reversals(n, TURNING * fastest)
        else:
            way = np.abs(np.diff(told[:, 0], prepend=told[:1, 0]))
            travel += float(np.sum(way[run.follows])) * DEG
    return Cost(energy, travel, reversals)


def shaft_torque(screw: Screw, density: float, n: Floats, inflow: Floats) -> Floats:
    """Q = rho D^5 K_Q(J) n|n| with K_Q falling linearly in J, N m. Source: Gao et al. 2026, eqs. (9)-(12)."""
    D = screw.diameter_m
    turning = density * D**5 * screw.torque_coefficient * n * np.abs(n)
    return turning - density * D**4 * screw.torque_slope * np.abs(n) * inflow


def _inflow(run: Columns, screw: Thruster | Azimuth, angle: Floats) -> Floats:
    """V_A along the thrust at the screw's place, m/s. angle: a pod's (n, 1), x_b to y_b, rad; else (n, 0)."""
    d = np.array(screw.direction) / np.linalg.norm(screw.direction)
    along = np.broadcast_to(d, (len(run), 3))
    if angle.shape[1]:
        along = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(len(run))])
    flow = run.nu_r_hat + np.cross(run.nu_hat[:, 3:], np.array(screw.position_m))
    return (1.0 - screw.wake_fraction) * dots(flow, along)


def _reversals(n: Floats, turning: float) -> int:
    sense = np.sign(n[np.abs(n) > turning])
    return int(np.count_nonzero(np.diff(sense)))
