"""What a run cost its actuators: work at the shafts, way of the fins, reversals of the screws."""

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from bumpless.config.vehicle import Thruster
from bumpless.contract.units import DEG
from bumpless.metrics.columns import Columns, Floats

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
    energy, travel, reversals = 0.0, 0.0, 0
    density = vehicle.environment.water_density_kgpm3
    for i, actuator in enumerate(vehicle.actuators):
        if isinstance(actuator, Thruster):
            n = run.u_feedback[:, i]
            power = 2.0 * pi * n * shaft_torque(actuator, density, n, _inflow(run, actuator))
            energy += float(np.sum(np.maximum(power, 0.0))) * vehicle.control_period_s
            reversals += _reversals(n, TURNING * max(actuator.command_max, -actuator.command_min) / 60.0)
        else:
            way = np.abs(np.diff(run.u_feedback[:, i], prepend=run.u_feedback[:1, i]))
            travel += float(np.sum(way[run.follows])) * DEG
    return Cost(energy, travel, reversals)


def shaft_torque(screw: Thruster, density: float, n: Floats, inflow: Floats) -> Floats:
    """Q = rho D^5 K_Q(J) n|n| with K_Q falling linearly in J, N m. Source: Gao et al. 2026, eqs. (9)-(12)."""
    D = screw.diameter_m
    turning = density * D**5 * screw.torque_coefficient * n * np.abs(n)
    return turning - density * D**4 * screw.torque_slope * np.abs(n) * inflow


def _inflow(run: Columns, screw: Thruster) -> Floats:
    """V_A along the thrust at the screw's place, m/s."""
    d = np.array(screw.direction) / np.linalg.norm(screw.direction)
    flow = run.nu_r_hat + np.cross(run.nu_hat[:, 3:], np.array(screw.position_m))
    return (1.0 - screw.wake_fraction) * (flow @ d)


def _reversals(n: Floats, turning: float) -> int:
    sense = np.sign(n[np.abs(n) > turning])
    return int(np.count_nonzero(np.diff(sense)))
