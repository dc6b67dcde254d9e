"""A drawn flight of a mission as a sketch: how it ended and a few points of its way, for a fan of many."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.drawn import drawn_mission
from bumpless.campaign.flight import BLOCK, Hangar
from bumpless.campaign.geometry import nose_clearance
from bumpless.campaign.outcome import Decided, Judge
from bumpless.campaign.plant import Alteration
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import load_campaign
from bumpless.config.mission import missions_folder
from bumpless.sim.twin import Twin


@dataclass(frozen=True)
class Sketch:
    """One drawn flight."""

    number: int
    seed: int
    decided: Decided
    end_s: float  # mission time at which it was decided
    closest_m: float  # the true nose, to the true marker
    path_ned_m: npt.NDArray[np.float64]  # (n, 3), the true way, first and last place among them


@cache
def foresight_campaign() -> Campaign:
    """What differs between the flights of a mission that is being planned: the shipped declaration."""
    return load_campaign(missions_folder() / "campaigns" / "foresight.yaml").campaign


def sketch(prepared: Prepared, number: int, hangar: Hangar, points: int) -> Sketch:
    """Fly one number of a campaign up to where it is decided, with at most `points` places of its way.

    The flight is that of `fly_number` and of `bumpless run --draw`.
    """
    setup, values, seed = prepared.setup(number), prepared.values(number), prepared.seed(number)
    mission = drawn_mission(setup.mission, values)
    twin = hangar.twin(setup.vehicle, setup.parameters, values)
    twin.start(mission, seed, setup.parameters, Alteration.of(values))
    judge = Judge(mission, twin.vehicle, prepared.campaign.docked)
    log, decided = _flown(twin, judge, hangar.log(twin.cycles))
    twin.drain_events()
    shown = np.unique(np.linspace(0, len(log) - 1, min(points, len(log))).round().astype(int))
    closest = float(nose_clearance(log, mission, twin.vehicle).min())
    path = np.array(log["eta"][shown, :3])
    return Sketch(number, seed, decided, float(log["time"][-1]), closest, path)


def _flown(twin: Twin, judge: Judge, log: npt.NDArray) -> tuple[npt.NDArray, Decided]:
    begun, filled = twin.phase, 0
    while filled < len(log) and twin.phase == begun:
        filled += twin.fly(log[filled : filled + BLOCK])
        decided = judge.look(log[:filled])
        if decided is not None:
            return log[: decided.rows], decided
    return log[:filled], judge.over(log[:filled])
