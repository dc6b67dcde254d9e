"""A rigid piece of the drawn vehicle, and how an actuator's command moves it. Body axes; m and radians."""

from dataclasses import dataclass
from math import pi, radians
from typing import Literal

from bumpless_server.scene.mesh import Mesh

Role = Literal["hull", "accent", "frame", "fin", "propeller"]  # what colours it
SPIN_SHARE = 0.2  # screws are drawn at a fifth of their speed: at 20 pictures a second the true one aliases


@dataclass(frozen=True)
class Part:
    """A rigid piece: its mesh about `position`, and the axis about which a command moves it, if any."""

    name: str
    role: Role
    mesh: Mesh
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)  # in body axes, all joints at zero
    axis: tuple[float, float, float] | None = None
    command: int = -1  # whose measured state moves it: its place in u
    motion: Literal["turn", "spin"] = "turn"  # to an angle in deg, or onward at a speed in rpm
    carrier: str = ""  # name of the part that carries it around, listed before it; "": the hull


def joint_angle(feedback_deg: float) -> float:
    """Turn of a part about its axis, rad: a positive deflection lifts a fin's leading edge along e_L."""
    return radians(feedback_deg)


def spin_step(shaft_speed_rpm: float, dt_s: float) -> float:
    """Drawn turn of a screw in dt, rad, slowed by SPIN_SHARE."""
    return shaft_speed_rpm / 60.0 * 2.0 * pi * SPIN_SHARE * dt_s
