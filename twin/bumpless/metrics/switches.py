"""Steps of the commands around each mode switch.

d_u of the paper mixes degrees and rpm. Here the step is taken on commands divided by their amplitude
bounds, so that no actuator outweighs the others by its unit; the paper's own mixture stands beside it.
"""

from dataclasses import dataclass

import numpy as np

from bumpless.metrics.columns import Columns, Floats

WINDOW_S = 2.0  # on either side of a switch


@dataclass(frozen=True)
class SwitchSteps:
    """Largest change from one cycle to the next within WINDOW_S of a switch."""

    row: int  # first row in the new mode
    from_mode: int
    to_mode: int
    normalised: float  # max ||du||, commands over their bounds
    raw: float  # max ||du||, deg and rpm mixed
    per_actuator: Floats  # (n_u,) max |du_i|, deg or rpm


def switch_steps(run: Columns, bounds: Floats, edge: Floats) -> list[SwitchSteps]:
    """One entry per mode switch, in order.

    bounds: (n_u,) largest amplitude, rad or rev/s; edge: (n_u,) deg per rad or rpm per rev/s.
    Source: Gao et al. 2026, section 4.1 (d_u,FR and d_u,RH: max ||u(k) - u(k-1)|| around a switch).
    Differs: normalised by bounds; the paper's mixture is `raw`.
    """
    steps = np.zeros_like(run.u)
    steps[1:] = np.diff(run.u, axis=0)
    steps[~run.follows] = 0.0
    found = []
    for row in np.flatnonzero(np.diff(run.mode)) + 1:
        near = np.abs(run.time - run.time[row]) <= WINDOW_S + 1e-9
        du = steps[near]
        found.append(
            SwitchSteps(
                row=int(row),
                from_mode=int(run.mode[row - 1]),
                to_mode=int(run.mode[row]),
                normalised=float(np.linalg.norm(du / bounds, axis=1).max()),
                raw=float(np.linalg.norm(du * edge, axis=1).max()),
                per_actuator=np.abs(du * edge).max(axis=0),
            )
        )
    return found


def largest(steps: list[SwitchSteps], from_mode: int, to_mode: int) -> float:
    """Largest normalised step over all switches of one kind; NaN when there was none."""
    found = [s.normalised for s in steps if (s.from_mode, s.to_mode) == (from_mode, to_mode)]
    return max(found, default=float("nan"))
