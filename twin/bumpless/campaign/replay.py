"""One flight of a campaign by itself, to be flown again whole and logged."""

from dataclasses import replace
from typing import NamedTuple

from bumpless.campaign.drawn import drawn_mission, drawn_vehicle
from bumpless.campaign.mission_text import mission_text
from bumpless.campaign.plant import Alteration
from bumpless.campaign.prepared import Prepared
from bumpless.chart import with_floor
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle


class Replay(NamedTuple):
    """What `simulate` needs to fly one number of a campaign; the mission has its seed."""

    mission: Mission
    vehicle: Vehicle
    parameters: Parameters
    alteration: Alteration


def replayed(prepared: Prepared, number: int) -> Replay:
    """Flight `number`. The mission's text is that of the drawn mission: a log of it says what was flown."""
    setup, values = prepared.setup(number), prepared.values(number)
    vehicle, alteration = drawn_vehicle(setup.vehicle, values), Alteration.of(values)
    mission = replace(
        drawn_mission(setup.mission, values),
        seed=prepared.seed(number),
        summary=f"Flight {number} of campaign {prepared.campaign.name}: {alteration}",
    )
    named = f"{prepared.campaign.name}-{number}.yaml"
    text = mission_text(mission)
    flown = parse_mission(text, named, vehicle, any_vehicle=True)
    flown = with_floor(flown, mission.depth_grid)
    return Replay(flown, vehicle, setup.parameters, alteration)
