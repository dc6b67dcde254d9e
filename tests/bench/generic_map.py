"""The allocator's wrench map once more, in array operations that NumPy and CasADi both have.

For the peers only: the paper-style implementation evaluates it in NumPy, IPOPT differentiates it in
CasADi. `bumpless.control.allocation.wrench_map` is what flies; both are compared before anything is measured.
"""

from types import SimpleNamespace
from typing import Any

import numpy as np

from bumpless.physics.actuators import FIN, THRUSTER

STALL_WIDTH = 0.12


def numpy_operations() -> SimpleNamespace:
    """What the map needs, from NumPy."""
    return SimpleNamespace(where=np.where, sin=np.sin, atan2=np.arctan2, sqrt=np.sqrt, abs=np.abs,
                           minimum=np.minimum, maximum=np.maximum, mod=np.mod)  # fmt: skip


def parts(model: np.void) -> SimpleNamespace:
    """The vehicle's constants per actuator, (n,) or (n, 3), and who is a fin."""
    n = int(model["n_u"])
    if not np.isin(model["kind"][:n], (FIN, THRUSTER)).all():
        raise ValueError("the peers know fins and fixed thrusters alone")
    names = ("position", "direction", "command_max", "T_nn", "T_nn_reverse", "T_nv", "Q_nn", "Q_nv",
             "fin_area", "C_La", "C_D0", "C_D2", "stall_angle", "reverse_lift")  # fmt: skip
    constants = {name: np.array(model[name][:n]) for name in names}
    return SimpleNamespace(n=n, rho=float(model["rho"]), fin=model["kind"][:n] == FIN, **constants)


def wrench(ops: SimpleNamespace, m: SimpleNamespace, x: Any, u_previous: Any, effect: Any, nu: Any) -> list:
    """[X Y Z K M N] of commands x (n,), as `wrench_map` defines them."""
    r, e = m.position, m.direction
    vx = nu[0] + nu[4] * r[:, 2] - nu[5] * r[:, 1]
    vy = nu[1] + nu[5] * r[:, 0] - nu[3] * r[:, 2]
    vz = nu[2] + nu[3] * r[:, 1] - nu[4] * r[:, 0]
    along = e[:, 0] * vx + e[:, 1] * vy + e[:, 2] * vz
    fx, fe = _fin(ops, m, x * m.command_max, vx, along)
    thrust, torque = _screw(ops, m, x, u_previous, along)
    fin = m.fin.astype(float)
    F = [effect * (fin * (fx * (axis == 0) + fe * e[:, axis]) + (1.0 - fin) * thrust * e[:, axis])
         for axis in range(3)]  # fmt: skip
    T = [effect * (1.0 - fin) * torque * e[:, axis] for axis in range(3)]
    moment = [
        r[:, 1] * F[2] - r[:, 2] * F[1],
        r[:, 2] * F[0] - r[:, 0] * F[2],
        r[:, 0] * F[1] - r[:, 1] * F[0],
    ]
    return [_sum(m.n, f) for f in F] + [_sum(m.n, a + b) for a, b in zip(moment, T, strict=True)]


def _sum(n: int, values: Any) -> Any:
    total = values[0]
    for i in range(1, n):
        total = total + values[i]
    return total


def _screw(ops: SimpleNamespace, m: SimpleNamespace, x: Any, u_previous: Any, inflow: Any) -> tuple:
    z = x * m.T_nn * m.command_max**2
    speed = ops.abs(u_previous)
    T_nn, T_back = np.where(m.fin, 1.0, m.T_nn), np.where(m.fin, 1.0, m.T_nn_reverse)
    arm = ops.where(z >= 0.0, m.Q_nn / T_nn, m.Q_nn / T_back)
    return z - m.T_nv * speed * inflow, arm * z - m.Q_nv * speed * inflow


def _fin(ops: SimpleNamespace, m: SimpleNamespace, delta: Any, u: Any, v: Any) -> tuple:
    speed2 = u * u + v * v
    speed = ops.sqrt(ops.maximum(speed2, 1e-12))
    a = ops.mod(delta - ops.atan2(v, u) + np.pi, 2.0 * np.pi) - np.pi
    back = ops.abs(a) > 0.5 * np.pi
    slope = ops.where(back, m.C_La * m.reverse_lift, m.C_La)
    a = ops.where(a > 0.5 * np.pi, a - np.pi, ops.where(a < -0.5 * np.pi, a + np.pi, a))
    t = ops.minimum(1.0, ops.maximum(0.0, ops.abs(a) - m.stall_angle) / STALL_WIDTH)
    s = t * t * (3.0 - 2.0 * t)
    c_l = (1.0 - s) * slope * a + s * ops.sin(2.0 * a)
    c_d = m.C_D0 + (1.0 - s) * m.C_D2 * a * a + s * 2.0 * ops.sin(a) * ops.sin(a)
    q = 0.5 * m.rho * ops.where(speed2 < 1e-12, 0.0, speed2) * m.fin_area
    cb, sb = u / speed, v / speed
    return q * (-c_d * cb - c_l * sb), q * (-c_d * sb + c_l * cb)
