"""Quaternions for viser: scalar first, body to parent."""

from math import cos, radians, sin

import numpy as np
import numpy.typing as npt

from bumpless.contract import bumpless_pb2 as pb

Quaternion = tuple[float, float, float, float]


def about(axis: tuple[float, float, float], angle_rad: float) -> Quaternion:
    """Quaternion of a turn about a unit axis, right-handed."""
    x, y, z = axis
    s = sin(angle_rad / 2.0)
    return (cos(angle_rad / 2.0), x * s, y * s, z * s)


def multiply(p: Quaternion, q: Quaternion) -> Quaternion:
    """p after q: the turn q first, then p."""
    a, b, c, d = p
    e, f, g, h = q
    return (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )


def of_attitude(attitude: pb.Attitude) -> Quaternion:
    """Body to NED of Euler zyx angles. Source: Fossen 2021, ch. 2."""
    roll = about((1, 0, 0), radians(attitude.roll_deg))
    pitch = about((0, 1, 0), radians(attitude.pitch_deg))
    return multiply(of_heading(attitude.yaw_deg), multiply(pitch, roll))


def of_heading(yaw_deg: float) -> Quaternion:
    """Turn about down by a heading."""
    return about((0, 0, 1), radians(yaw_deg))


def vector(message: pb.Vector3) -> npt.NDArray[np.float64]:
    """A contract vector as an array (3,); NaN and infinity become zero, which viser cannot draw."""
    return np.nan_to_num(np.array([message.x, message.y, message.z]), nan=0.0, posinf=0.0, neginf=0.0)
