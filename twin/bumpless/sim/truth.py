"""What is true of a simulated flight: its sea, its target, its faults, its noise and where it starts.

Plant, sensors and log read the TRUTH record. The autopilot never sees it: it flies by the PLAN record and by
measurements. `tell` is the only way from the one to the other and names all that a vehicle is told.
"""

from math import radians

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle
from bumpless.records import FAULT_FIELDS, MAX_OUTAGES, f8, i8

TRUTH = np.dtype(
    [
        ("start", f8, 6),  # eta
        ("start_speed", f8),  # surge through water, m/s
        ("target", f8, 4),  # marker position NED, approach heading
        ("standoff", f8),  # m before the marker
        # environment
        ("current", f8, 3),  # NED mean, m/s
        ("gust_std", f8),  # m/s
        ("gust_time", f8),  # s
        ("wave_height", f8),  # m
        ("wave_period", f8),  # s
        ("wave_direction", f8),  # rad, towards
        ("tau_e", f8, 6),  # constant external load, N and N m
        # sensors
        ("noise_scale", f8),
        ("n_outages", i8),
        ("outage", f8, (MAX_OUTAGES, 2)),  # s, target not seen in between
        *FAULT_FIELDS,
    ],
    align=True,
)

TOLD = ("start", "start_speed")  # a vehicle is put on its start and knows where that is
TOLD_OF_FAULTS = tuple(field[0] for field in FAULT_FIELDS)


def truth_of(mission: Mission, vehicle: Vehicle) -> np.ndarray:
    """TRUTH record of a mission, shape (1,)."""
    out = np.zeros(1, TRUTH)
    t, env, target = out[0], mission.environment, mission.target
    t["start"] = [*mission.start.position_ned_m, 0.0, 0.0, radians(mission.start.heading_deg)]
    t["start_speed"] = mission.start.speed_mps
    t["target"] = [*target.true_position_ned_m, radians(target.heading_deg)]
    t["standoff"] = target.standoff_m
    t["current"] = env.current_ned_mps
    if env.current_variation:
        t["gust_std"], t["gust_time"] = env.current_variation.std_mps, env.current_variation.time_constant_s
    if env.wave:
        t["wave_height"], t["wave_period"] = env.wave.height_m, env.wave.period_s
        t["wave_direction"] = radians(env.wave.direction_deg)
    t["tau_e"] = env.disturbance_body_n_nm
    t["noise_scale"] = mission.sensors.noise_scale
    t["n_outages"] = len(mission.sensors.outages)
    for i, outage in enumerate(mission.sensors.outages):
        t["outage"][i] = outage.from_s, outage.to_s
    names = [command.actuator for command in vehicle.commands]
    t["n_faults"] = len(mission.faults)
    for i, fault in enumerate(mission.faults):
        t["fault_actuator"][i] = names.index(fault.actuator)
        t["fault_time"][i], t["fault_blend"][i] = fault.at_s, fault.blend_s
        t["fault_effectiveness"][i] = fault.effectiveness
    return out


def tell(truth: np.ndarray, plan: np.ndarray, faults: bool = True) -> None:
    """Copy into the PLAN record what a vehicle is told of the TRUTH record (each shape (1,)).

    The start, and the faults as they are: in scenario S6 of Gao et al. 2026 the effectiveness is known, so it
    must follow the drawn plant's. The autopilot looks at faults only with `allocation.fault_tolerant`; one
    that estimates effectiveness (S7) is told of none.
    """
    for name in (*TOLD, *TOLD_OF_FAULTS):
        plan[0][name] = truth[0][name]
    if not faults:
        plan[0]["n_faults"] = 0
