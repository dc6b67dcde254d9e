"""Dead reckoning from INS, DVL and depth; the target's place from camera fixes.

Small fixed-gain filters: the estimate must be smooth enough for derivative action and must not
jump when a sample is missing. The autopilot works on this estimate alone.
"""

from math import isfinite

import numpy as np

from bumpless.jit import inline, jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import body_to_ned, ned_to_body, wrap
from bumpless.physics.lag import lag
from bumpless.physics.sensors import target_position

f8, i8 = np.float64, np.int64

_T_VELOCITY = 0.25  # s, smoothing of DVL velocity
_T_DEPTH = 0.5  # s, depth sensor against integrated heave
_T_RATE = 0.08  # s, smoothing of gyro rates
_T_ATTITUDE = 0.15  # s, INS attitude against integrated rates
_T_CURRENT = 8.0  # s, current estimate
_T_TARGET = 0.6  # s of camera frames, target estimate

CLOCK = np.dtype(
    [
        ("cycle", i8),  # k
        ("time", f8),  # s since the mission began
    ],
    align=True,
)

NAVIGATION_STATE = np.dtype(
    [
        ("eta", f8, 6),
        ("nu", f8, 6),
        ("current", f8, 3),  # NED, m/s
        ("target", f8, 3),  # NED, m
        ("fixes", i8),  # of the target so far
        ("smooth_nu_r", f8, 6),  # nu_r after the lag of `smooth_flow`
    ],
    align=True,
)

NAVIGATION_OUTPUT = np.dtype(
    [
        ("nu_r", f8, 6),  # velocity through water: nu minus the current
        ("depth_rate", f8),  # m/s
        ("nu_flow", f8, 6),  # what the allocator may see of the velocity through water
    ],
    align=True,
)


@inline
def follow(value, sample, gain):
    """value moved towards a sample by the share gain; a sample that is no number moves nothing."""
    return value + gain * (sample - value) if isfinite(sample) else value


@jit
def navigate(dt, clock, sensors, m, state, out):
    """Update the NAVIGATION_STATE `state` from the measurement `m`; fill out.nu_r and out.depth_rate."""
    ned = floats(3)
    fresh_start = clock.cycle == 0
    k_rate = 1.0 if fresh_start else lag(dt, _T_RATE)
    k_att = 1.0 if fresh_start else lag(dt, _T_ATTITUDE)
    eta, nu = state.eta, state.nu
    for k in range(3):
        nu[3 + k] = follow(nu[3 + k], m.rates[k], k_rate)
        predicted = eta[3 + k] + dt * nu[3 + k]
        seen = m.attitude[k] if isfinite(m.attitude[k]) else predicted
        eta[3 + k] = wrap(predicted + k_att * wrap(seen - predicted))

    if m.velocity_valid == 1:
        elapsed = dt * max(1, sensors.dvl_period)
        k_vel = 1.0 if fresh_start else lag(elapsed, _T_VELOCITY)
        k_cur = max(lag(elapsed, _T_CURRENT), elapsed / (elapsed + clock.time))  # a mean at first
        for k in range(3):
            nu[k] = follow(nu[k], m.velocity[k], k_vel)
            ned[k] = m.velocity[k] - m.water_velocity[k]
        body_to_ned(eta[3], eta[4], eta[5], ned, ned)
        for k in range(3):
            state.current[k] = follow(state.current[k], ned[k], k_cur)

    body_to_ned(eta[3], eta[4], eta[5], nu, ned)
    for k in range(3):
        eta[k] += dt * ned[k]
    out.depth_rate = ned[2]
    k_depth = 1.0 if fresh_start else lag(dt, _T_DEPTH)
    eta[2] = follow(eta[2], m.depth, k_depth)

    ned_to_body(eta[3], eta[4], eta[5], state.current, ned)
    for k in range(3):
        out.nu_r[k] = nu[k] - ned[k]
        out.nu_r[3 + k] = nu[3 + k]

    if m.fresh == 1 and m.detected == 1:
        find_target(dt, sensors, m.target, state)


@jit
def find_target(dt, sensors, view, state):
    """Take in one sight of the target: view (3,) = range m, bearing and elevation rad in camera axes."""
    ned = floats(3)
    target_position(sensors, state.eta, view, ned)
    gain = lag(dt * max(1, sensors.camera_period), _T_TARGET)
    gain = max(gain, 1.0 / (1.0 + state.fixes))  # the first fixes replace the planned place
    for k in range(3):
        state.target[k] = follow(state.target[k], ned[k], gain)
    state.fixes += 1
