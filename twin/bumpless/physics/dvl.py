"""Doppler log: velocity over ground while it has the bottom, and through water, in body axes.

Source: Teledyne RD Instruments, Pathfinder DVL Guide 2018 (bottom track needs the bottom between a least and
a greatest altitude; water track is what is left without it); Fossen 2021, ch. 14 (scale error and bias).
"""

from bumpless.jit import jit
from bumpless.physics.frames import ned_to_body


@jit
def measure_dvl(sensors, errors, plant, cycle, noise, m):
    """Velocity over ground and through water with scale error, bias and noise; what is lost stays as it was.

    errors: SENSOR_ERRORS; noise: the cycle's row.
    """
    m.velocity_valid = m.water_valid = 0
    if cycle % max(1, sensors.dvl_period) != 0 or noise[10] < sensors.dvl_dropout:
        return
    bottom, water = 1 if bottom_in_reach(sensors, errors, plant.eta[2]) else 0, 1
    for k in range(errors.n_dvl_outages):
        outage = errors.dvl_outage[k]
        if outage.begin <= plant.time < outage.end:
            bottom, water = 0, min(water, outage.water_track)
    m.velocity_valid, m.water_valid = bottom, water
    s, scale = errors.noise_scale, 1.0 + errors.noise_scale * errors.dvl_scale
    if bottom == 1:
        for k in range(3):
            m.velocity[k] = scale * plant.nu[k] + s * sensors.dvl_std * noise[11 + k]
    if water == 1:
        ned_to_body(plant.eta[3], plant.eta[4], plant.eta[5], plant.seen.current, m.water_velocity)
        for k in range(3):
            through = scale * (plant.nu[k] - m.water_velocity[k]) + s * errors.dvl_water_bias[k]
            m.water_velocity[k] = through + s * sensors.dvl_water_std * noise[14 + k]


@jit
def bottom_in_reach(sensors, errors, depth):
    """Whether the bottom is within the altitudes of bottom track; without a depth of water it always is."""
    if errors.water_depth <= 0.0:
        return True
    altitude = errors.water_depth - depth
    if altitude < sensors.dvl_altitude_min:
        return False
    return sensors.dvl_altitude_max <= 0.0 or altitude <= sensors.dvl_altitude_max
