"""Momentum as the nominal model predicts it, and what that leaves unexplained.

M_RB nu + M_A nu_r changes by all forces there are, so no velocity need be differentiated:
  p' = f(nu, nu_r, eta, u) + d + c D(nu_r) nu_r,  y = p + noise
with f the nominal forces at the measured actuator states and the effectiveness found so far, d a slowly
drifting wrench (trim, buoyancy, current) and c the relative error of the damping. One Kalman filter with
the state [p d c] for each component; they meet only in the forces, which are functions of measurements.
Model errors are taken in proportion to the forces at work, so manoeuvres make the filter cautious, and the
noise of the measurement is learnt from the innovations, for it may be louder than the sensors' figures.
"""

from math import isfinite

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
from bumpless.physics.lag import lag


@jit
def model_forces(model, m, navigation, loss, w):
    """Fill w.nu_r, w.force, w.drag (6,), w.wrench (n, 6) and w.momentum (6,) of this cycle, body axes.

    loss (8,): of each actuator, as found so far. Returns 1 when all are finite, so that a sample that is no
    number never enters the filter.
    """
    eta, nu = navigation.eta, navigation.nu
    ned_to_body(eta[3], eta[4], eta[5], navigation.current, w.nu_r)
    for k in range(3):
        water = w.nu_r[k]
        w.nu_r[k] = nu[k] - water
        w.nu_r[3 + k] = nu[3 + k]
    for k in range(6):
        w.drag[k] = w.force[k] = w.momentum[k] = 0.0
        for j in range(3):
            through = m.velocity[j] - nu[j] + w.nu_r[j]
            w.momentum[k] += model.M_RB[k, j] * m.velocity[j] + model.M_A[k, j] * through
            w.momentum[k] += (model.M_RB[k, 3 + j] + model.M_A[k, 3 + j]) * m.rates[j]
    damping_force(model, w.nu_r, w.drag)
    coriolis_force(model.M_RB, nu, w.force)
    coriolis_force(model.M_A, w.nu_r, w.force)
    restoring_force(model, eta[3], eta[4], w.force)
    total = 0.0
    for i in range(model.n_u):
        for k in range(6):
            w.wrench[i, k] = 0.0
        actuator_wrench(model, i, m.u_feedback, w.nu_r, w.wrench[i])
        for k in range(6):
            w.force[k] += (1.0 - loss[i]) * w.wrench[i, k]
    for k in range(6):
        w.force[k] += w.drag[k]
        total += w.force[k] + w.momentum[k]
    return 1 if isfinite(total) else 0


@jit
def begin_baseline(sensors, model, momentum, e):
    """Start the six filters at the measured momentum (6,) of this cycle, knowing nothing of trim and drag."""
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
            e.x[k, i] = 0.0
            for j in range(3):
                e.P[k, i, j] = 0.0
        e.x[k, 0] = momentum[k]
        e.P[k, 0, 0] = e.R[k]
        e.P[k, 1, 1] = (FIRST_STD * e.floor[k]) ** 2
        e.P[k, 2, 2] = DRAG_STD**2


@jit
def predict_baseline(dt, n, e, w):
    """Advance the six filters over one cycle by the mean of the forces at its ends; fills w.drag_mean."""
    for k in range(6):
        f = 0.5 * (w.force[k] + e.force_before[k])
        g = 0.5 * (w.drag[k] + e.drag_before[k])
        size = abs(g) + e.floor[k]
        for i in range(n):
            size += abs(w.wrench[i, k])
        e.size[k] += lag(dt, FORCE_MEAN_S) * (size - e.size[k])
        w.drag_mean[k] = g
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
def correct_baseline(elapsed, e, w):
    """Take in w.momentum as measured; leaves the innovation, its variance and the gains in w.

    elapsed: s since the last sample, for the memory of the noise.
    """
    e.samples += 1
    gain = max(lag(elapsed, MEMORY_S), 1.0 / (20.0 + e.samples))
    for k in range(6):
        x, P = e.x[k], e.P[k]
        variance = P[0, 0] + e.R[k]
        innovation = cut(w.momentum[k] - x[0], OUTLIER * variance**0.5)
        w.innovation[k], w.variance[k] = innovation, variance
        noise = e.R[k] + gain * (innovation * innovation - variance)
        e.R[k] = min(max(noise, QUIETEST * e.R_0[k]), LOUDEST * e.R_0[k])
        for j in range(3):
            w.K[k, j] = P[j, 0] / variance
            x[j] += w.K[k, j] * innovation
        p0, p1, p2 = P[0, 0], P[0, 1], P[0, 2]
        for j in range(3):
            P[j, 0] -= w.K[k, j] * p0
            P[j, 1] -= w.K[k, j] * p1
            P[j, 2] -= w.K[k, j] * p2
