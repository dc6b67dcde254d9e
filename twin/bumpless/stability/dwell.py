"""The smallest dwell time of a vehicle on a mission, beside the one in use."""

import math
from dataclasses import dataclass

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import FORWARD, HOVER, MODES, REVERSE
from bumpless.contract.modes import MODE_LETTERS
from bumpless.sim.twin import parameters_for
from bumpless.stability.linear import Coordinate, coordinates, difference, with_memory
from bumpless.stability.lyapunov import Certificate, search
from bumpless.stability.operating import Point, settle

SWITCHES = ((FORWARD, REVERSE), (REVERSE, HOVER), (REVERSE, FORWARD), (HOVER, REVERSE), (HOVER, FORWARD))


@dataclass(frozen=True)
class Dwell:
    """radius: spectral radius per cycle of each mode; slowest: the coordinate it is strongest in."""

    in_use: int  # N_dwell, cycles
    period_s: float
    radius: dict[str, float]
    slowest: dict[str, str]
    certificate: Certificate | None  # per sensor period of `period` cycles, after the ramp
    states: int
    ramp: int  # longest ramp, cycles
    period: int

    @property
    def needed(self) -> float:
        """Smallest N_dwell that the certificate proves enough, cycles; infinite without one."""
        return math.inf if self.certificate is None else self.ramp + self.period * self.certificate.dwell

    @property
    def enough(self) -> bool:
        """Whether the dwell in use is proven enough."""
        return self.in_use >= self.needed


def check_dwell(mission: Mission, vehicle: Vehicle, parameters: Parameters | None = None) -> Dwell:
    """Linearise every mode and switch of the mission's settings and search for a certificate."""
    parameters = parameters or parameters_for(vehicle, mission)
    points = {mode: settle(mission, vehicle, parameters, mode) for mode in MODES}
    where = coordinates(points[FORWARD])
    cycle = {mode: difference(point, where, point.period) for mode, point in points.items()}
    ramps = {
        (i, j): _whole(
            parameters.modes[j - FORWARD].ramp_cycles if parameters.bumpless.ramp else 1, points[i]
        )
        for i, j in SWITCHES
    }
    keep = with_memory([*cycle.values()])
    kept, period = [where[k] for k in keep], points[FORWARD].period
    J = {(i, j): _jump(points[i], points[j], kept, ramps[i, j]) for i, j in SWITCHES}
    A = {mode: m[np.ix_(keep, keep)] for mode, m in cycle.items()}
    radius, slowest = {}, {}
    for mode, a in A.items():
        values, vectors = np.linalg.eig(a)
        k = int(np.abs(values).argmax())
        radius[MODE_LETTERS[mode]] = float(np.abs(values[k]) ** (1.0 / period))
        slowest[MODE_LETTERS[mode]] = kept[int(np.abs(vectors[:, k]).argmax())].name
    return Dwell(
        parameters.supervisor.dwell_cycles,
        vehicle.control_period_s,
        radius,
        slowest,
        search(A, J),
        len(keep),
        max(ramps.values()),
        period,
    )


def dwell_warning(dwell: Dwell) -> str:
    """One sentence for the operator; empty when the dwell is proven enough."""
    if dwell.enough:
        return ""
    if dwell.certificate is None:
        mode = max(dwell.radius, key=lambda name: dwell.radius[name])
        return (
            f"mode {mode} does not contract about its reference (spectral radius {dwell.radius[mode]:.5f} "
            f"per cycle, {dwell.slowest[mode]}): no dwell time is proven enough"
        )
    return (
        f"dwell_cycles = {dwell.in_use} is below {dwell.needed:.0f}, the smallest that a Lyapunov function "
        "proves enough for stable switching (Proposition 2)"
    )


def _whole(cycles: int, point: Point) -> int:
    return max(1, math.ceil(cycles / point.period)) * point.period


def _jump(start: Point, end: Point, where: list[Coordinate], cycles: int) -> np.ndarray:
    """From the last cycle of one mode to the end of the ramp into another; what that one holds is held."""
    held, start.held = (
        start.held,
        start.held if math.isnan(end.held) else float(start.twin.world["plant"]["eta"][0]),
    )
    out = difference(start, where, cycles, end.mode)
    start.held = held
    return out
