"""What an operator may choose, section by section as in the parameters; each section is its module's own."""

import numpy as np

from bumpless.config.capacity import N_MODES
from bumpless.control.allocation.record import ALLOCATION_SETTINGS
from bumpless.control.guidance.record import GUIDANCE_SETTINGS
from bumpless.control.navigation import NAVIGATION_SETTINGS
from bumpless.control.supervisor import SUPERVISOR_SETTINGS
from bumpless.control.switching import MODE_SETTINGS, SWITCHING_SETTINGS

f8 = np.float64

SETTINGS = np.dtype(
    [
        ("dt", f8),  # control period, s
        ("supervisor", SUPERVISOR_SETTINGS),
        ("bumpless", SWITCHING_SETTINGS),
        ("allocation", ALLOCATION_SETTINGS),
        ("guidance", GUIDANCE_SETTINGS),
        ("navigation", NAVIGATION_SETTINGS),
        ("modes", MODE_SETTINGS, (N_MODES,)),  # of FORWARD, REVERSE, HOVER: modes[mode - FORWARD]
    ],
    align=True,
)
