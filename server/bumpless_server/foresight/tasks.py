"""What the server and a worker say to each other: one line of JSON each way at a time.

A task goes down as a line; answers come up as pairs of lines, a head and a body, the last one's head with
`end`. A line that arrives while a worker flies gives up the task it flies, whatever it says.
"""

from typing import Literal

from pydantic import BaseModel

from bumpless_server.foresight.wanted import ForesightRequest

Kind = Literal["warm", "nominal", "findings", "fan"]
Told = Literal["problems", "nominal", "findings", "flights", "ahead", "none"]  # none: an empty body


class GivenUp(Exception):
    """Something newer waits."""


class Line(BaseModel):
    """Work for one worker, on its line down."""

    number: int  # of the task, for the server's own order


class Task(Line):
    """Work on a mission that is being planned."""

    kind: Kind
    request: ForesightRequest | None = None
    present: str = ""  # the vehicle on the bus, TOML; "" when it has not described itself
    tuned: str = ""  # what the operator tuned it with: a bumpless.Parameters in hex
    first: int = 0  # of a fan's flights
    count: int = 0


class Head(BaseModel):
    """What the next line is."""

    number: int
    kind: Told = "none"
    end: bool = False
    failed: str = ""  # why, when it could not be done
    given_up: bool = False  # for a newer line
