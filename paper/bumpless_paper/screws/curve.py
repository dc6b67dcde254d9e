"""C_T* over the angle of flow: measured screws, and what the plant makes of a few numbers of theirs.

C_T* = T / (rho/2 A (V^2 + (0.7 pi n D)^2)), tan beta = V / (0.7 pi n D): ahead from 0 deg, stopped at 90 and
270 deg, astern at 180 deg.

Source: Roddy, Hess and Faller 2006, NSWCCD-50-TR-2006/004; van Lammeren, van Manen and Oosterveld 1969.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bumpless.physics.actuators.screw_flow import driven
from bumpless.physics.model_record import MODEL

Array = NDArray[np.float64]
DATA = json.loads((Path(__file__).parent / "four_quadrants.json").read_text(encoding="utf-8"))["screws"]
NAMES = tuple(DATA)
TIP = 0.7 * np.pi  # speed of the blades at 0.7 R over n D
TO_K = np.pi / 8.0  # K_T = pi/8 C_T* (J^2 + (0.7 pi)^2)


def measured(name: str, beta: Array) -> tuple[Array, Array]:
    """(C_T*, C_Q*) of a screw at the angles beta, rad."""
    a_t, b_t, a_q, b_q = np.array(DATA[name]["series"]).T
    k = np.arange(len(a_t))[:, None] * beta
    return (a_t @ np.cos(k) + b_t @ np.sin(k)) / 100.0, -(a_q @ np.cos(k) + b_q @ np.sin(k)) / 1000.0


@dataclass(frozen=True)
class Numbers:
    """What a vehicle file says of a screw, here read off a measured curve."""

    bollard: float  # C_T* ahead without flow
    bollard_astern: float  # positive
    zero_thrust: float  # tan beta
    stopped_drag: float  # -C_T* at 90 deg
    stopped_torque: float  # -C_Q* there
    opposed_thrust_slope: float = 0.0  # -dK_T/dJ against the flow


def numbers_of(name: str, opposed_thrust_slope: float = 0.0) -> Numbers:
    """Of a measured screw, with a slope against the flow that is chosen."""
    (ahead, stopped, astern), (_, torque, _) = measured(name, np.radians([0.0, 90.0, 180.0]))
    beta = np.radians(np.linspace(10.0, 45.0, 3501))
    zero = beta[np.argmin(np.abs(measured(name, beta)[0]))]
    return Numbers(ahead, -astern, float(np.tan(zero)), -stopped, -torque, opposed_thrust_slope)


def of_the_plant(numbers: Numbers, beta: Array) -> Array:
    """C_T* of the plant's screw at the angles beta, by the very function that flies."""
    model = np.zeros(1, MODEL)[0]  # rho = D = 1
    k_t = TO_K * TIP**2
    model["T_nn"][0], model["T_nn_reverse"][0] = k_t * numbers.bollard, k_t * numbers.bollard_astern
    model["T_nv"][0] = model["T_nn"][0] / (TIP * numbers.zero_thrust)
    model["T_vv"][0] = TO_K * numbers.stopped_drag
    model["T_no"][0], model["direction"][0] = numbers.opposed_thrust_slope, (1.0, 0.0, 0.0)
    thrust = [driven(model, 0, float(np.cos(b)) / TIP, float(np.sin(b)))[0] for b in beta]
    return np.array(thrust) / TO_K
