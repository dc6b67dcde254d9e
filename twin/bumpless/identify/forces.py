"""What the file's model says of the forces in a flight, and of how they change with each scale."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bumpless.control.navigation import T_RATE, T_VELOCITY
from bumpless.identify.flight import Flight
from bumpless.identify.scales import Scale
from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.actuators import actuator_wrench
from bumpless.physics.dynamics import coriolis_force, damping_force, restoring_force
from bumpless.physics.frames import ned_to_body
from bumpless.physics.lag import lag

Array = NDArray[np.float64]
FLOW_MPS = 0.05  # by which the flow along a fin may be other than estimated; its force goes with the square


@dataclass(frozen=True)
class Forces:
    """One row per control cycle; N and N m, as late as the estimate of velocity over ground is."""

    momentum: Array  # (n, 6) M_RB nu + M_A nu_r
    total: Array  # (n, 6) of all forces but inertia, every scale 1
    by_scale: Array  # (k, n, 6) what a scale of 2 would add
    size: Array  # (n, 6) magnitudes at work, those of a fin in slow flow taken larger: its flow is known less


@jit
def _along(model, eta, nu, current, u, nu_r, force, drag, wrench, size):
    """Fill nu_r, force, drag, wrench and size, (n, 6) each, along a flight: velocity through water, Coriolis
    and restoring force, damping, actuators, and the magnitudes of the last two."""
    for t in range(len(eta)):
        ned_to_body(eta[t, 3], eta[t, 4], eta[t, 5], current[t], nu_r[t])
        for k in range(3):
            nu_r[t, k] = nu[t, k] - nu_r[t, k]
            nu_r[t, 3 + k] = nu[t, 3 + k]
        coriolis_force(model.M_RB, nu[t], force[t])
        coriolis_force(model.M_A, nu_r[t], force[t])
        restoring_force(model, eta[t, 3], eta[t, 4], force[t])
        damping_force(model, nu_r[t], drag[t])
        for k in range(6):
            size[t, k] = abs(drag[t, k])
        for i in range(model.n_u):
            one = floats(6)
            for k in range(6):
                one[k] = 0.0
            actuator_wrench(model, i, u[t], nu_r[t], one)
            doubt = 1.0 + 2.0 * FLOW_MPS / (abs(nu_r[t, 0]) + 0.01) if model.steers[i] == 1 else 1.0
            for k in range(6):
                wrench[t, k] += one[k]
                size[t, k] += doubt * abs(one[k])


@jit
def _delay(gain, x):
    """Lag each column of x (n, k) in place."""
    for t in range(1, x.shape[0]):
        for k in range(x.shape[1]):
            x[t, k] = x[t - 1, k] + gain * (x[t, k] - x[t - 1, k])


def _together(flight: Flight, period_s: float) -> tuple[Array, Array, Array]:
    """Pose, velocity and actuators as late as velocity over ground, which the vehicle smooths the most."""
    eta, nu, u = flight.eta.copy(), flight.nu.copy(), flight.u.copy()
    eta[:, 3:] = np.unwrap(eta[:, 3:], axis=0)
    angles, rates = np.ascontiguousarray(eta[:, 3:]), np.ascontiguousarray(nu[:, 3:])
    _delay(lag(period_s, T_VELOCITY), angles)
    _delay(lag(period_s, T_VELOCITY), u)
    _delay(lag(period_s, T_VELOCITY - T_RATE), rates)
    eta[:, 3:], nu[:, 3:] = angles, rates
    return eta, nu, u


def forces_of(flight: Flight, model: np.record, scales: Sequence[Scale], period_s: float) -> Forces:
    """Evaluate the MODEL record along a flight without gaps; every force is linear in its scale."""
    eta, nu, u = _together(flight, period_s)

    def along(one: np.record) -> Array:
        out = np.zeros((5, len(flight), 6))
        record = np.array([one]).view(np.recarray)[0]
        _along(record, eta, nu, flight.current, u, *out)
        return out

    nu_r, force, drag, wrench, size = along(model)
    by_scale = []
    for scale in scales:
        _, _, other_drag, other_wrench, _ = along(scale.applied(model, 2.0))
        by_scale.append(other_drag - drag + other_wrench - wrench)
    return Forces(
        nu @ model["M_RB"].T + nu_r @ model["M_A"].T,
        force + drag + wrench,
        np.array(by_scale),
        size,
    )
