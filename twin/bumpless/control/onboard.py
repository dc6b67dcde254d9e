"""All that is on board: what the autopilot may know, what it remembers, and what it says.

One record, handed to `autopilot_cycle` with the measurement: what is true of a simulated flight besides is
not in it and so cannot be named.

- `state` is all that a cycle leaves to the next. Reset fills it, linearisation disturbs it.
- `output` is said anew in each cycle that is flown; nothing of it is read by the next.
- `scratch` means nothing between cycles.
"""

import numpy as np

from bumpless.control.allocation.record import (
    ALLOCATION_STATE,
    ALLOCATION_WORK,
    PROBLEM,
    SOLUTION,
)
from bumpless.control.docking.record import DOCKING_OUTPUT, DOCKING_STATE
from bumpless.control.effectiveness.record import BELIEF, ESTIMATOR, ESTIMATOR_WORK
from bumpless.control.guidance.record import GUIDANCE_OUTPUT, GUIDANCE_STATE, SITUATION
from bumpless.control.navigation import CLOCK, NAVIGATION_OUTPUT, NAVIGATION_STATE
from bumpless.control.pid import ERRORS, PID_STATE
from bumpless.control.plan import PLAN
from bumpless.control.schedule import GAINS
from bumpless.control.settings import SETTINGS
from bumpless.control.supervisor import SUPERVISOR_STATE
from bumpless.control.switching import SWITCHING_OUTPUT, SWITCHING_STATE
from bumpless.physics.model_record import MODEL
from bumpless.physics.sensors import SENSORS

f8, i8 = np.float64, np.int64

ORDERS = np.dtype(
    [
        ("phase", i8),  # IDLE, RUNNING, PAUSED, COMPLETED or ABORTED; a cycle may complete a mission
        ("change", i8),  # 1: other parameters or another phase since the last cycle, so a ramp begins
        ("hold_point", f8, 4),  # where to stay while PAUSED or COMPLETED: NED and heading
    ],
    align=True,
)

STATE = np.dtype(
    [
        ("clock", CLOCK),
        ("navigation", NAVIGATION_STATE),
        ("supervisor", SUPERVISOR_STATE),
        ("guidance", GUIDANCE_STATE),
        ("pid", PID_STATE),
        ("switching", SWITCHING_STATE),
        ("allocation", ALLOCATION_STATE),
        ("belief", BELIEF),
        ("estimator", ESTIMATOR),
        ("docking", DOCKING_STATE),
    ],
    align=True,
)

OUTPUT = np.dtype(
    [
        ("navigation", NAVIGATION_OUTPUT),
        ("situation", SITUATION),
        ("guidance", GUIDANCE_OUTPUT),
        ("errors", ERRORS),
        ("gains", GAINS),
        ("tau_plus", f8, 6),  # PID of the active mode before the ramp
        ("switching", SWITCHING_OUTPUT),
        ("problem", PROBLEM),
        ("solution", SOLUTION),
        ("docking", DOCKING_OUTPUT),
    ],
    align=True,
)

SCRATCH = np.dtype([("allocation", ALLOCATION_WORK), ("estimator", ESTIMATOR_WORK)], align=True)

ONBOARD = np.dtype(
    [
        ("settings", SETTINGS),
        ("sensors", SENSORS),
        ("model", MODEL),
        ("plan", PLAN),
        ("orders", ORDERS),
        ("state", STATE),
        ("output", OUTPUT),
        ("scratch", SCRATCH),
    ],
    align=True,
)
