"""From flights to scales, each with its interval, and to what they do not tell."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from bumpless.config.vehicle import Vehicle
from bumpless.control.navigation import T_VELOCITY
from bumpless.identify.flight import Flight
from bumpless.identify.forces import forces_of
from bumpless.identify.momentum import (
    FLOOR_MPS2,
    FLOOR_RADPS2,
    FLOOR_TILT_RAD,
    STEP_S,
    Array,
    Gaussian,
    Steps,
    filtered,
    steps_of,
)
from bumpless.identify.scales import DRAG_ALONG, THRUST, Scale, scales_of
from bumpless.physics.model import build_model

DOUBT = 2.0  # by which the filter's own deviation is too small: its errors are not as white as it takes them
LEAST_STD = 0.02  # however long was flown: what the model leaves out is in the scale as well
SIGMAS = 1.96  # half-width of a 95 % interval
KNOWN_SHARE = 0.5  # of the deviation beforehand: above it a flight has told nothing of a scale
KNOWN_STD = 0.08  # above it, what it has told is too little to fly with
APART = 2.5  # deviations by which two halves of what was flown may differ


@dataclass(frozen=True)
class Estimate:
    """One scale: 1 as in the file; 0.88 is 12 % less."""

    scale: Scale
    value: float
    std: float
    apart: float  # deviations between the two halves of what was flown; 0 where a half tells nothing

    @property
    def interval(self) -> tuple[float, float]:
        """95 % interval."""
        return self.value - SIGMAS * self.std, self.value + SIGMAS * self.std

    @property
    def told(self) -> bool:
        """Whether the flights say enough of it to write it down."""
        return self.std <= min(KNOWN_SHARE * self.scale.prior_std, KNOWN_STD)

    @property
    def steady(self) -> bool:
        """Whether it was the same all the time. A fault, a load or a fouled screw isn't."""
        return self.apart <= APART


@dataclass(frozen=True)
class Found:
    """What flights of one vehicle told."""

    estimates: tuple[Estimate, ...]
    flown_s: float  # of flight that could be used
    left_out_s: float  # disturbed, or with a number that is none

    def sound(self, one: Estimate) -> bool:
        """Whether it, and what it is weighed against, was the same all the time: thrust against drag."""
        against = DRAG_ALONG if one.scale.what == THRUST else one.scale.what
        return one.steady and all(e.steady for e in self.estimates if e.scale.what == against)

    @property
    def factors(self) -> Mapping[Scale, float]:
        """What may be written down: told, and sound."""
        return {one.scale: one.value for one in self.estimates if one.told and self.sound(one)}


def identify(flights: Sequence[Flight], vehicle: Vehicle) -> Found:
    """The scales of `vehicle`, whose file the flights' autopilot flew with, from one flight or several.

    Raises: ValueError when there is nothing that could be used.
    """
    period_s, scales = vehicle.control_period_s, scales_of(vehicle)
    model = build_model(vehicle)
    M = model["M_RB"] + model["M_A"]
    floor = _floor(model, M)
    pieces = [
        steps_of(forces_of(piece, model, scales, period_s), floor, period_s)
        for flight in flights
        for piece in _pieces(flight.usable, period_s)
    ]
    if not pieces:
        raise ValueError(f"no {2 * STEP_S:g} s without a gap or a fault: nothing to identify from")
    noise, step_s = _noise(vehicle, M), round(STEP_S / period_s) * period_s
    prior = Gaussian(np.zeros(len(scales)), np.diag([one.prior_std**2 for one in scales]))
    found = filtered(pieces, prior, noise, floor, step_s)
    halves = [filtered(half, prior, noise, floor, step_s) for half in _halves(pieces)]
    rows = sum(len(flight) for flight in flights)
    used_s = sum(len(piece.impulse) for piece in pieces) * step_s
    return Found(
        tuple(_estimate(i, scale, found, halves) for i, scale in enumerate(scales)),
        used_s,
        max(0.0, rows * period_s - used_s),
    )


def _estimate(i: int, scale: Scale, found: Gaussian, halves: Sequence[Gaussian]) -> Estimate:
    std = sqrt(DOUBT**2 * float(found.covariance[i, i]) + LEAST_STD**2)
    variances = [float(half.covariance[i, i]) for half in halves]
    apart = 0.0
    if len(halves) == 2 and all(sqrt(v) <= KNOWN_SHARE * scale.prior_std for v in variances):
        apart = abs(float(halves[0].mean[i] - halves[1].mean[i])) / (DOUBT * sqrt(sum(variances)))
    return Estimate(scale, 1.0 + float(found.mean[i]), std, apart)


def _pieces(flight: Flight, period_s: float) -> Iterator[Flight]:
    """Stretches of rows that follow one another, long enough for two steps."""
    if not len(flight):
        return
    ends = np.flatnonzero(np.diff(flight.cycle) != 1) + 1
    for begin, end in zip([0, *ends], [*ends, len(flight)], strict=True):
        if (end - begin) * period_s > 2.0 * STEP_S:
            yield flight[begin:end]


def _halves(pieces: Sequence[Steps]) -> list[list[Steps]]:
    """What was flown, cut where half of its steps are over."""
    total, before = sum(len(piece.impulse) for piece in pieces), list[Steps]()
    left = total // 2
    for i, piece in enumerate(pieces):
        m = len(piece.impulse)
        if m >= left:
            first, second = _cut(piece, left)
            return [[*before, first], [second, *pieces[i + 1 :]]]
        before.append(piece)
        left -= m
    return []


def _cut(piece: Steps, at: int) -> tuple[Steps, Steps]:
    first = Steps(piece.momentum[: at + 1], piece.impulse[:at], piece.by_scale[:at], piece.size[:at])
    return first, Steps(piece.momentum[at:], piece.impulse[at:], piece.by_scale[at:], piece.size[at:])


def _floor(model: np.record, M: Array) -> Array:
    """(6,) least error of the model, N and N m; a hull that is told a little less upright than it is rights
    itself otherwise."""
    out = np.diag(M) * np.repeat([FLOOR_MPS2, FLOOR_RADPS2], 3)
    out[3:5] += FLOOR_TILT_RAD * model["weight"] * abs(model["r_g"][2] - model["r_b"][2])
    return out


def _noise(vehicle: Vehicle, M: Array) -> Array:
    """(6,) variance of the momentum as estimated, by the sensors' own figures."""
    dvl, ins = vehicle.sensors.dvl, vehicle.sensors.ins
    velocity = dvl.ground_velocity_noise_mps**2 / (2.0 * T_VELOCITY * dvl.rate_hz)
    rate = np.radians(ins.rate_noise_degps) ** 2
    return M[:, :3] ** 2 @ np.full(3, velocity) + M[:, 3:] ** 2 @ np.full(3, rate) + 1e-12
