"""What the paper compares with: a direct PID mapping (S1) and a weighted pseudo-inverse (S2).

Source: Gao et al. 2026, sec. 4.2 and table 5. Neither knows bounds: commands are clipped afterwards.
Both are linear at rest, where only the first command of an actuator has an effect: a pod stays straight.
"""

import numpy as np

from bumpless.contract.enums import SOLVED
from bumpless.control.allocation.record import SPEED_LINEAR, THRUST_IN_FLOW
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.jit import jit
from bumpless.physics.actuators import to_command, to_x
from bumpless.physics.actuators.geometry import inflow_along
from bumpless.physics.actuators.thruster import thrust_scale

_DAMPING = 1e-6


@jit
def solve_small(A, b, n):
    """Solve A y = b in place for symmetric positive definite A (n, n) by Cholesky; b becomes y."""
    for i in range(n):
        for j in range(i + 1):
            s = A[i, j]
            for k in range(j):
                s -= A[i, k] * A[j, k]
            if i == j:
                A[i, i] = np.sqrt(s) if s > 1e-300 else 1e-150
            else:
                A[i, j] = s / A[j, j]
    for i in range(n):
        s = b[i]
        for k in range(i):
            s -= A[i, k] * b[k]
        b[i] = s / A[i, i]
    for i in range(n - 1, -1, -1):
        s = b[i]
        for k in range(i + 1, n):
            s -= A[k, i] * b[k]
        b[i] = s / A[i, i]


@jit
def _pseudo_inverse(model, R, w, demand, channel, member, x):
    """x += W^-1 G' (G W^-1 G' + eps I)^-1 demand over the member actuators and the given channels."""
    n = model.n_u
    scale = 0.0
    for k in range(6):
        for m in range(6):
            s = 0.0
            if channel[k] > 0.0 and channel[m] > 0.0:
                for i in range(n):
                    if member[i] > 0.0:
                        s += w.jacobian[k, i] * w.jacobian[m, i] / max(R[i], 1e-9)
            w.H[k, m] = s
        scale = max(scale, w.H[k, k])
    for k in range(6):
        w.H[k, k] += _DAMPING * scale + 1e-12
        w.g[k] = demand[k] * channel[k]
    solve_small(w.H, w.g, 6)
    for i in range(n):
        if member[i] > 0.0:
            for k in range(6):
                x[i] += channel[k] * w.jacobian[k, i] * w.g[k] / max(R[i], 1e-9)


@jit
def _apply(model, problem, x, solution):
    """Clip x (8,) into this cycle's bounds and turn it into commands."""
    lower, upper = problem.u_lower, problem.u_upper
    for i in range(model.n_u):
        y = min(max(x[i], to_x(model, i, lower[i])), to_x(model, i, upper[i]))
        solution.u[i] = min(max(to_command(model, i, y), lower[i]), upper[i])
    solution.status, solution.iterations, solution.refused = SOLVED, 0, 0
    solution.kkt = solution.cost = 0.0


@jit
def allocate_wls(model, problem, solution, w):
    """Weighted least-squares pseudo-inverse with clipping: weights R, the map linearised at rest."""
    n = model.n_u
    p = problem
    for i in range(n):
        w.x[i], w.trial[i] = 0.0, 1.0 if model.part[i] == 0 else 0.0
    wrench_map(model, w.x, p.u_previous, p.effectiveness, p.nu_flow, w.tau, w.jacobian)
    for k in range(6):
        w.demand[k] = p.tau_d[k] - w.tau[k]
    _pseudo_inverse(model, p.R, w, w.demand, model.controllable, w.trial, w.x)
    _apply(model, p, w.x, solution)


@jit
def allocate_direct(direct_map, surge, model, problem, solution, w):
    """Each PID channel drives its own actuators through a mixer made for the speed `surge`, m/s.

    Forces go to what pushes and moments to what steers, if there are any of both; neither group
    knows what the other, the drag or the present flow does. A thruster's demand becomes thrust
    (THRUST_LINEAR); thrust with what the inflow takes at the last command made up (THRUST_IN_FLOW); or, as a
    PID output scaled to the shaft's range, shaft speed (SPEED_LINEAR).
    """
    n = model.n_u
    steering, pushing = 0, 0
    for i in range(n):
        w.at_rest[i] = 0.0
        w.x[i] = 0.0
        if model.steers[i] == 1:
            steering += 1
        else:
            pushing += 1
    for k in range(6):
        w.flow[k] = 0.0
    w.flow[0] = surge
    w.healthy[:] = 1.0
    wrench_map(model, w.x, w.at_rest, w.healthy, w.flow, w.tau, w.jacobian)
    if steering == 0 or pushing == 0:
        for i in range(n):
            w.trial[i] = 1.0 if model.part[i] == 0 else 0.0
        _pseudo_inverse(model, problem.R, w, problem.tau_d, model.controllable, w.trial, w.x)
    else:
        for group in range(2):
            for k in range(6):
                w.channel[k] = model.controllable[k] if (k < 3) == (group == 0) else 0.0
            for i in range(n):
                w.trial[i] = 1.0 if model.steers[i] == group and model.part[i] == 0 else 0.0
            _pseudo_inverse(model, problem.R, w, problem.tau_d, w.channel, w.trial, w.x)
    if direct_map == THRUST_IN_FLOW:
        for i in range(n):
            if model.steers[i] == 0 and model.part[i] == 0:
                d = model.direction[i]
                taken = model.T_nv[i] * inflow_along(model, i, problem.nu_flow, d[0], d[1], d[2])
                w.x[i] += taken * abs(problem.u_previous[i]) / thrust_scale(model, i)
    if direct_map == SPEED_LINEAR:
        for i in range(n):
            if model.steers[i] == 0:
                share = min(max(w.x[i], -1.0), 1.0)
                w.x[i] = to_x(model, i, share * model.command_max[i])
    _apply(model, problem, w.x, solution)
