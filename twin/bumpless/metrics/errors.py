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
    speed_mps: float  # over ground, 3-D; by the truth against a target that moves

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
    errors = _errors(run.eta, run.nu, run.observation_point + (run.target_true - run.target[:, :3]), run)
    moves = len(run) > 1 and np.nan_to_num(np.ptp(run.target_true, axis=0)).any()
    if moves and (np.diff(run.time) > 0.0).all():
        errors.speed[:] = _speed_against(run)
    return errors


def _speed_against(run: Columns) -> Floats:
    """(n,) m/s of the hull against a target that moves, as a hung dock does."""
    moving = np.gradient(run.target_true, run.time, axis=0)
    return lengths(turned(run.eta, run.nu[:, :3]) - moving)


def turned(eta: Floats, body: Floats) -> Floats:
    """(n, 3) vectors in body axes, turned into NED by the attitudes of eta (n, 6)."""
    c, s = np.cos(eta[:, 3:]), np.sin(eta[:, 3:])
    (cf, ct, cp), (sf, st, sp), (x, y, z) = c.T, s.T, body.T
    north = cp * ct * x + (cp * st * sf - sp * cf) * y + (sp * sf + cp * cf * st) * z
    east = sp * ct * x + (cp * cf + sf * st * sp) * y + (st * sp * cf - cp * sf) * z
    return np.stack([north, east, -st * x + ct * sf * y + ct * cf * z], axis=1)


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
