"""Momentum as a vehicle with other scales would have it, against how it moved: a Kalman filter.

  p' = f + W theta + d,   theta constant, d slowly drifting,   y = p + noise
with f the forces of the file's model, W = df/dtheta, theta the scales less one, and d the wrench that neither
explains (trim, buoyancy, an error of the current). It runs in steps of STEP_S, longer than the estimate's own
lags, so that the noise of one step is not that of the next. Errors of the model are taken in proportion to
the forces at work. How loud everything is, the flight says itself: the filter runs PASSES times, and its
noises are scaled by what the innovations were.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bumpless.identify.forces import Forces

Array = NDArray[np.float64]
STEP_S = 0.5
PASSES = 3
MODEL_NOISE = 0.03  # white, in shares of the forces at work, sqrt(s)
DRIFT = 0.003  # of the unexplained wrench, in shares of the forces at work, 1/sqrt(s)
FLOOR_MPS2, FLOOR_RADPS2, FLOOR_TILT_RAD = 0.005, 0.01, 0.005  # least error, in accelerations and attitude
FIRST_STD = 10.0  # of the unexplained wrench at the start, in floors
SIZE_S = 5.0  # over which the forces at work are averaged
OUTLIER = 4.0  # standard deviations at which an innovation is cut


@dataclass(frozen=True)
class Steps:
    """A stretch of a flight without gaps, cut into m steps."""

    momentum: Array  # (m + 1, 6) at the ends of the steps
    impulse: Array  # (m, 6) of the model's forces
    by_scale: Array  # (m, 6, k) what a scale of 2 would add to it
    size: Array  # (m, 6) mean magnitude of the forces at work


def steps_of(forces: Forces, floor: Array, period_s: float) -> Steps:
    """Cut into steps; a rest shorter than one is left out."""
    h = max(1, round(STEP_S / period_s))
    m = max(0, (len(forces.total) - 1) // h)

    def summed(x: Array) -> Array:
        return x[: m * h].reshape(m, h, 6).sum(axis=1) * period_s

    size = summed(forces.size) / (h * period_s) + floor
    share = 1.0 - np.exp(-h * period_s / SIZE_S)
    for k in range(1, m):
        size[k] = size[k - 1] + share * (size[k] - size[k - 1])
    by_scale = np.array([summed(x) for x in forces.by_scale]).transpose(1, 2, 0)
    return Steps(forces.momentum[: m * h + 1 : h], summed(forces.total), by_scale, size)


@dataclass(frozen=True)
class Gaussian:
    """Mean and covariance of the scales less one."""

    mean: Array
    covariance: Array


def filtered(
    stretches: Sequence[Steps], prior: Gaussian, noise: Array, floor: Array, step_s: float
) -> Gaussian:
    """What the stretches of one flight add to the prior.

    noise (6,): variance of the measured momentum by the sensors' figures; floor (6,): least error of the
    model, N and N m.
    """
    loud, found = np.ones(6), prior
    for _ in range(PASSES):
        found, squares, count = prior, np.zeros(6), 0
        for steps in stretches:
            found, more = _stretch(steps, found, noise * loud, loud, floor, step_s)
            squares, count = squares + more, count + len(steps.impulse)
        if count:
            loud = loud * squares / count
    return found


def _stretch(
    steps: Steps, prior: Gaussian, noise: Array, loud: Array, floor: Array, step_s: float
) -> tuple[Gaussian, Array]:
    """(scales after one stretch, sum of its squared innovations over their variances)."""
    k = len(prior.mean)
    p, d, scales = slice(0, 6), slice(6, 12), slice(12, 12 + k)
    x, P = np.zeros(12 + k), np.zeros((12 + k, 12 + k))
    x[p], x[scales] = steps.momentum[0], prior.mean
    P[p, p], P[d, d] = np.diag(noise), np.diag((FIRST_STD * floor) ** 2)
    P[scales, scales] = prior.covariance
    squares, move = np.zeros(6), np.eye(12 + k)
    move[p, d] = step_s * np.eye(6)
    for t in range(len(steps.impulse)):
        move[p, scales] = steps.by_scale[t]
        x = move @ x
        x[p] += steps.impulse[t]
        P = move @ P @ move.T
        errors = loud * steps.size[t] ** 2 * step_s
        P[range(6), range(6)] += MODEL_NOISE**2 * errors
        P[range(6, 12), range(6, 12)] += DRIFT**2 * errors
        S = P[p, p] + np.diag(noise)
        limit = OUTLIER * np.sqrt(np.diag(S))
        innovation = np.clip(steps.momentum[t + 1] - x[p], -limit, limit)
        squares += innovation**2 / np.diag(S)
        K = np.linalg.solve(S, P[p]).T
        x = x + K @ innovation
        P = P - K @ P[p]
        P = 0.5 * (P + P.T)
    return Gaussian(x[scales], P[scales, scales]), squares
