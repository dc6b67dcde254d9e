"""A drawn flight of a mission as a sketch: how it ended and a few points of its way, for a fan of many."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.drawn import drawn_mission
from bumpless.campaign.flight import Hangar
from bumpless.campaign.plant import Alteration
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import load_campaign
from bumpless.chart import floor_of
from bumpless.config.mission import missions_folder
from bumpless.metrics import Outcome, outcome_of
from bumpless.metrics.dock import body_of
from bumpless.metrics.floor import least_clearance


@dataclass(frozen=True)
class Sketch:
    """One drawn flight."""

    number: int
    seed: int
    outcome: Outcome
    end_s: float  # how long it lasted
    clearance_m: float | None  # least above the sea floor; None: not known
    path_ned_m: npt.NDArray[np.float64]  # (n, 3), the true way, first and last place among them


@cache
def foresight_campaign() -> Campaign:
    """What differs between the flights of a mission that is being planned: the shipped declaration."""
    return load_campaign(missions_folder() / "campaigns" / "foresight.yaml").campaign


def sketch(prepared: Prepared, number: int, hangar: Hangar, points: int) -> Sketch:
    """Fly one number of a campaign, with at most `points` places of its way.

    The flight and its outcome are those of `fly_number` and of `bumpless run --draw`.
    """
    setup, values, seed = prepared.setup(number), prepared.values(number), prepared.seed(number)
    mission = drawn_mission(setup.mission, values)
    twin = hangar.twin(setup.vehicle, setup.parameters, values)
    vehicle = twin.vehicle
    twin.start(mission, seed, setup.parameters, Alteration.of(values))
    flown = hangar.gatherer.fly(twin)
    twin.drain_events()
    columns = flown.as_told([c.unit for c in vehicle.commands])
    body, limits = body_of(mission.target), prepared.campaign.docked.limits
    floor = floor_of(mission)
    outcome = outcome_of(columns, vehicle, "completed", body=body, limits=limits, floor=floor)
    shown = np.unique(np.linspace(0, len(flown) - 1, min(points, len(flown))).round().astype(int))
    lasted_s = float(flown.time[-1] - flown.time[0]) + vehicle.control_period_s
    clear = least_clearance(columns.eta, vehicle, floor)
    return Sketch(number, seed, outcome, lasted_s, clear, np.array(flown.eta[shown, :3]))
