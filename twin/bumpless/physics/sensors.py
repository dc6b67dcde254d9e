"""What the vehicle can know: INS, DVL, depth, the QR cameras and USBL, with seeded noise.

The autopilot reads a MEASUREMENT record and nothing else. Every random number comes from the noise
row passed in (N_NOISE standard normal samples a cycle) or follows from the flight's key (`physics.noise`),
so that a seed fixes a run to the bit.
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.config.capacity import MAX_CAMERAS, MAX_FRAMES, MAX_OUTAGES
from bumpless.jit import jit
from bumpless.physics.camera import measure_camera
from bumpless.physics.dvl import measure_dvl
from bumpless.physics.noise import HEADING_WALK, normal
from bumpless.physics.usbl import measure_usbl

f8, i8 = np.float64, np.int64

N_NOISE = 24  # samples a cycle: 0 to 2 for the water's gusts, 21 to 23 for its eddies, the others here

SENSORS = np.dtype(  # as their data sheets have them
    [
        ("roll_pitch_std", f8),  # rad
        ("roll_pitch_bias_std", f8),  # rad, drawn once a run
        ("heading_std", f8),  # rad
        ("heading_bias_std", f8),  # rad, drawn once a run
        ("heading_walk", f8),  # rad a cycle: the random walk of its drift
        ("rate_std", f8),  # rad/s
        ("dvl_std", f8),  # m/s
        ("dvl_water_std", f8),  # m/s
        ("dvl_scale_std", f8),  # share, drawn once a run
        ("dvl_water_bias_std", f8),  # m/s, drawn once a run
        ("dvl_altitude_min", f8),  # m above the bottom, for bottom track
        ("dvl_altitude_max", f8),  # m; 0: no limit
        ("dvl_period", i8),  # cycles
        ("dvl_dropout", f8),  # z score below which a sample is lost
        ("depth_std", f8),  # m
        ("depth_bias_std", f8),  # m, drawn once a run
        ("n_cameras", i8),  # the wide one first
        ("camera_position", f8, (MAX_CAMERAS, 3)),  # body, m
        ("camera_pitch", f8, MAX_CAMERAS),  # rad, of the optical axis below x_b
        ("camera_half_angle", f8, MAX_CAMERAS),  # rad
        ("camera_half_vertical", f8, MAX_CAMERAS),  # rad; 0: as the half angle
        ("camera_shape", i8, MAX_CAMERAS),  # ANGLES, RECTANGLE or CONE
        ("camera_range_max", f8, MAX_CAMERAS),  # m
        ("camera_range_min", f8, MAX_CAMERAS),
        ("camera_period", i8),  # cycles
        ("camera_latency", i8),  # cycles from a frame to its sight
        ("camera_dropout", f8),  # z score
        ("camera_outlier", f8),  # share of frames with a false sight
        ("camera_range_std", f8),  # share of range
        ("camera_bearing_std", f8),  # rad
        ("camera_sight", f8),  # attenuation lengths through which the code is read
        ("camera_marker_angle", f8),  # rad, farthest off the marker's normal; pi: from anywhere
        ("usbl_period", i8),  # cycles; 0: there is none
        ("usbl_position", f8, 3),  # body, m
        ("usbl_range_max", f8),  # m
        ("usbl_range_std", f8),  # m
        ("usbl_angle_std", f8),  # rad
        ("usbl_dropout", f8),  # share of replies missed
        ("usbl_outlier", f8),  # share of replies that are false
    ],
    align=True,
)

FRAME = np.dtype(  # of the cameras, on its way through the detector
    [
        ("detected", i8),
        ("camera", i8),
        ("target", f8, 3),
    ],
    align=True,
)

DVL_OUTAGE = np.dtype([("begin", f8), ("end", f8), ("water_track", i8)], align=True)

SENSOR_ERRORS = np.dtype(  # of one flight; nobody on board knows them
    [
        ("noise_scale", f8),  # factor on every error
        ("key", np.uint64),  # of the noise beside the row
        ("roll_pitch_bias", f8, 2),  # rad
        ("heading_bias", f8),  # rad
        ("heading_drift", f8),  # rad, walks
        ("depth_bias", f8),  # m
        ("dvl_scale", f8),  # share
        ("dvl_water_bias", f8, 3),  # m/s, body
        ("water_depth", f8),  # m; 0: the bottom is always in reach
        ("attenuation", f8),  # beam attenuation of the water, 1/m
        ("n_outages", i8),
        ("outage", f8, (MAX_OUTAGES, 2)),  # s, target not seen in between
        ("n_dvl_outages", i8),
        ("dvl_outage", DVL_OUTAGE, (MAX_OUTAGES,)),  # s
        ("frames", FRAME, (MAX_FRAMES,)),  # frame number modulo MAX_FRAMES
    ],
    align=True,
)

MEASUREMENT = np.dtype(  # a sample stays until the sensor gives the next one
    [
        ("attitude", f8, 3),
        ("rates", f8, 3),
        ("velocity", f8, 3),  # over ground, body
        ("velocity_valid", i8),  # 1 in a cycle with a new sample of it
        ("water_velocity", f8, 3),  # through water, body
        ("water_valid", i8),  # 1 in a cycle with a new sample of it
        ("depth", f8),
        ("detected", i8),  # target seen
        ("fresh", i8),  # 1 in a cycle with a new camera frame
        ("camera", i8),  # which of them saw it
        ("target", f8, 3),  # range m, bearing rad, elevation rad in that camera's axes
        ("usbl_fresh", i8),  # 1 in a cycle with a new reply of the target's transponder
        ("usbl", f8, 3),  # range m, bearing rad, elevation rad in body axes, from the USBL's head
        ("u_feedback", f8, _n),
        ("captured", i8),  # the switch of the dock's latch
    ],
    align=True,
)


@jit
def measure(sensors, errors, target, plant, cycle, noise, m):
    """Fill the measurement `m` of a plant that may see a target (4,): NED and approach heading.

    errors: SENSOR_ERRORS, whose drift and frames go on.

    Source: Gao et al. 2026, sec. 4.1 (sensor suite).
    """
    measure_attitude(sensors, errors, plant, cycle, noise, m)
    m.depth = plant.eta[2] + errors.noise_scale * (errors.depth_bias + sensors.depth_std * noise[9])
    for i in range(m.u_feedback.shape[0]):
        m.u_feedback[i] = plant.u[i]
    measure_dvl(sensors, errors, plant, cycle, noise, m)
    measure_camera(sensors, errors, target, plant, cycle, noise, m)
    if sensors.usbl_period > 0:
        measure_usbl(sensors, errors, target, plant, cycle, m)


@jit
def measure_attitude(sensors, errors, plant, cycle, noise, m):
    """Attitude and body rates as the INS gives them; its heading drifts as a random walk.

    Source: IEEE Std 952-1997 (angle random walk, deg/sqrt(h)).
    """
    s = errors.noise_scale
    for k in range(3):
        std = sensors.heading_std if k == 2 else sensors.roll_pitch_std
        m.attitude[k] = plant.eta[3 + k] + s * std * noise[3 + k]
        m.rates[k] = plant.nu[3 + k] + s * sensors.rate_std * noise[6 + k]
    if sensors.roll_pitch_bias_std > 0.0:
        for k in range(2):
            m.attitude[k] += s * errors.roll_pitch_bias[k]
    if sensors.heading_walk > 0.0:
        errors.heading_drift += sensors.heading_walk * normal(errors.key, cycle, HEADING_WALK)
    m.attitude[2] += s * (errors.heading_bias + errors.heading_drift)
