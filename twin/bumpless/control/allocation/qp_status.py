"""Outcomes of a QP solve: the numbers of `SolveStatus` in the contract."""

SOLVED = 1  # optimal within tolerance
BUDGET_SPENT = 2  # feasible, but not shown to be optimal
INFEASIBLE = 3  # a lower bound lies above its upper bound; the nearest point is returned
FALLBACK = 4  # the chosen solver failed; the built-in active set answered
REFUSED = 5  # not a number among the data; the start, moved inside the bounds, is returned
