"""What is asked and answered of a flight ahead; the console's TypeScript is made from it.

Times are mission times, s; columns are named and scaled as in the console's plots.
"""

from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from bumpless_server.foresight.tasks import Line

LONGEST_S = 600.0


class WhatIfRequest(BaseModel):
    """A draft, as `PUT /api/parameters` takes it, and how far ahead to fly."""

    model_config = ConfigDict(extra="forbid")
    parameters: dict[str, Any] = Field(description="all live-tunable parameters")
    horizon_s: float = Field(60.0, ge=2.0, le=LONGEST_S, allow_inf_nan=False)


class Ahead(BaseModel):
    """A change of mode on the way."""

    time_s: float
    from_: str = Field(serialization_alias="from", validation_alias="from")
    to: str


class AheadFigures(BaseModel):
    """What two flights are compared by; less is better, but for the range at the end."""

    depth_error_max_m: float
    cross_track_max_m: float
    residual_rms: float  # N and N m
    command_step_max: float  # from one cycle to the next, commands over their bounds
    saturated_share: float  # of cycles with a command at its bound
    range_end_m: float  # to the observation point


class AheadFlight(BaseModel):
    """One flight from where the vehicle was."""

    time_s: list[float]
    columns: dict[str, list[float | None]]
    mode: list[str]  # "F", "R" or "H"
    switches: list[Ahead]
    figures: AheadFigures


class WhatIf(BaseModel):
    """As it is, and with the draft; both from the same moment."""

    run: str
    from_s: float  # mission time of that moment
    revision: int  # of the parameters in force then
    as_it_is: AheadFlight
    draft: AheadFlight


class AheadTask(Line):
    """Work for the worker: what the vehicle said by topic, and the draft; messages in hex."""

    said: dict[str, str] = {}  # empty: only get ready
    draft: str = ""
    horizon_s: float = 0.0


class AheadPair(BaseModel):
    """A worker's answer; `problem` in place of flights where it can't be flown."""

    problem: str = ""
    as_it_is: AheadFlight | None = None
    draft: AheadFlight | None = None
