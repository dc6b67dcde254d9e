"""What is true of a simulated flight: its sea, its target, its faults, its noise and where it starts.

Plant, sensors and log read the TRUTH record. The autopilot is never handed it: it flies by the PLAN and by
measurements. `tell` is the only way from the one to the other and names all that a vehicle is told.
"""

from math import radians

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.mission.contact_steps import contact_steps
from bumpless.config.vehicle import Vehicle
from bumpless.physics.faults import FAULTS
from bumpless.physics.sensors import SENSOR_ERRORS
from bumpless.physics.water import ENVIRONMENT

f8 = np.float64

TRUTH = np.dtype(
    [
        ("start", f8, 6),  # eta
        ("start_speed", f8),  # surge through water, m/s
        ("target", f8, 4),  # marker position NED, approach heading
        ("standoff", f8),  # m before the marker
        ("environment", ENVIRONMENT),
        ("errors", SENSOR_ERRORS),
        ("faults", FAULTS),
    ],
    align=True,
)

TOLD = ("start", "start_speed", "faults")  # a vehicle is put on its start and knows where that is


def truth_of(mission: Mission, vehicle: Vehicle) -> np.ndarray:
    """TRUTH record of a mission, shape (1,)."""
    out = np.zeros(1, TRUTH)
    t, target = out[0], mission.target
    t["start"] = [*mission.start.position_ned_m, 0.0, 0.0, radians(mission.start.heading_deg)]
    t["start_speed"] = mission.start.speed_mps
    t["target"] = [*target.true_position_ned_m, radians(target.heading_deg)]
    t["standoff"] = target.standoff_m
    _environment(t["environment"], mission)
    _dock(t["environment"]["dock"], mission, vehicle)
    errors, faults = t["errors"], t["faults"]
    errors["noise_scale"] = mission.sensors.noise_scale
    errors["n_outages"] = len(mission.sensors.outages)
    for i, outage in enumerate(mission.sensors.outages):
        errors["outage"][i] = outage.from_s, outage.to_s
    errors["n_dvl_outages"] = len(mission.sensors.dvl_outages)
    for i, outage in enumerate(mission.sensors.dvl_outages):
        errors["dvl_outage"][i] = outage.from_s, outage.to_s, outage.water_track
    errors["water_depth"] = mission.environment.water_depth_m
    errors["attenuation"] = mission.environment.beam_attenuation_per_m
    names = [command.actuator for command in vehicle.commands]
    faults["n"] = len(mission.faults)
    for i, fault in enumerate(mission.faults):
        faults["actuator"][i] = names.index(fault.actuator)
        faults["time"][i], faults["blend"][i] = fault.at_s, fault.blend_s
        faults["effectiveness"][i] = fault.effectiveness
    return out


def _environment(out: np.void, mission: Mission) -> None:
    env = mission.environment
    out["current"], out["surface"] = env.current_ned_mps, 1
    if env.current_variation:
        out["gust_std"] = env.current_variation.std_mps
        out["gust_time"] = env.current_variation.time_constant_s
    if env.wave:
        out["wave_height"], out["wave_period"] = env.wave.height_m, env.wave.period_s
        out["wave_direction"] = radians(env.wave.direction_deg)
        out["wave_second_order"] = env.wave.second_order
    out["n_profile"] = len(env.current_profile)
    for i, entry in enumerate(env.current_profile):
        out["profile_depth"][i], out["profile_current"][i] = entry.depth_m, entry.current_ned_mps
    if env.shelter:
        out["shelter_place"] = mission.target.true_position_ned_m
        out["shelter_width"], out["shelter_drag"] = env.shelter.width_m, env.shelter.drag_coefficient
        out["shelter_growth"], out["shelter_turbulence"] = env.shelter.growth, env.shelter.turbulence
    out["tau_e"] = env.disturbance_body_n_nm


def _dock(out: np.void, mission: Mission, vehicle: Vehicle) -> None:
    """The dock to enter, and the motion of the target, with or without one."""
    target, dock, motion = mission.target, mission.target.dock, mission.target.motion
    out["entry"], out["heading"] = target.true_position_ned_m, radians(target.heading_deg)
    if motion:
        out["amplitude"], out["period"] = motion.amplitude_ned_m, motion.period_s
        out["phase"] = radians(motion.phase_deg)
    if dock is None:
        return
    out["present"], out["steps"] = 1, contact_steps(dock, vehicle)
    out["marker"][0] = dock.entry_before_marker_m * np.cos(out["heading"])
    out["marker"][1] = dock.entry_before_marker_m * np.sin(out["heading"])
    out["entry"] -= out["marker"]
    for name, value in (
        ("entry_radius", dock.entry_radius_m), ("tube_radius", dock.tube_radius_m),
        ("cone_length", dock.cone_length_m), ("tube_length", dock.tube_length_m), ("wall", dock.wall_m),
        ("capture_depth", dock.capture_depth_m), ("stiffness", dock.stiffness_npm),
        ("damping", dock.damping_spm), ("friction", dock.friction), ("slip_speed", dock.slip_speed_mps),
        ("force_most", dock.force_most_n),
    ):  # fmt: skip
        out[name] = value


def tell(truth: np.void, plan: np.void, faults: bool = True) -> None:
    """Copy into the PLAN record what a vehicle is told of the TRUTH record.

    The start, and the faults as they are: in scenario S6 of Gao et al. 2026 the effectiveness is known, so it
    must follow the drawn plant's. The autopilot looks at faults only with `allocation.fault_tolerant`; one
    that estimates effectiveness (S7) is told of none.
    """
    for name in TOLD:
        plan[name] = truth[name]
    if not faults:
        plan["faults"]["n"] = 0
