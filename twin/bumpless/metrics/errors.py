"""How far the vehicle is from where it should hover: once by the truth, once as it believed."""

from dataclasses import asdict, dataclass

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.units import DEG
from bumpless.metrics.columns import Columns, Floats, lengths


@dataclass(frozen=True)
class EndErrors:
    """Of one cycle, against the observation point and the approach heading."""

    position_m: float  # 3-D distance
    horizontal_m: float  # its horizontal part
    depth_m: float  # its vertical part, positive below
    heading_deg: float  # -180 to 180
    speed_mps: float  # over ground, 3-D

    def message(self) -> pb.EndErrors:
        """As the contract's."""
        return pb.EndErrors(**asdict(self))


@dataclass(frozen=True)
class Errors:
    """The same, one row per cycle; heading in deg."""

    position: Floats
    horizontal: Floats
    depth: Floats
    heading: Floats
    speed: Floats

    def at(self, row: int) -> EndErrors:
        """Of one row."""
        values = (self.position, self.horizontal, self.depth, self.heading, self.speed)
        return EndErrors(*(float(value[row]) for value in values))


def true_errors(run: Columns) -> Errors:
    """By the truth; NaN where nobody knows it. The true point stands off the target as the believed one."""
    return _errors(run.eta, run.nu, run.observation_point + (run.target_true - run.target[:, :3]), run)


def believed_errors(run: Columns) -> Errors:
    """As the vehicle believed."""
    return _errors(run.eta_hat, run.nu_hat, run.observation_point, run)


def is_known(run: Columns) -> bool:
    """Whether the truth of the last cycle is known."""
    return bool(np.isfinite(run.eta[-1]).all() and np.isfinite(run.target_true[-1]).all())


def wrapped_deg(angle: Floats) -> Floats:
    """Angles in rad as deg from -180 to 180."""
    return (angle * DEG + 180.0) % 360.0 - 180.0


def _errors(eta: Floats, nu: Floats, point: Floats, run: Columns) -> Errors:
    off = eta[:, :3] - point
    return Errors(
        position=lengths(off),
        horizontal=lengths(off[:, :2]),
        depth=off[:, 2],
        heading=wrapped_deg(eta[:, 5] - run.heading),
        speed=lengths(nu[:, :3]),
    )
