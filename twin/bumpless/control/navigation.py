"""Dead reckoning from INS, DVL and depth; the target's place from camera fixes.

Small fixed-gain filters: the estimate must be smooth enough for derivative action and must not
jump when a sample is missing. The autopilot works on this estimate alone.
"""

from math import exp, isfinite

from bumpless.jit import inline, jit
from bumpless.physics.frames import body_to_ned, ned_to_body, wrap
from bumpless.physics.sensors import target_position

_T_VELOCITY = 0.25  # s, smoothing of DVL velocity
_T_DEPTH = 0.5  # s, depth sensor against integrated heave
_T_RATE = 0.08  # s, smoothing of gyro rates
_T_ATTITUDE = 0.15  # s, INS attitude against integrated rates
_T_CURRENT = 8.0  # s, current estimate
_T_TARGET = 0.6  # s of camera frames, target estimate


@inline
def follow(value, sample, gain):
    """value moved towards a sample by the share gain; a sample that is no number moves nothing."""
    return value + gain * (sample - value) if isfinite(sample) else value


@jit
def navigate(settings, sensors, m, a, work):
    """Update the autopilot record `a` from the measurement `m`. work: scratch, at least 6 floats."""
    dt = settings.dt
    ned = work[0:3]
    fresh_start = a.cycle == 0
    k_rate = 1.0 if fresh_start else 1.0 - exp(-dt / _T_RATE)
    k_att = 1.0 if fresh_start else 1.0 - exp(-dt / _T_ATTITUDE)
    for k in range(3):
        a.nu[3 + k] = follow(a.nu[3 + k], m.rates[k], k_rate)
        predicted = a.eta[3 + k] + dt * a.nu[3 + k]
        seen = m.attitude[k] if isfinite(m.attitude[k]) else predicted
        a.eta[3 + k] = wrap(predicted + k_att * wrap(seen - predicted))

    if m.velocity_valid == 1:
        elapsed = dt * max(1, sensors.dvl_period)
        k_vel = 1.0 if fresh_start else 1.0 - exp(-elapsed / _T_VELOCITY)
        k_cur = max(1.0 - exp(-elapsed / _T_CURRENT), elapsed / (elapsed + a.time))  # a mean at first
        for k in range(3):
            a.nu[k] = follow(a.nu[k], m.velocity[k], k_vel)
            ned[k] = m.velocity[k] - m.water_velocity[k]
        body_to_ned(a.eta[3], a.eta[4], a.eta[5], ned, ned)
        for k in range(3):
            a.current[k] = follow(a.current[k], ned[k], k_cur)

    body_to_ned(a.eta[3], a.eta[4], a.eta[5], a.nu, ned)
    for k in range(3):
        a.eta[k] += dt * ned[k]
    a.depth_rate = ned[2]
    k_depth = 1.0 if fresh_start else 1.0 - exp(-dt / _T_DEPTH)
    a.eta[2] = follow(a.eta[2], m.depth, k_depth)

    ned_to_body(a.eta[3], a.eta[4], a.eta[5], a.current, ned)
    for k in range(3):
        a.nu_r[k] = a.nu[k] - ned[k]
        a.nu_r[3 + k] = a.nu[3 + k]

    if m.fresh == 1 and m.detected == 1:
        target_position(sensors, a.eta, m.target, ned)
        gain = 1.0 - exp(-dt * max(1, sensors.camera_period) / _T_TARGET)
        gain = max(gain, 1.0 / (1.0 + a.fixes))  # the first fixes replace the planned place
        for k in range(3):
            a.target[k] = follow(a.target[k], ned[k], gain)
        a.fixes += 1
