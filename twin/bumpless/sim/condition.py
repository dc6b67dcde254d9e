"""What a vehicle reports of its own body beside its motion; a simulated one has what its mission says."""

from typing import NamedTuple

from bumpless.config.mission import Mission


class Condition(NamedTuple):
    """As the vehicle reports it now."""

    leak: bool = False
    battery: float | None = None  # share of its charge, 0 to 1; None where nobody measures it


def condition_of(mission: Mission | None, time_s: float) -> Condition:
    """Of a simulated vehicle `time_s` into its mission."""
    condition = Condition()
    for mishap in mission.mishaps if mission is not None else ():
        if time_s < mishap.at_s:
            continue
        if mishap.what == "leak":
            condition = condition._replace(leak=True)
        else:
            condition = condition._replace(battery=mishap.battery)
    return condition
