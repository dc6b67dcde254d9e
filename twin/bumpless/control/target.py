"""The target's place: from the camera while it sees it, from USBL before and in between.

The camera's filter has a fixed gain. USBL's error across grows with range, so its fixes are weighed by their
variance against the estimate's, which the camera makes small: near the dock USBL changes nothing, and a
target that is lost from view is followed again as dead reckoning gets old.
"""

from math import isfinite, sqrt

from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.camera import place_seen
from bumpless.physics.frames import body_to_ned
from bumpless.physics.lag import follow, lag

_T_TARGET = 0.6  # s of camera frames
_GROWTH = 1e-4  # m^2/s, of the estimate's variance as dead reckoning goes on: 0.1 m after 100 s
_DEVIATIONS = 3.0  # of the sensor, that a fix may be off beyond the gate
_AGREEING = 3  # fixes off in a row that are believed when they agree
CAMERA, USBL = 0, 1


@jit
def find_target(dt, settings, sensors, m, state, out):
    """Take in what camera and USBL say of the target; fill out.sighted.

    settings: NAVIGATION_SETTINGS; m: MEASUREMENT; state: NAVIGATION_STATE; out: NAVIGATION_OUTPUT.
    """
    out.sighted = 0
    if sensors.usbl_period > 0:
        if state.target_variance > 0.0:
            state.target_variance += _GROWTH * dt
        if m.usbl_fresh == 1:
            take_reply(settings, sensors, m.usbl, state)
    if m.fresh == 1 and m.detected == 1:
        out.sighted = take_sight(dt, settings, sensors, m, state)


@jit
def take_sight(dt, settings, sensors, m, state):
    """Take in one sight by camera; 1 when it is believed. It is laid out from where the frame was taken."""
    ned, then, i = floats(3), floats(6), m.camera
    pose_before(sensors.camera_latency * dt, state, then)
    place_seen(sensors.camera_position[i], sensors.camera_pitch[i], then, m.target, ned)
    variance = m.target[0] ** 2 * (sensors.camera_range_std**2 + sensors.camera_bearing_std**2)
    if settings.fix_gate > 0.0 and not believed(settings.fix_gate, variance, ned, CAMERA, state):
        return 0
    gain = lag(dt * max(1, sensors.camera_period), _T_TARGET)
    gain = max(gain, 1.0 / (1.0 + state.fixes))  # the first fixes replace the planned place
    for k in range(3):
        state.target[k] = follow(state.target[k], ned[k], gain)
    state.fixes += 1
    if sensors.usbl_period > 0 and isfinite(variance):
        state.target_variance = max(variance * gain / (2.0 - gain), _GROWTH)  # what such a filter leaves
    return 1


@jit
def take_reply(settings, sensors, view, state):
    """Take in one reply by USBL: view (3,) = range m, bearing and elevation rad in body axes."""
    ned = floats(3)
    place_seen(sensors.usbl_position, 0.0, state.eta, view, ned)
    variance = sensors.usbl_range_std**2 + (view[0] * sensors.usbl_angle_std) ** 2
    if not isfinite(ned[0] + ned[1] + ned[2]):
        return
    known = state.target_variance
    spread = variance + known
    if settings.fix_gate > 0.0 and not believed(settings.fix_gate, spread, ned, USBL, state):
        return
    known = state.target_variance  # belief may have begun anew
    gain = known / (known + variance) if known > 0.0 and variance > 0.0 else 1.0
    for k in range(3):
        state.target[k] += gain * (ned[k] - state.target[k])
    state.target_variance = gain * variance if variance > 0.0 else _GROWTH


@jit
def pose_before(age, state, out):
    """out (6,) = where the vehicle was `age` s ago, by its present velocity: what it turned and went."""
    for k in range(6):
        out[k] = state.eta[k]
    if age <= 0.0:
        return
    ned = floats(3)
    body_to_ned(state.eta[3], state.eta[4], state.eta[5], state.nu, ned)
    for k in range(3):
        out[k] -= age * ned[k]
        out[3 + k] -= age * state.nu[3 + k]


@jit
def believed(gate, variance, ned, by, state):
    """Whether a fix is near enough to the estimate, or the third of three in a row that agree.

    gate: m; variance: m^2, of fix and estimate; by: CAMERA or USBL. When three agree against the estimate,
    it begins anew.
    """
    reach = gate + _DEVIATIONS * sqrt(variance)
    if near(ned, state.target, reach):
        state.doubts[by] = 0
        return True
    if not isfinite(ned[0] + ned[1] + ned[2]):
        return False
    agrees = state.doubts[by] > 0 and near(ned, state.doubt[by], reach)
    state.doubts[by] = state.doubts[by] + 1 if agrees else 1
    for k in range(3):
        state.doubt[by, k] = ned[k]
    if state.doubts[by] < _AGREEING:
        return False
    state.doubts[by] = 0
    state.fixes, state.target_variance = 0, 0.0
    return True


@jit
def near(a, b, reach):
    """Whether two places (3,) are within reach of one another, m; not where one is no number."""
    square = 0.0
    for k in range(3):
        square += (a[k] - b[k]) ** 2
    return square <= reach * reach
