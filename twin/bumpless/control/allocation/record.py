"""The allocator's records: its settings, one cycle's problem, the answer, and room to work in."""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.config.parameters.records import section_dtype, word_codes

f8, i8 = np.float64, np.int64

THRUST_LINEAR, SPEED_LINEAR, THRUST_IN_FLOW = word_codes("allocation", "direct_map")  # direct maps of S1

ALLOCATION_SETTINGS = section_dtype("allocation")

PROBLEM = np.dtype(  # all that the allocator is told of a cycle
    [
        ("dt", f8),  # control period, s
        ("tau_d", f8, 6),  # what to allocate: the demand, and what easing missed in the last cycle
        ("Q", f8, 6),  # after priorities and slack
        ("R", f8, _n),
        ("lam", f8),
        ("increment_price", f8),
        ("fin_rate", f8),  # that fins must not exceed, rad/s; 0: only what the model allows
        ("u_previous", f8, _n),  # last command, rad or rev/s
        ("u_lower", f8, _n),  # this cycle's bounds
        ("u_upper", f8, _n),
        ("du_max", f8, _n),
        ("warm", i8),  # 1: start at the last command; 0: at rest
        ("nu_flow", f8, 6),  # velocity through water as far as the allocator may see it
        ("effectiveness", f8, _n),  # as the autopilot believes it to be
        ("refused", i8),  # cycles in a row before this one without a demand to allocate
    ],
    align=True,
)

SOLUTION = np.dtype(
    [
        ("u", f8, _n),  # command, rad or rev/s
        ("status", i8),  # SOLVED, BUDGET_SPENT, INFEASIBLE, FALLBACK or REFUSED
        ("iterations", i8),
        ("kkt", f8),
        ("cost", f8),
        ("refused", i8),  # cycles in a row without a demand to allocate, this one among them
        ("slack", f8, 6),  # given up by the softened problem, N and N m
        ("solve_time", f8),  # s
    ],
    align=True,
)

ALLOCATION_STATE = np.dtype(
    [
        ("u", f8, _n),  # last command
        ("tau_c", f8, 6),  # G(u) by the allocator's model, N and N m
        ("refused", i8),
    ],
    align=True,
)

ALLOCATION_WORK = np.dtype(
    [
        ("x", f8, _n),
        ("lower", f8, _n),
        ("upper", f8, _n),
        ("step", f8, _n),
        ("trial", f8, _n),
        ("x_previous", f8, _n),
        ("at_rest", f8, _n),
        ("healthy", f8, _n),
        ("curvature", f8, _n),  # second-order term of the cost, on the diagonal
        ("coupling", f8, _n),  # the same between slot i and the next
        ("free", i8, _n),
        ("weight", f8, 6),
        ("lb", f8, _n),
        ("ub", f8, _n),
        ("g", f8, _n),
        ("H", f8, (_n, _n)),
        ("diagonal", f8, _n),  # of H
        ("jacobian", f8, (6, _n)),
        ("tau", f8, 6),
        ("price", f8, _n),
        ("demand", f8, 6),
        ("missed", f8, 6),
        ("channel", f8, 6),
        ("flow", f8, 6),
        ("limited", i8, 6),  # 1 where a command at a bound has authority
    ],
    align=True,
)
