"""What the actuators can do against the water, and settings as the compiled rules read them."""

from typing import Any

import numpy as np

from bumpless.config.parameters import DockingParameters
from bumpless.config.parameters.records import fill_record
from bumpless.control.docking.record import DOCKING_SETTINGS
from bumpless.physics.actuators import KINDS

_FASTEST = 5.0  # m/s, no vehicle of this kind is faster


def plain(function: Any) -> Any:
    """A compiled function's own Python: the same rule, without a compilation."""
    return getattr(function, "py_func", function)


def docking_settings(parameters: DockingParameters) -> Any:
    """DOCKING_SETTINGS with attributes, as compiled code sees it."""
    out = np.zeros(1, DOCKING_SETTINGS)
    fill_record(parameters, out[0])
    return out.view(np.recarray)[0]


def screws(model: Any) -> list[int]:
    """The slots of commands that are the shaft speed of a screw."""
    return [i for i in range(int(model["n_u"])) if model["T_nn"][i] > 0.0]


def thrust_ahead(model: Any, u_r: float) -> float:
    """Largest thrust along x_b at a speed through water u_r, m/s, in N; MODEL of the vehicle."""
    total = 0.0
    for i in screws(model):
        share = float(model["direction"][i, 0])
        if abs(share) < 0.05:
            continue
        forward = share > 0.0
        n = float(model["command_max"][i] if forward else -model["command_min"][i])
        T_nn = float(model["T_nn"][i] if forward else model["T_nn_reverse"][i])
        total += abs(share) * max(T_nn * n * n - float(model["T_nv"][i]) * n * u_r * abs(share), 0.0)
    return total


def drag(model: Any, axis: int, speed: float) -> float:
    """Drag at `speed` along one axis (0: ahead, 1: sideways), N."""
    return float((model["D_linear"][axis, axis] + model["D_quadratic"][axis, axis] * speed) * speed)


def top_speed(model: Any) -> float:
    """Fastest steady speed through still water, m/s."""
    speeds = np.linspace(0.0, _FASTEST, 501)
    able = [speed for speed in speeds if thrust_ahead(model, float(speed)) >= drag(model, 0, float(speed))]
    return float(max(able, default=0.0))


def side_force(model: Any) -> float:
    """Largest force along y_b at rest, N; 0 for a vehicle without sideways thrust."""
    if not model["controllable"][1] > 0.0:
        return 0.0
    total = 0.0
    for i in screws(model):
        turns = model["kind"][i] == KINDS["azimuth"].KIND
        share = np.sin(min(model["command_max"][i + 1], 0.5 * np.pi)) if turns else model["direction"][i, 1]
        total += abs(float(share * model["T_nn"][i] * model["command_max"][i] ** 2))
    return total
