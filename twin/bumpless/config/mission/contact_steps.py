"""How finely contact with a dock is integrated so that it makes no energy, from the data of dock and hull."""

from math import ceil, sqrt

from bumpless.config.mission.dock import Dock
from bumpless.config.vehicle import Vehicle

MOST = 400  # steps in a control period, beyond which a dock is refused
POINTS_AT_ONCE = 24  # springs that press side by side on a hull that lies against a wall; assumed
_OSCILLATION, _RELAXATION = 0.5, 2.0  # largest step times rate: for peaks to 1 %; within RK4's limit of 2.8


def contact_steps(dock: Dock, vehicle: Vehicle) -> int:
    """Runge-Kutta steps in a control period, up to the force that dock and hull bear.

    Rates: sqrt(k / m) of the springs, c F / m of their damping, mu F / (v_slip m) of friction near zero slip;
    m is what is felt at the nose, which swings out, 1 / (1/m + x^2 / I).
    """
    x, inertia = vehicle.ends_m[0], vehicle.mass.moments_of_inertia_kgm2[2]
    mass = 1.0 / (1.0 / vehicle.mass.mass_kg + x * x / inertia)
    swing = sqrt(POINTS_AT_ONCE * dock.stiffness_npm / mass) / _OSCILLATION
    loss = dock.force_most_n * max(dock.damping_spm, dock.friction / dock.slip_speed_mps) / mass / _RELAXATION
    return ceil(vehicle.control_period_s * max(swing, loss))
