"""Drawn flights of a plan: what the current, the plant, the sensors and the target's place leave open."""

from collections.abc import Iterator
from dataclasses import replace
from typing import cast

from bumpless.campaign.flight import Hangar
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.sketch import Sketch, foresight_campaign, sketch
from bumpless_server.foresight.plan import Plan
from bumpless_server.foresight.told import ForesightFlight

POINTS = 60


def prepared(plan: Plan) -> Prepared:
    """The fan's campaign with this plan for its mission; the plan's seed is that of the draws.

    They are spread evenly, so that 200 flights tell the chance better than 200 at random would.
    """
    campaign = replace(foresight_campaign(), seed=plan.mission.seed)
    return Prepared(campaign, (Setup(plan.mission, plan.vehicle, plan.parameters),), even=True)


def fly(fan: Prepared, first: int, count: int, hangar: Hangar) -> Iterator[ForesightFlight]:
    """Flights `first` to `first + count` of the fan, one after the other."""
    for number in range(first, first + count):
        yield _told(sketch(fan, number, hangar, POINTS))


def _told(flown: Sketch) -> ForesightFlight:
    path = flown.path_ned_m.round(2)
    return ForesightFlight(
        number=flown.number,
        seed=flown.seed,
        outcome=flown.outcome.ending.value,
        end_s=flown.end_s,
        closest_m=cast("float", flown.outcome.closest_m),  # a twin knows the truth
        clearance_m=None if flown.clearance_m is None else round(flown.clearance_m, 2),
        north_m=path[:, 0].tolist(),
        east_m=path[:, 1].tolist(),
        depth_m=path[:, 2].tolist(),
    )
