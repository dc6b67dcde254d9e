"""What foresight answers, one model per kind of message; the console's TypeScript is made from them.

All messages carry the `id` of the request. Positions are NED, m; series have one value per shown cycle.
"""

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field


class Told(BaseModel):
    """Every field is always there."""

    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class ForesightProblem(Told):
    """A rule of the format that the text breaks, with its place."""

    line: int  # 1-based; 0: no place of its own
    column: int
    field: str
    value: str
    rule: str
    message: str  # all of it in one line


class ForesightMend(Told):
    """A change of the document that mends a finding."""

    label: str  # for the button: "Approach at 92°"
    path: str  # of the field to set: "target.heading_deg"
    value: float | int | str | bool | list[float] | None


class ForesightFinding(Told):
    """What of the plan can't work (hard) or is unlikely to (soft), and what would mend it."""

    severity: Literal["hard", "soft"]
    code: str  # "current_not_holdable"
    path: str  # of the field: "legs[0].speed_mps"
    line: int  # of the field, or of the nearest part around it
    column: int
    reason: str
    change: str  # the nearest change in words; "" where none is known
    mends: list[ForesightMend]


class ForesightTrack(Told):
    """The flight's truth, at most 600 cycles of it."""

    t_s: list[float]
    north_m: list[float]
    east_m: list[float]
    depth_m: list[float]
    heading_deg: list[float]  # -180 to 180
    mode: list[str]  # "F", "R" or "H"
    speed_m_s: list[float]  # over ground
    depth_error_m: list[float]  # positive: too deep
    saturation: list[float]  # the most used command over its bound, 0 to 1
    worst_actuator: list[str]  # whose command that is
    margin: list[float]  # the part of the attainable set that the demand leaves, 0 to 1
    floor_m: list[float | None]  # depth of the sea floor below; null: unknown; empty: the mission names none
    clearance_m: list[float | None]  # from the hull's lowest point to the floor


class ForesightSwitch(Told):
    """A change of mode."""

    t_s: float
    from_: str = Field(serialization_alias="from", validation_alias="from")
    to: str


class ForesightErrors(Told):
    """Against the observation point and the approach heading."""

    position_m: float
    horizontal_m: float
    depth_m: float
    heading_deg: float
    speed_mps: float


class ForesightOutcome(Told):
    """How the flight ended: the fields of `bumpless.Outcome`."""

    ending: str
    reason: str
    basis: str
    mode: str
    held_s: float
    closest_m: float | None
    closest_s: float | None
    true_errors: ForesightErrors | None
    believed_errors: ForesightErrors | None
    tries: int


class ForesightProblems(Told):
    """The text can't be read; the last message of its request."""

    id: int
    kind: Literal["problems"] = "problems"
    problems: list[ForesightProblem]


class ForesightFloor(Told):
    """The sea floor along the planned legs, at most 600 places of them."""

    along_m: list[float]  # from the start, in the plane
    north_m: list[float]
    east_m: list[float]
    depth_m: list[float]  # of the plan
    floor_m: list[float | None]  # null: unknown
    wanted_m: float  # least clearance that the mission asks for
    least_m: float | None  # clearance of the plan, hull below its axis included


class HeldArc(Told):
    """Headings that hold station alike, from the first clockwise to the last; the whole circle: 0 to 359."""

    zone: Literal["accepted", "warned", "refused"]
    from_deg: float
    to_deg: float


class HeldStation(Told):
    """On which headings station is held before the target in a current, by the rule of the check."""

    current_ned_mps: list[float]  # the way it flows
    arcs: list[HeldArc]
    heading_deg: float  # that the vehicle would take, or has taken
    zone: Literal["accepted", "warned", "refused"]  # of that heading
    reason: str  # why not, or why not surely; "" where it is accepted


class ForesightFindings(Told):
    """What stands against the plan, hard ones first."""

    id: int
    kind: Literal["findings"] = "findings"
    findings: list[ForesightFinding]
    floor: ForesightFloor | None  # null: the mission names no sea floor, or it is not known
    station: HeldStation | None  # null: the vehicle only passes its target by


class ForesightNominal(Told):
    """The flight of the plan as it stands: equal, to the bit, to `bumpless run` of the same text and seed."""

    id: int
    kind: Literal["nominal"] = "nominal"
    track: ForesightTrack
    switches: list[ForesightSwitch]
    outcome: ForesightOutcome
    arrival_s: float | None  # first time in hover; null: never
    energy_j: float  # at the shafts
    length_m: float  # of the way flown
    least_clearance_m: float | None  # above the sea floor; null: not known
    sha256: str  # of the text's bytes
    seed: int
    tuned: bool  # flown with what the operator tuned the vehicle with, not with its defaults
    digest: str  # of every logged column: what another flight of the plan is compared with
    elapsed_ms: float  # from the request's arrival in the worker to this message


class ForesightFlight(Told):
    """One drawn flight: how it ended and at most 60 points of its way."""

    number: int  # of its draw
    seed: int
    outcome: str
    end_s: float
    closest_m: float  # the nose, to the marker
    clearance_m: float | None  # least, above the sea floor; null: not known
    north_m: list[float]
    east_m: list[float]
    depth_m: list[float]


class ForesightChance(Told):
    """Share of the flights so far that docked, with its Wilson interval of 95 %."""

    docked: int
    of: int
    low: float
    high: float
    counts: dict[str, int]  # by outcome


class ForesightFan(Told):
    """Flights that were not told before, and the chance by all so far."""

    id: int
    kind: Literal["fan"] = "fan"
    flights: list[ForesightFlight]
    done: int
    of: int
    chance: ForesightChance


class ForesightDone(Told):
    """Nothing more comes for this request."""

    id: int
    kind: Literal["done"] = "done"


class ForesightFailed(Told):
    """The request could not be carried out; the last message of its request."""

    id: int
    kind: Literal["failed"] = "failed"
    reason: str


ForesightMessage = Annotated[
    ForesightProblems | ForesightFindings | ForesightNominal | ForesightFan | ForesightDone | ForesightFailed,
    Field(discriminator="kind"),
]
