"""Prestero's model as he wrote it, equation by equation, beside the plant: plain NumPy, no shared code.

Source: Prestero 2001, chapter 5: combined coefficients, rudder and stern plane in pairs, constant thrust.
"""

import json

import numpy as np
from scipy.integrate import solve_ivp

from bumpless_paper.remus.check import PUBLISHED

C = json.loads(PUBLISHED.read_text(encoding="utf-8"))["coefficients"]
W, G, Z_G, I_XX, I_YY = 299.0, 9.81, 0.0196, 0.177, 3.45
THRUST_N, SPEED_MPS = 3.86, 1.54
MASS = W / G


def inertia() -> np.ndarray:
    """Left side: mass, added mass and the centre of gravity below O_b, I_zz = I_yy."""
    m, z = MASS, MASS * Z_G
    M = np.diag([m - C["X_udot"], m - C["Y_vdot"], m - C["Z_wdot"], I_XX - C["K_pdot"],
                 I_YY - C["M_qdot"], I_YY - C["N_rdot"]])  # fmt: skip
    M[0, 4] = z
    M[1, 3], M[1, 5] = -z, -C["Y_rdot"]
    M[2, 4] = -C["Z_qdot"]
    M[3, 1] = -z
    M[4, 0], M[4, 2] = z, -C["M_wdot"]
    M[5, 1] = -C["N_vdot"]
    return M


M_INV = np.linalg.inv(inertia())


def rate(x: np.ndarray, rudder: float, stern: float) -> np.ndarray:
    """d/dt of [eta nu] of a neutrally buoyant vehicle, rad and SI."""
    phi, theta, psi, u, v, w, p, q, r = x[3:]
    m, z = MASS, MASS * Z_G
    c, s = np.cos, np.sin
    X = (THRUST_N + C["X_uu"] * u * abs(u) + (C["X_wq"] - m) * w * q + C["X_qq"] * q * q
         + (C["X_vr"] + m) * v * r + C["X_rr"] * r * r - z * p * r)  # fmt: skip
    Y = (C["Y_vv"] * v * abs(v) + C["Y_rr"] * r * abs(r) + C["Y_uv"] * u * v + (C["Y_wp"] + m) * w * p
         + (C["Y_ur"] - m) * u * r - z * q * r + C["Y_pq"] * p * q
         + C["Y_uudr"] * u * u * rudder)  # fmt: skip
    Z = (C["Z_ww"] * w * abs(w) + C["Z_qq"] * q * abs(q) + C["Z_uw"] * u * w + (C["Z_uq"] + m) * u * q
         + (C["Z_vp"] - m) * v * p + z * (p * p + q * q) + C["Z_rp"] * r * p
         + C["Z_uuds"] * u * u * stern)  # fmt: skip
    K = -Z_G * W * c(theta) * s(phi) + C["K_pp"] * p * abs(p) + z * (u * r - w * p)
    M = (-Z_G * W * s(theta) + C["M_ww"] * w * abs(w) + C["M_qq"] * q * abs(q)
         + (C["M_rp"] - I_XX + I_YY) * r * p + z * (v * r - w * q) + C["M_uq"] * u * q + C["M_vp"] * v * p
         + C["M_uw"] * u * w + C["M_uuds"] * u * u * stern)  # fmt: skip
    N = (C["N_vv"] * v * abs(v) + C["N_rr"] * r * abs(r) + C["N_uv"] * u * v
         + (C["N_pq"] - I_YY + I_XX) * p * q + C["N_wp"] * w * p + C["N_ur"] * u * r
         + C["N_uudr"] * u * u * rudder)  # fmt: skip
    sf, cf, st, ct, sp, cp = s(phi), c(phi), s(theta), c(theta), s(psi), c(psi)
    turn = np.array([
        [cp * ct, cp * st * sf - sp * cf, sp * sf + cp * cf * st],
        [sp * ct, cp * cf + sf * st * sp, st * sp * cf - cp * sf],
        [-st, ct * sf, ct * cf],
    ])  # fmt: skip
    about = (q * s(phi) + r * c(phi)) / c(theta)
    euler = (p + about * s(theta), q * c(phi) - r * s(phi), about)
    return np.concatenate([turn @ x[6:9], euler, M_INV @ (X, Y, Z, K, M, N)])


def thesis_run(rudder_deg: float, stern_deg: float, times: np.ndarray) -> np.ndarray:
    """States (n, 12) at `times` from straight flight at 1.54 m/s with the fins set at once."""
    begin = np.zeros(12)
    begin[6] = SPEED_MPS
    fins = np.radians([rudder_deg, stern_deg])
    found = solve_ivp(
        lambda _, x: rate(x, *fins), (0.0, times[-1]), begin, t_eval=times, rtol=1e-8, atol=1e-9
    )
    return found.y.T
