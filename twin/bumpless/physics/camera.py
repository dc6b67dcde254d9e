"""Cameras that find the target by its code: where they look, how far, through which water, and how late.

The wide camera is the first; where a near one sees the code too, its sight counts. A sight is range,
bearing (positive to starboard) and elevation (positive down) in the camera's axes.
"""

from math import atan2, cos, pi, sin, sqrt, tan

from bumpless.config.capacity import MAX_FRAMES
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import body_to_ned, ned_to_body
from bumpless.physics.noise import (
    CONTRAST,
    FALSE_BEARING,
    FALSE_ELEVATION,
    FALSE_RANGE,
    FALSE_SIGHT,
    normal,
    uniform,
)

ANGLES, RECTANGLE, CONE = 0, 1, 2  # forms of a field of view, in the order of their words in vehicle files

CONTRAST_SPREAD = 0.3  # of the logarithm of contrast from frame to frame: drifting particles; assumed


@jit
def view_from(position, pitch, eta, point, out):
    """out (3,) = range (m), bearing and elevation (rad) of a NED point, from a place in body axes whose own
    axes are pitched down by `pitch`, rad."""
    rel = out
    for k in range(3):
        rel[k] = point[k] - eta[k]
    ned_to_body(eta[3], eta[4], eta[5], rel, rel)
    x = rel[0] - position[0]
    y = rel[1] - position[1]
    z = rel[2] - position[2]
    cp, sp = cos(pitch), sin(pitch)
    x, z = cp * x + sp * z, -sp * x + cp * z
    out[0] = sqrt(x * x + y * y + z * z)
    out[1] = atan2(y, x)
    out[2] = atan2(z, sqrt(x * x + y * y))


@jit
def place_seen(position, pitch, eta, view, out):
    """out (3,) = NED position of what is seen at `view` (range, bearing, elevation): the inverse of
    `view_from`."""
    ce, se = cos(view[2]), sin(view[2])
    x, y, z = view[0] * ce * cos(view[1]), view[0] * ce * sin(view[1]), view[0] * se
    cp, sp = cos(pitch), sin(pitch)
    x, z = cp * x - sp * z, sp * x + cp * z
    out[0] = x + position[0]
    out[1] = y + position[1]
    out[2] = z + position[2]
    body_to_ned(eta[3], eta[4], eta[5], out, out)
    for k in range(3):
        out[k] += eta[k]


@jit
def in_view(sensors, i, view):
    """Whether camera i has a sight (range, bearing, elevation) within its range and field of view.

    ANGLES bounds bearing and elevation; RECTANGLE is a sensor chip behind a pinhole, x' = tan(bearing);
    CONE a round window.
    """
    if not sensors.camera_range_min[i] <= view[0] <= sensors.camera_range_max[i]:
        return False
    across, up = sensors.camera_half_angle[i], sensors.camera_half_vertical[i]
    up = up if up > 0.0 else across
    if sensors.camera_shape[i] == ANGLES:
        return abs(view[1]) <= across and abs(view[2]) <= up
    ahead = cos(view[2]) * cos(view[1])
    if ahead <= 0.0:
        return False
    if sensors.camera_shape[i] == CONE:
        return ahead >= cos(across)
    return abs(tan(view[1])) <= tan(across) and abs(sin(view[2])) <= tan(up) * ahead


@jit
def faces(sensors, i, eta, target):
    """Whether camera i is in front of the marker's face: no farther off its normal than can be read.

    The marker faces whom approaches it: its normal is against the approach heading target[3], horizontal.
    """
    if sensors.camera_marker_angle >= pi:
        return True
    place = floats(3)
    body_to_ned(eta[3], eta[4], eta[5], sensors.camera_position[i], place)
    along, square = 0.0, 0.0
    for k in range(3):
        gap = place[k] + eta[k] - target[k]
        square += gap * gap
        if k < 2:
            along -= gap * (cos(target[3]) if k == 0 else sin(target[3]))
    return along >= cos(sensors.camera_marker_angle) * sqrt(square)


@jit
def through_water(sensors, errors, distance, cycle):
    """Whether the code's contrast, which falls as exp(-c r), is left at `distance`, m.

    The limit is stated in attenuation lengths, 4.8 for the eye. Frames differ by CONTRAST_SPREAD, so that
    more and more of them are lost on the way there.

    Source: Duntley 1963, J. Opt. Soc. Am. 53, 214 (the law); Zaneveld and Pegau 2003, Opt. Express 11, 2997
    (4.8 attenuation lengths).
    """
    if errors.attenuation <= 0.0:
        return True
    spread = CONTRAST_SPREAD * normal(errors.key, cycle, CONTRAST) if errors.noise_scale > 0.0 else 0.0
    return errors.attenuation * distance <= sensors.camera_sight + spread


@jit
def take_frame(sensors, errors, target, plant, cycle, noise, frame):
    """Fill the FRAME that the cameras take in this cycle."""
    chosen, seen = 0, False
    for i in range(sensors.n_cameras):
        view_from(sensors.camera_position[i], sensors.camera_pitch[i], plant.eta, target, frame.target)
        if (
            in_view(sensors, i, frame.target)
            and faces(sensors, i, plant.eta, target)
            and through_water(sensors, errors, frame.target[0], cycle)
        ):
            chosen, seen = i, True
    if sensors.n_cameras > 1:
        place, pitch = sensors.camera_position[chosen], sensors.camera_pitch[chosen]
        view_from(place, pitch, plant.eta, target, frame.target)
    seen = seen and noise[17] >= sensors.camera_dropout
    for k in range(errors.n_outages):
        if errors.outage[k, 0] <= plant.time < errors.outage[k, 1]:
            seen = False
    s = errors.noise_scale
    if s > 0.0 and sensors.camera_outlier > 0.0:
        if uniform(errors.key, cycle, FALSE_SIGHT) < sensors.camera_outlier:
            chosen, seen = 0, True
            mistake(sensors, errors.key, cycle, frame.target)
    frame.detected, frame.camera = 1 if seen else 0, chosen
    frame.target[0] *= 1.0 + s * sensors.camera_range_std * noise[18]
    frame.target[1] += s * sensors.camera_bearing_std * noise[19]
    frame.target[2] += s * sensors.camera_bearing_std * noise[20]


@jit
def mistake(sensors, key, cycle, view):
    """A sight of nothing, anywhere in the wide camera's view: a reflection, a fish."""
    near, far = sensors.camera_range_min[0], sensors.camera_range_max[0]
    across, up = sensors.camera_half_angle[0], sensors.camera_half_vertical[0]
    up = up if up > 0.0 else across
    view[0] = near + (far - near) * uniform(key, cycle, FALSE_RANGE)
    view[1] = across * (2.0 * uniform(key, cycle, FALSE_BEARING) - 1.0)
    view[2] = up * (2.0 * uniform(key, cycle, FALSE_ELEVATION) - 1.0)


@jit
def measure_camera(sensors, errors, target, plant, cycle, noise, m):
    """Take a frame when one is due; hand out the one that the detector has done with."""
    period = max(1, sensors.camera_period)
    if cycle % period == 0:
        frame = errors.frames[(cycle // period) % MAX_FRAMES]
        take_frame(sensors, errors, target, plant, cycle, noise, frame)
    m.fresh = 0
    taken = cycle - sensors.camera_latency
    if taken < 0 or taken % period != 0:
        return
    done = errors.frames[(taken // period) % MAX_FRAMES]
    m.fresh, m.detected, m.camera = 1, done.detected, done.camera
    for k in range(3):
        m.target[k] = done.target[k]
