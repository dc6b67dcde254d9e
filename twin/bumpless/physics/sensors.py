"""What the vehicle can know: INS, DVL, depth and the QR camera, with seeded noise.

The autopilot reads a MEASUREMENT record and nothing else. Every random number comes from the noise
row passed in (N_NOISE standard normal samples a cycle), so that a seed fixes a run to the bit.
"""

from math import atan2, cos, sin, sqrt

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.config.capacity import MAX_OUTAGES
from bumpless.jit import jit
from bumpless.physics.frames import body_to_ned, ned_to_body

f8, i8 = np.float64, np.int64

N_NOISE = 24  # samples a cycle: 0 to 2 for the water's gusts, the others here

SENSORS = np.dtype(  # as their data sheets have them
    [
        ("roll_pitch_std", f8),  # rad
        ("heading_std", f8),  # rad
        ("heading_bias_std", f8),  # rad, drawn once a run
        ("rate_std", f8),  # rad/s
        ("dvl_std", f8),  # m/s
        ("dvl_water_std", f8),  # m/s
        ("dvl_period", i8),  # cycles
        ("dvl_dropout", f8),  # z score below which a sample is lost
        ("depth_std", f8),  # m
        ("depth_bias_std", f8),  # m, drawn once a run
        ("camera_position", f8, 3),  # body, m
        ("camera_pitch", f8),  # rad, of the optical axis below x_b
        ("camera_half_angle", f8),  # rad
        ("camera_range_max", f8),  # m
        ("camera_range_min", f8),
        ("camera_period", i8),  # cycles
        ("camera_dropout", f8),  # z score
        ("camera_range_std", f8),  # share of range
        ("camera_bearing_std", f8),  # rad
    ],
    align=True,
)

SENSOR_ERRORS = np.dtype(  # of one flight; nobody on board knows them
    [
        ("noise_scale", f8),  # factor on every error
        ("heading_bias", f8),  # rad
        ("depth_bias", f8),  # m
        ("n_outages", i8),
        ("outage", f8, (MAX_OUTAGES, 2)),  # s, target not seen in between
    ],
    align=True,
)

MEASUREMENT = np.dtype(  # a sample stays until the sensor gives the next one
    [
        ("attitude", f8, 3),
        ("rates", f8, 3),
        ("velocity", f8, 3),  # over ground, body
        ("velocity_valid", i8),  # 1 in a cycle with a new sample
        ("water_velocity", f8, 3),  # through water, body
        ("depth", f8),
        ("detected", i8),  # target seen
        ("fresh", i8),  # 1 in a cycle with a new camera frame
        ("target", f8, 3),  # range m, bearing rad, elevation rad in camera axes
        ("u_feedback", f8, _n),
    ],
    align=True,
)


@jit
def camera_view(sensors, eta, target, out):
    """out (3,) = range (m), bearing and elevation (rad) of a NED point in the camera's axes.

    Bearing positive to starboard, elevation positive down.
    """
    rel = out
    for k in range(3):
        rel[k] = target[k] - eta[k]
    ned_to_body(eta[3], eta[4], eta[5], rel, rel)
    x = rel[0] - sensors.camera_position[0]
    y = rel[1] - sensors.camera_position[1]
    z = rel[2] - sensors.camera_position[2]
    cp, sp = cos(sensors.camera_pitch), sin(sensors.camera_pitch)
    x, z = cp * x + sp * z, -sp * x + cp * z
    out[0] = sqrt(x * x + y * y + z * z)
    out[1] = atan2(y, x)
    out[2] = atan2(z, sqrt(x * x + y * y))


@jit
def measure(sensors, errors, target, plant, cycle, noise, m):
    """Fill the measurement `m` of a plant that may see a target (3,), NED. `errors`: SENSOR_ERRORS.

    Source: Gao et al. 2026, sec. 4.1 (sensor suite).
    """
    s = errors.noise_scale
    for k in range(3):
        std = sensors.heading_std if k == 2 else sensors.roll_pitch_std
        m.attitude[k] = plant.eta[3 + k] + s * std * noise[3 + k]
        m.rates[k] = plant.nu[3 + k] + s * sensors.rate_std * noise[6 + k]
    m.attitude[2] += s * errors.heading_bias
    m.depth = plant.eta[2] + s * (errors.depth_bias + sensors.depth_std * noise[9])
    for i in range(m.u_feedback.shape[0]):
        m.u_feedback[i] = plant.u[i]

    m.velocity_valid = 0
    if cycle % max(1, sensors.dvl_period) == 0 and noise[10] >= sensors.dvl_dropout:
        m.velocity_valid = 1
        ned_to_body(plant.eta[3], plant.eta[4], plant.eta[5], plant.seen.current, m.water_velocity)
        for k in range(3):
            m.velocity[k] = plant.nu[k] + s * sensors.dvl_std * noise[11 + k]
            m.water_velocity[k] = (
                plant.nu[k] - m.water_velocity[k] + s * sensors.dvl_water_std * noise[14 + k]
            )

    m.fresh = 0
    if cycle % max(1, sensors.camera_period) == 0:
        m.fresh = 1
        camera_view(sensors, plant.eta, target, m.target)
        seen = (
            abs(m.target[1]) <= sensors.camera_half_angle
            and abs(m.target[2]) <= sensors.camera_half_angle
            and sensors.camera_range_min <= m.target[0] <= sensors.camera_range_max
            and noise[17] >= sensors.camera_dropout
        )
        for k in range(errors.n_outages):
            if errors.outage[k, 0] <= plant.time < errors.outage[k, 1]:
                seen = False
        m.detected = 1 if seen else 0
        m.target[0] *= 1.0 + s * sensors.camera_range_std * noise[18]
        m.target[1] += s * sensors.camera_bearing_std * noise[19]
        m.target[2] += s * sensors.camera_bearing_std * noise[20]


@jit
def target_position(sensors, eta, view, out):
    """out (3,) = NED position of what the camera sees at `view` (range, bearing, elevation): the inverse
    of `camera_view`."""
    ce, se = cos(view[2]), sin(view[2])
    x, y, z = view[0] * ce * cos(view[1]), view[0] * ce * sin(view[1]), view[0] * se
    cp, sp = cos(sensors.camera_pitch), sin(sensors.camera_pitch)
    x, z = cp * x - sp * z, sp * x + cp * z
    out[0] = x + sensors.camera_position[0]
    out[1] = y + sensors.camera_position[1]
    out[2] = z + sensors.camera_position[2]
    body_to_ned(eta[3], eta[4], eta[5], out, out)
    for k in range(3):
        out[k] += eta[k]
