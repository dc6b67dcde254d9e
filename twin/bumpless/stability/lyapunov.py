"""Multiple quadratic Lyapunov functions for a system that switches: V_i(x) = x' P_i x as mode i is left.

Switching is stable if V falls from each switch to the next: with M_ij = A_j^N J_ij, V_j(M_ij x) < V_i(x) for
every switch i to j and every dwell of N cycles or more. Such P_i are the fixed point of
P_i = Q + sum_j M_ij' P_j M_ij, and the smallest N for which it exists is found by bisection. It is then
written in the terms of Proposition 2 of Gao et al. 2026: rho_j per cycle, mu_ij per switch, mu rho^N < 1.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pair = tuple[int, int]
LONGEST = 20_000  # cycles after which the search gives up
SLOWEST = 1.0 - 1e-7  # a spectral radius above this counts as no contraction
_ROUNDS = 120
_LONGER = (1.0, 1.02, 1.05, 1.1, 1.2, 1.35, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0)


@dataclass(frozen=True)
class Certificate:
    """dwell: cycles after the ramp that suffice for all switches; gain: V after over V before, at that dwell;
    rho: contraction of V per cycle and mode; mu: per switch, so that V grows at most mu rho^n in n cycles."""

    dwell: int
    gain: dict[Pair, float]
    rho: dict[int, float]
    mu: dict[Pair, float]


def spectral_radius(A: Array) -> float:
    """Largest magnitude of an eigenvalue."""
    return float(np.abs(np.linalg.eigvals(A)).max())


def search(A: dict[int, Array], J: dict[Pair, Array]) -> Certificate | None:
    """The certificate of the smallest dwell; None when a mode does not contract or none is found.

    A: per mode, over one cycle; J: per switch, from the last cycle of one mode to the end of the ramp.
    """
    if max(spectral_radius(a) for a in A.values()) >= SLOWEST:
        return None
    low, high = 0, 1
    while _functions(A, J, high) is None:
        low, high = high, 2 * high
        if high > LONGEST:
            return None
    while high - low > max(1, high // 100):
        middle = (low + high) // 2
        low, high = (low, middle) if _functions(A, J, middle) is not None else (middle, high)
    while high <= LONGEST:
        P = _functions(A, J, high)
        if P is not None and all(_gain(A, J, P, round(high * f)).max() < 1.0 for f in _LONGER):
            return _as_proposition(A, J, P, high)
        high += max(1, high // 20)
    return None


def _functions(A: dict[int, Array], J: dict[Pair, Array], dwell: int) -> dict[int, Array] | None:
    """The fixed point for one dwell, or None when it does not exist."""
    n = next(iter(A.values())).shape[0]
    power = {j: np.linalg.matrix_power(a, dwell) for j, a in A.items()}
    M = {(i, j): power[j] @ jump for (i, j), jump in J.items()}
    P = {i: np.eye(n) for i in A}
    size: list[float] = []
    for _ in range(_ROUNDS):  # growth of the homogeneous map
        P = {i: sum((m.T @ P[j] @ m for (k, j), m in M.items() if k == i), np.zeros((n, n))) for i in A}
        size.append(max(float(np.trace(p)) for p in P.values()))
        if size[-1] == 0.0:
            break
        P = {i: p / size[-1] for i, p in P.items()}
    tail = size[-_ROUNDS // 2 :]  # modes take turns, so single rounds may grow while pairs of them shrink
    if tail[-1] > 0.0 and math.exp(sum(map(math.log, tail)) / len(tail)) >= 0.97:
        return None
    scale = _balance(M, n)
    P = {i: scale.copy() for i in A}
    for _ in range(4 * _ROUNDS):
        new = {
            i: scale + sum((m.T @ P[j] @ m for (k, j), m in M.items() if k == i), np.zeros((n, n))) for i in A
        }
        change = max(float(np.abs(new[i] - P[i]).max() / np.abs(new[i]).max()) for i in A)
        P = new
        if not math.isfinite(change):
            return None
        if change < 1e-10:
            break
    return P


def _balance(M: dict[Pair, Array], n: int) -> Array:
    """A small positive Q that weighs each coordinate as the maps do."""
    weight = sum((np.sum(m**2, axis=0) for m in M.values()), np.zeros(n))
    return np.diag(1e-3 * weight + 1e-9 * weight.max() + 1e-12)


def _gain(A: dict[int, Array], J: dict[Pair, Array], P: dict[int, Array], dwell: int) -> Array:
    """Largest V_j after the dwell over V_i before the switch, for every switch."""
    root = {i: np.linalg.cholesky(p).T for i, p in P.items()}
    back = {i: np.linalg.inv(r) for i, r in root.items()}
    power = {j: np.linalg.matrix_power(a, dwell) for j, a in A.items()}
    norms = [np.linalg.norm(root[j] @ power[j] @ jump @ back[i], 2) for (i, j), jump in J.items()]
    return np.array(norms, float) ** 2


def _as_proposition(
    A: dict[int, Array], J: dict[Pair, Array], P: dict[int, Array], dwell: int
) -> Certificate:
    rho = {i: 1.0 - 0.9 * (1.0 - spectral_radius(a) ** 2) for i, a in A.items()}
    mu = dict.fromkeys(J, 0.0)
    for cycles in (0, *np.unique(np.geomspace(1, 10 * dwell, 24).astype(int)).tolist()):
        for pair, gain in zip(J, _gain(A, J, P, cycles), strict=True):
            mu[pair] = max(mu[pair], float(gain) * math.exp(-cycles * math.log(rho[pair[1]])))
    gains = _gain(A, J, P, dwell)
    return Certificate(dwell, {pair: float(g) for pair, g in zip(J, gains, strict=True)}, rho, mu)
