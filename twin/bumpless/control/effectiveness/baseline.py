"""Momentum as the nominal model predicts it, and what that leaves unexplained.

M_RB nu + M_A nu_r changes by all forces there are, so no velocity need be differentiated:
  p' = f(nu, nu_r, eta, u) + d + c D(nu_r) nu_r,  y = p + noise
with f the nominal forces at the measured actuator states and the effectiveness found so far, d a slowly
drifting wrench (trim, buoyancy, current) and c the relative error of the damping. One Kalman filter with
the state [p d c] for each component; they meet only in the forces, which are functions of measurements.
Model errors are taken in proportion to the forces at work, so manoeuvres make the filter cautious, and the
noise of the measurement is learnt from the innovations, for it may be louder than the sensors' figures.
"""

from math import exp, isfinite

from bumpless.control.effectiveness.record import (
    DRAG_STD,
    DRIFT,
    FIRST_STD,
    FLOOR_MPS2,
    FLOOR_RADPS2,
    FLOOR_TILT_RAD,
    FORCE_MEAN_S,
    LOUDEST,
    MEMORY_S,
    MODEL_NOISE,
    OUTLIER,
    QUIETEST,
)
from bumpless.jit import inline, jit
from bumpless.physics.actuators import actuator_wrench
from bumpless.physics.dynamics import coriolis_force, damping_force, restoring_force
from bumpless.physics.frames import ned_to_body


@jit
def model_forces(model, m, a, e):
    """Fill e.nu_r, e.force, e.drag (6,), e.wrench (n, 6) and e.momentum (6,) of this cycle, body axes.

    Returns 1 when all are finite, so that a sample that is no number never enters the filter.
    """
    ned_to_body(a.eta[3], a.eta[4], a.eta[5], a.current, e.nu_r)
    for k in range(3):
        water = e.nu_r[k]
        e.nu_r[k] = a.nu[k] - water
        e.nu_r[3 + k] = a.nu[3 + k]
    for k in range(6):
        e.drag[k] = e.force[k] = e.momentum[k] = 0.0
        for j in range(3):
            through = m.velocity[j] - a.nu[j] + e.nu_r[j]
            e.momentum[k] += model.M_RB[k, j] * m.velocity[j] + model.M_A[k, j] * through
            e.momentum[k] += (model.M_RB[k, 3 + j] + model.M_A[k, 3 + j]) * m.rates[j]
    damping_force(model, e.nu_r, e.drag)
    coriolis_force(model.M_RB, a.nu, e.force)
    coriolis_force(model.M_A, e.nu_r, e.force)
    restoring_force(model, a.eta[3], a.eta[4], e.force)
    total = 0.0
    for i in range(model.n_u):
        for k in range(6):
            e.wrench[i, k] = 0.0
        actuator_wrench(model, i, m.u_feedback, e.nu_r, e.wrench[i])
        for k in range(6):
            e.force[k] += (1.0 - e.loss[i]) * e.wrench[i, k]
    for k in range(6):
        e.force[k] += e.drag[k]
        total += e.force[k] + e.momentum[k]
    return 1 if isfinite(total) else 0


@jit
def begin_baseline(sensors, model, e):
    """Start the six filters at the measured momentum of this cycle, knowing nothing of trim and drag."""
    e.started, e.time, e.samples = 1, 0.0, 0
    tilt = FLOOR_TILT_RAD * model.weight * abs(model.r_g[2] - model.r_b[2])
    for k in range(6):
        r = 0.0
        for j in range(3):
            r += ((model.M_RB[k, j] + model.M_A[k, j]) * sensors.dvl_std) ** 2
            r += ((model.M_RB[k, 3 + j] + model.M_A[k, 3 + j]) * sensors.rate_std) ** 2
        inertia = model.M_RB[k, k] + model.M_A[k, k]
        e.floor[k] = inertia * (FLOOR_MPS2 if k < 3 else FLOOR_RADPS2) + (tilt if 3 <= k < 5 else 0.0)
        e.size[k] = e.floor[k]
        e.R_0[k] = e.R[k] = r + 1e-12
        for i in range(3):
            e.x[k, i] = e.K[k, i] = 0.0
            for j in range(3):
                e.P[k, i, j] = 0.0
        e.x[k, 0] = e.momentum[k]
        e.P[k, 0, 0] = e.R[k]
        e.P[k, 1, 1] = (FIRST_STD * e.floor[k]) ** 2
        e.P[k, 2, 2] = DRAG_STD**2


@jit
def predict_baseline(dt, n, e):
    """Advance the six filters over one cycle by the mean of the forces at its ends."""
    for k in range(6):
        f = 0.5 * (e.force[k] + e.force_before[k])
        g = 0.5 * (e.drag[k] + e.drag_before[k])
        size = abs(g) + e.floor[k]
        for i in range(n):
            size += abs(e.wrench[i, k])
        e.size[k] += (1.0 - exp(-dt / FORCE_MEAN_S)) * (size - e.size[k])
        e.drag_mean[k] = g
        x, P = e.x[k], e.P[k]
        x[0] += dt * (f + x[1] + g * x[2])
        for j in range(3):
            P[0, j] += dt * (P[1, j] + g * P[2, j])
        for j in range(3):
            P[j, 0] += dt * (P[j, 1] + g * P[j, 2])
        P[0, 0] += (MODEL_NOISE * e.size[k]) ** 2 * dt
        P[1, 1] += (DRIFT * e.size[k]) ** 2 * dt


@inline
def cut(value, limit):
    """value within +-limit."""
    return min(max(value, -limit), limit)


@jit
def correct_baseline(elapsed, e):
    """Take in the measured momentum; leaves the innovation, its variance and the gains in e.

    elapsed: s since the last sample, for the memory of the noise.
    """
    e.samples += 1
    gain = max(1.0 - exp(-elapsed / MEMORY_S), 1.0 / (20.0 + e.samples))
    for k in range(6):
        x, P = e.x[k], e.P[k]
        variance = P[0, 0] + e.R[k]
        innovation = cut(e.momentum[k] - x[0], OUTLIER * variance**0.5)
        e.innovation[k], e.variance[k] = innovation, variance
        noise = e.R[k] + gain * (innovation * innovation - variance)
        e.R[k] = min(max(noise, QUIETEST * e.R_0[k]), LOUDEST * e.R_0[k])
        for j in range(3):
            e.K[k, j] = P[j, 0] / variance
            x[j] += e.K[k, j] * innovation
        p0, p1, p2 = P[0, 0], P[0, 1], P[0, 2]
        for j in range(3):
            P[j, 0] -= e.K[k, j] * p0
            P[j, 1] -= e.K[k, j] * p1
            P[j, 2] -= e.K[k, j] * p2
