"""Steps of the commands around each mode switch.

The largest step hides outside the paper's window when a ramp defers it; `Settling` looks past the ramp.
d_u of the paper mixes degrees and rpm. Here the step is taken on commands divided by their amplitude
bounds, so that no actuator outweighs the others by its unit; the paper's own mixture stands beside it.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from bumpless.metrics.columns import Columns, Floats

WINDOW_S = 2.0  # on either side of a switch
AFTER_RAMP_S = 15.0  # past the end of the switch's ramp; what a ramp defers falls in here


@dataclass(frozen=True)
class SwitchSteps:
    """Largest change from one cycle to the next within WINDOW_S of a switch.

    NaN, all of it, where the cycle before the switch is not in the log: nobody saw its step.
    """

    row: int  # first row in the new mode
    from_mode: int
    to_mode: int
    normalised: float  # max ||du||, commands over their bounds
    raw: float  # max ||du||, deg and rpm mixed
    per_actuator: Floats  # (n_u,) max |du_i|, deg or rpm
    settling: "Settling"


@dataclass(frozen=True)
class Settling:
    """Largest change from one cycle to the next, from a switch until AFTER_RAMP_S after its ramp's end.

    The next switch ends it earlier: its own steps are its own. NaN where the truth is not known.
    """

    seconds: float
    normalised: float  # max ||du||, commands over their bounds
    force: float  # of the plant's true wrench, N
    moment: float  # N m
    acceleration: float  # of the true body acceleration, m/s^2
    angular_acceleration: float  # rad/s^2


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
        if not run.follows[row]:
            found.append(_unseen(run, int(row)))
            continue
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
                settling=_settling(run, steps / bounds, int(row)),
            )
        )
    return found


def _unseen(run: Columns, row: int) -> SwitchSteps:
    """Of a switch that fell into a gap of the log: `row` is the first after it."""
    no = float("nan")
    change = (int(run.mode[row - 1]), int(run.mode[row]))
    none = np.full(run.u.shape[1], no)
    return SwitchSteps(row, *change, no, no, none, Settling(no, no, no, no, no, no))


def _settling(run: Columns, du: Floats, row: int) -> Settling:
    left = np.flatnonzero(run.mode[row:] != run.mode[row])
    last = row + int(left[0]) if len(left) else len(run)  # the first row of another mode
    ramped = np.flatnonzero(run.kappa[row:last] >= 1.0)
    if len(ramped):
        until = run.time[row + int(ramped[0])] + AFTER_RAMP_S + 1e-9
        last = row + int(np.count_nonzero(run.time[row:last] <= until))
    stay = slice(row, last)
    before = np.concatenate([[False], run.follows[:-1]])  # an acceleration needs two cycles, its step three
    step, jerk = _changes(run.tau, run.follows), _changes(_accelerations(run), run.follows & before)
    return Settling(
        seconds=float(run.time[last - 1] - run.time[row]),
        normalised=_largest(du[stay]),
        force=_largest(step[stay, :3]),
        moment=_largest(step[stay, 3:]),
        acceleration=_largest(jerk[stay, :3]),
        angular_acceleration=_largest(jerk[stay, 3:]),
    )


def _changes(values: Floats, follows: npt.NDArray[np.bool_]) -> Floats:
    """From the row before; 0 after a gap."""
    return np.where(follows[:, None], np.diff(values, axis=0, prepend=values[:1]), 0.0)


def _accelerations(run: Columns) -> Floats:
    """(n, 6) mean of the cycle before each row, body axes, m/s^2 and rad/s^2; 0 after a gap."""
    periods = np.diff(run.time, prepend=run.time[:1] - 1.0)
    return _changes(run.nu, run.follows) / np.where(run.follows, periods, 1.0)[:, None]


def _largest(steps: Floats) -> float:
    """Norm of the largest row; NaN when any is."""
    return float(np.linalg.norm(steps, axis=1).max())


def largest(steps: list[SwitchSteps], from_mode: int, to_mode: int) -> tuple[float, float]:
    """Largest normalised step over all switches of one kind, about the switch and while settling; or NaN.

    One that fell into a gap makes it NaN as well: the largest is not known.
    """
    of_kind = [s for s in steps if (s.from_mode, s.to_mode) == (from_mode, to_mode)]
    if not of_kind:
        return float("nan"), float("nan")
    near, late = [s.normalised for s in of_kind], [s.settling.normalised for s in of_kind]
    return float(np.max(near)), float(np.max(late))
