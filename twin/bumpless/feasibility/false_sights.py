"""Does a vehicle that gets false sights or false replies pass over them?"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.feasibility.finding import SOFT, Finding, Mend
from bumpless.sim.settings import sensors_of

GATE_M = 1.0  # a fix farther off counts only when others agree


def check_false_sights(mission: Mission, vehicle: Vehicle, parameters: Parameters) -> Iterator[Finding]:
    """With every fix believed one false sight in a hundred leads the vehicle away, metres up or down."""
    sensors: Any = sensors_of(vehicle, mission).view(np.recarray)[0]
    replies = float(sensors.usbl_outlier) if sensors.usbl_period > 0 else 0.0
    share = max(float(sensors.camera_outlier), replies)
    if share == 0.0 or mission.sensors.noise_scale == 0.0 or parameters.navigation.fix_gate_m > 0.0:
        return
    field = "parameters.navigation.fix_gate_m"
    text = (
        f"{vehicle.id} believes every fix, of which up to {100.0 * share:g} % are false: each leads it away."
    )
    change = f"Pass over a fix that is more than {GATE_M:g} m off until others agree."
    yield Finding(SOFT, "false_sights", field, text, change, (Mend(field, GATE_M, f"Gate of {GATE_M:g} m"),))
