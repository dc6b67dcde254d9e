"""A campaign as its file declares it."""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, FiniteFloat

from bumpless.campaign.distributions import Distribution
from bumpless.config.mission.fields import NAME

VERSION = 1
MOST = 10_000_000  # flights

Positive = Annotated[FiniteFloat, Field(gt=0)]
Count = Annotated[int, Field(ge=1, le=MOST)]


class Strict(BaseModel):
    """Unknown fields are refused, nothing is changed later."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class Docked(Strict):
    """What counts as docked: in hover, this close to the true observation point, for so long."""

    range_m: Positive = 0.15  # over three axes
    heading_deg: Positive = 5.0
    speed_mps: Positive = 0.05  # over ground
    hold_s: Positive = 10.0
    touch_m: Annotated[FiniteFloat, Field(ge=0)] = 0.3  # the nose closer to the marker than this collides


class Search(Strict):
    """One parameter that tuning may change, `hover.kd[5]` for one number of a row."""

    low: FiniteFloat
    high: FiniteFloat
    log: bool = False


class Weights(Strict):
    """How much each part of the score counts; see `bumpless.campaign.tune.score`."""

    tracking: Annotated[FiniteFloat, Field(ge=0)] = 100.0
    smoothness: Annotated[FiniteFloat, Field(ge=0)] = 10.0
    cost: Annotated[FiniteFloat, Field(ge=0)] = 1.0


class Tune(Strict):
    """A search over parameters: trials on the campaign's flights, the best once on flights never seen."""

    trials: Annotated[int, Field(ge=1, le=100_000)]
    held_out: Count  # flights after the campaign's own, flown once with the best parameters
    search: Annotated[dict[str, Search], Field(min_length=1)]
    weights: Weights = Weights()
    seed: Annotated[int, Field(ge=0)] = 1  # of the sampler


class Campaign(Strict):
    """Many flights: which missions, how many, and what differs between them.

    Flight `i` flies mission `i` modulo their number with draw `i`, the same whatever else is flown.
    """

    version: Annotated[int, Field(ge=VERSION, le=VERSION)]
    name: Annotated[str, Field(pattern=rf"^(?:{NAME})$")]
    title: str = ""
    summary: str = ""
    missions: Annotated[tuple[str | dict[str, Any], ...], Field(min_length=1)]  # files, names or whole
    vehicle: str | None = None  # id or file; None: each mission's own
    parameters: dict[str, Any] = {}  # over the mission's
    parameters_file: str | None = None  # TOML, as `bumpless tune` writes it; under `parameters`
    count: Count
    seed: Annotated[int, Field(ge=0)]
    docked: Docked = Docked()
    draw: dict[str, Distribution] = {}
    tune: Tune | None = None
