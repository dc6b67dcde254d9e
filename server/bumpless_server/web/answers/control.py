"""Who holds control, and who one is, as the API tells it."""

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.answers.contract import Answer, model_of

RoleName = Literal["observer", "operator", "engineer"]


class ControlHolder(model_of(pb.ControlHolder)):
    """Who alone may start, resume and tune the vehicle; pause and abort are open to every operator."""


class Me(Answer):
    """Who asks, as the server knows it."""

    accounts: bool  # people log in here
    name: str  # of the account; "" without accounts
    shown: str  # for others' eyes
    role: RoleName
    client: str  # as in `holder` of ControlHolder


class AskForControl(BaseModel):
    """Ask the holder for control; given at once where nobody has it."""

    model_config = ConfigDict(extra="forbid")
    reason: str = Field("", max_length=200)


class TakeControl(BaseModel):
    """Take control from its holder."""

    model_config = ConfigDict(extra="forbid")
    reason: str = Field(min_length=3, max_length=200, description="why; everybody reads it")


class ForClient(BaseModel):
    """Somebody by its public id."""

    model_config = ConfigDict(extra="forbid")
    client: str = Field(max_length=40)
