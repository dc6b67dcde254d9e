"""After a crash in flight the new node does what was declared, and is not idle by accident."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from bumpless.node.flight import Flight
from bumpless.node.loop import ControlLoop, Handoff
from bumpless.node.memory import Left

if TYPE_CHECKING:
    from bumpless.config.mission import Mission
    from bumpless.config.vehicle import Vehicle

ANSWER_S = 2.0


def come_back(left: Left, vehicle: "Vehicle", flight: Flight, loop: ControlLoop) -> str:
    """Have the loop react to the flight that was left; what is done, in words.

    What can't be read any more leaves the actuators at rest, which is said.
    """
    from bumpless.config.parameters import with_overrides
    from bumpless.config.problems import ProblemsError

    reaction = vehicle.failsafe.after_crash
    try:
        mission = where_it_was(left, vehicle)
        parameters = with_overrides(flight.chosen, mission.parameters)
    except ProblemsError as error:
        return f"run {left.run_id} crashed and can't be read any more, the actuators rest: {error}"
    handoff = Handoff(
        "failsafe", lambda f: f.come_back(mission, left.seed, parameters, left.run_id, reaction)
    )
    return loop.submit(handoff).reply(ANSWER_S).reason


def where_it_was(left: Left, vehicle: "Vehicle") -> "Mission":
    """Its mission, begun where the vehicle was last known to be, at rest.

    Raises ProblemsError. A simulated vehicle is put there; a real one is there.
    """
    from bumpless.config.mission import parse_mission

    mission = parse_mission(left.mission_yaml, left.file_name, vehicle)
    north, east, down = left.position_ned_m
    start = replace(
        mission.start,
        position_ned_m=(north, east, max(down, 0.0)),
        heading_deg=math.degrees(left.heading_rad),
        speed_mps=0.0,
    )
    return replace(mission, start=start)
