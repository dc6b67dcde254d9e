"""A campaign as its file declares it."""

from dataclasses import KW_ONLY, dataclass, field
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from bumpless.campaign.distributions import Distribution
from bumpless.config.declare import Entries, Number, Overrides, Part, Switch, Text, model
from bumpless.config.declare.notes import in_words
from bumpless.config.mission.model import short_name
from bumpless.config.parameters import Parameters
from bumpless.metrics.outcome import DOCKED, Limits

VERSION = 1
MOST = 10_000_000  # flights
LARGEST_SEED = 2**32 - 1


@dataclass(frozen=True)
class Missions(Entries):
    """A list of missions: names, files or whole ones."""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Texts or tables; what is in a table is for the mission's own reader."""
        one = core_schema.union_schema([core_schema.str_schema(strict=True), core_schema.dict_schema()])
        items = in_words(one, lambda _: "must be a mission's name, its file, or a whole mission")
        rows = core_schema.tuple_variable_schema(items)
        return core_schema.no_info_before_validator_function(self._counted, rows)


@dataclass(frozen=True)
class Named(Part):
    """Parts by name, at least `fewest` of them; the names are the file's own."""

    _: KW_ONLY
    fewest: int = 0

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """A table of parts."""
        schema = handler(kind)
        return {**schema, "min_length": self.fewest} if self.fewest else schema  # type: ignore[return-value]


def weight(label: str) -> Number:
    """How much a part of the score counts."""
    return Number(label, "", 0.0)


@model
class Docked:
    """What counts as docked: in hover, this close to the true observation point, for so long at the end."""

    range_m: Annotated[float, Number("Distance over three axes", "m", above=0.0)] = DOCKED.position_m
    heading_deg: Annotated[float, Number("Angle off the approach heading", "deg", above=0.0)] = (
        DOCKED.heading_deg
    )
    speed_mps: Annotated[float, Number("Speed over ground", "m/s", above=0.0)] = DOCKED.speed_mps
    hold_s: Annotated[float, Number("How long without a break, up to the flight's end", "s", above=0.0)] = (
        DOCKED.hold_s
    )

    @property
    def limits(self) -> Limits:
        """For the judge of runs."""
        return Limits(self.range_m, self.heading_deg, self.speed_mps, self.hold_s)


@model
class Search:
    """One parameter that tuning may change, `hover.kd[5]` for one number of a row."""

    low: Annotated[float, Number("Smallest value tried")]
    high: Annotated[float, Number("Largest value tried")]
    log: Annotated[bool, Switch("Try every factor alike, not every difference")] = False
    start: Annotated[
        float | None, Number("Where the search begins, so that it can be done again; else as flown now")
    ] = None


@model
class Weights:
    """How much each part of the score counts; see `bumpless.campaign.tune.score`."""

    tracking: Annotated[float, weight("Weight of the tracking errors")] = 100.0
    smoothness: Annotated[float, weight("Weight of the largest step at a switch")] = 10.0
    cost: Annotated[float, weight("Weight of the energy")] = 1.0


@model
class Tune:
    """A search over parameters: trials on the campaign's flights, the best once on flights never seen."""

    trials: Annotated[int, Number("Trials", "", 1, 100_000)]
    held_out: Annotated[
        int,
        Number("Flights after the campaign's own, flown with the first and the best values", "", 1, MOST),
    ]
    search: Annotated[dict[str, Search], Named("Parameters to search, by their paths", fewest=1)]
    weights: Annotated[Weights, Part("Weights of the score's parts")] = Weights()
    seed: Annotated[int, Number("Seed of the sampler", "", 0, LARGEST_SEED)] = 1


@model
class Campaign:
    """Many flights: which missions, how many, and what differs between them.

    Flight `i` flies mission `i` modulo their number with draw `i`, the same whatever else is flown.
    """

    version: Annotated[int, Number("Version of this format", "", VERSION, VERSION)]
    name: Annotated[str, short_name("Short name")]
    missions: Annotated[
        tuple[str | dict[str, Any], ...],
        Missions("Missions: names of shipped ones, files beside the campaign, or whole", fewest=1, most=1000),
    ]
    count: Annotated[int, Number("Flights", "", 1, MOST)]
    seed: Annotated[int, Number("Seed of every draw", "", 0, LARGEST_SEED)]
    title: Annotated[str, Text("Title for people")] = ""
    summary: Annotated[str, Text("What it is for, in a sentence or two")] = ""
    vehicle: Annotated[str | None, Text("Vehicle id or file; each mission's own if left out")] = None
    parameters: Annotated[
        dict[str, Any], Overrides("Control parameters over the missions' own", of=Parameters)
    ] = field(default_factory=dict)
    parameters_file: Annotated[
        str | None, Text("TOML as `bumpless tune` writes it; `parameters` lies over it")
    ] = None
    docked: Annotated[Docked, Part("What counts as docked")] = Docked()
    draw: Annotated[
        dict[str, Distribution],
        Named("Quantities that differ, by name: each one value, or a table of one of these"),
    ] = field(default_factory=dict)
    tune: Annotated[Tune | None, Part("What `bumpless tune` searches")] = None
