"""A LOG row as the contract's messages: SI and radians inside, degrees and rpm at this edge.

The vehicle node and the log of `bumpless run` both go through here, so the same row gives the same
bytes wherever it is told. `messages` is what every control cycle says, `Teller` adds what is said more
rarely, `run_messages` is all of a finished simulation in the order in which it was flown.
"""

from bumpless.telemetry.context import Context, make_context
from bumpless.telemetry.cycle import messages
from bumpless.telemetry.replay import run_messages
from bumpless.telemetry.status import (
    FlightState,
    description,
    event,
    mission_status,
    parameters_status,
    parameters_text,
    plan,
    problem_messages,
    run_id,
)
from bumpless.telemetry.teller import Teller

__all__ = [
    "Context",
    "FlightState",
    "Teller",
    "description",
    "event",
    "make_context",
    "messages",
    "mission_status",
    "parameters_status",
    "parameters_text",
    "plan",
    "problem_messages",
    "run_id",
    "run_messages",
]
