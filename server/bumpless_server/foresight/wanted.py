"""What a planner asks for: one edit of a mission, to be foreseen."""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

MOST_FLIGHTS = 1000
LARGEST_TEXT = 200_000  # characters; the mission's reader refuses less, and says so
Component = Annotated[float, Field(ge=-5.0, le=5.0, allow_inf_nan=False)]


class Overrides(BaseModel):
    """What-if: numbers that differ from the document's."""

    model_config = ConfigDict(extra="forbid")
    parameters: dict[str, Any] = Field(
        default_factory=dict, max_length=200, description='by path: {"hover.lambda": 0.01}'
    )
    current: tuple[Component, Component, Component] | None = Field(
        None, description="NED, m/s, the way it flows, in place of the mission's"
    )
    vehicle: str | None = Field(
        None, max_length=80, pattern=r"^[A-Za-z0-9_-]+$", description="another vehicle's id"
    )


class ForesightRequest(BaseModel):
    """One request of a client of /ws/foresight. A newer one takes the place of an older one at once."""

    model_config = ConfigDict(extra="forbid")
    id: int = Field(ge=0, le=2**53, description="comes back with every answer")
    text: str = Field(max_length=LARGEST_TEXT, description="the mission's YAML, BOM and line ends and all")
    seed: int | None = Field(None, ge=0, le=2**32 - 1, description="null: the mission's own")
    flights: int = Field(0, ge=0, le=MOST_FLIGHTS, description="drawn flights after the nominal one")
    overrides: Overrides = Field(default_factory=lambda: Overrides.model_validate({}))
