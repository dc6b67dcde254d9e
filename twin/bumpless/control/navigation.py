"""Dead reckoning from INS, DVL and depth.

Small fixed-gain filters: the estimate must be smooth enough for derivative action and must not
jump when a sample is missing. The autopilot works on this estimate alone.
"""

from math import isfinite

import numpy as np

from bumpless.config.parameters.records import section_dtype
from bumpless.control.bridge import SILENCE, add_current, coast
from bumpless.control.target import find_target
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import body_to_ned, ned_to_body, wrap
from bumpless.physics.lag import follow, lag

f8, i8 = np.float64, np.int64

T_VELOCITY = 0.25  # s, smoothing of DVL velocity
_T_DEPTH = 0.5  # s, depth sensor against integrated heave
T_RATE = 0.08  # s, smoothing of gyro rates
_T_ATTITUDE = 0.15  # s, INS attitude against integrated rates
_T_CURRENT = 8.0  # s, current estimate

NAVIGATION_SETTINGS = section_dtype("navigation")

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
        ("silent", i8),  # cycles since the last sample of the DVL
        ("fixes", i8),  # of the target by camera so far
        ("target_variance", f8),  # m^2, of its estimate, where USBL is fitted; 0: none
        ("doubt", f8, (2, 3)),  # last fix that wasn't believed, NED, m; by camera, by USBL
        ("doubts", i8, 2),  # how many in a row agreed with it
        ("smooth_nu_r", f8, 6),  # nu_r after the lag of `smooth_flow`
    ],
    align=True,
)

NAVIGATION_OUTPUT = np.dtype(
    [
        ("nu_r", f8, 6),  # velocity through water: nu minus the current
        ("depth_rate", f8),  # m/s
        ("sighted", i8),  # 1 in a cycle with a camera frame that shows the target where it may be
        ("nu_flow", f8, 6),  # what the allocator may see of the velocity through water
    ],
    align=True,
)


@jit
def navigate(dt, settings, clock, sensors, model, effectiveness, m, state, out):
    """Update the NAVIGATION_STATE `state` from the measurement `m`; fill the NAVIGATION_OUTPUT but for
    nu_flow. settings: NAVIGATION_SETTINGS; effectiveness (n,): of the actuators, as believed."""
    ned = floats(3)
    fresh_start = clock.cycle == 0
    k_rate = 1.0 if fresh_start else lag(dt, T_RATE)
    k_att = 1.0 if fresh_start else lag(dt, _T_ATTITUDE)
    eta, nu = state.eta, state.nu
    for k in range(3):
        nu[3 + k] = follow(nu[3 + k], m.rates[k], k_rate)
        predicted = eta[3 + k] + dt * nu[3 + k]
        seen = m.attitude[k] if isfinite(m.attitude[k]) else predicted
        eta[3 + k] = wrap(predicted + k_att * wrap(seen - predicted))

    if m.velocity_valid == 1:
        elapsed = dt * max(1, sensors.dvl_period)
        k_vel = 1.0 if fresh_start else lag(elapsed, T_VELOCITY)
        k_cur = max(lag(elapsed, _T_CURRENT), elapsed / (elapsed + clock.time))  # a mean at first
        for k in range(3):
            nu[k] = follow(nu[k], m.velocity[k], k_vel)
            ned[k] = m.velocity[k] - m.water_velocity[k]
        body_to_ned(eta[3], eta[4], eta[5], ned, ned)
        for k in range(3):
            state.current[k] = follow(state.current[k], ned[k], k_cur)
    elif m.water_valid == 1:
        k_vel = 1.0 if fresh_start else lag(dt * max(1, sensors.dvl_period), T_VELOCITY)
        add_current(k_vel, m, state)
    state.silent = 0 if m.velocity_valid == 1 or m.water_valid == 1 else state.silent + 1
    if state.silent > SILENCE * sensors.dvl_period:
        coast(dt, model, m, effectiveness, state)

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

    find_target(dt, settings, sensors, m, state, out)
