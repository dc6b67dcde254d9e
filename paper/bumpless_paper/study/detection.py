"""How soon, how surely and how well the autopilot finds a fault by itself: figures of one flight.

An alarm is the cycle from which an actuator counts as faulty. All times are mission time.
"""

from dataclasses import dataclass

import numpy as np

from bumpless.sim.twin import Result
from bumpless_paper.study.fly import Job, fly

SETTLED_S = 5.0  # after the alarm the estimate is taken as settled


@dataclass(frozen=True)
class Detection:
    """What became of the first fault of a flight; NaN and None for what never happened."""

    hours: float  # without a fault: the flight's time before its first fault
    false_alarms: int  # alarms on an actuator that was whole
    fault_at_s: float
    effectiveness: float  # true, at the end of the flight
    delay_s: float  # from the fault to the first alarm of any actuator; NaN: none
    isolated: bool | None  # that alarm named the faulty actuator; None: no alarm
    error: float  # mean |estimated - true| of the faulty actuator once settled
    excitation: float  # mean share of the faulty actuator's largest thrust or lift in use from the fault on


def detection_of(result: Result) -> Detection:
    """Read a flight's log, whose `effectiveness` is the truth and `effectiveness_hat` the estimate."""
    log, n = result.log, len(result.vehicle.commands)
    time, true, said = log["time"], log["effectiveness"][:, :n], log["effectiveness_hat"][:, :n]
    faults = (log["faults"][:, None] >> np.arange(n)) & 1 == 1
    raised = faults & ~np.vstack([np.zeros(n, bool), faults[:-1]])
    false = int(np.count_nonzero(raised & (true >= 1.0)))
    faulty = np.flatnonzero((true < 1.0).any(axis=0))
    if not len(faulty):
        return Detection(_hours(time[-1]), false, np.nan, 1.0, np.nan, None, np.nan, np.nan)
    i = int(faulty[0])
    start = int(np.argmax(true[:, i] < 1.0))
    command = log["u_feedback"][start:, i] / np.abs(log["u_upper"][:, i]).max()
    after = np.flatnonzero(raised[start:].any(axis=1))
    base = (_hours(time[start]), false, float(time[start]), float(true[-1, i]))
    turns = result.vehicle.commands[i].unit == "rpm"  # a screw's thrust goes with the square of its speed
    used = float(np.mean(command**2 if turns else np.abs(command)))
    if not len(after):
        return Detection(*base, np.nan, None, np.nan, used)
    alarm = start + int(after[0])
    settled = time >= min(time[alarm] + SETTLED_S, time[-1])
    error = float(np.mean(np.abs(said[settled, i] - true[settled, i])))
    right = bool(raised[alarm, i] and np.count_nonzero(raised[alarm]) == 1)
    return Detection(*base, float(time[alarm] - time[start]), right, error, used)


def _hours(seconds: float) -> float:
    return float(seconds) / 3600.0


def detection_for(job: Job) -> Detection:
    """Fly the job and read its log: picklable work of `fly_all`."""
    return detection_of(fly(job))
