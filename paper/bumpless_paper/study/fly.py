"""Flying many scenarios on many plants: one picklable job, flown by the engine of campaigns."""

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from bumpless.campaign.engine import in_order
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.sim.twin import Result, simulate
from bumpless_paper.study.figures import Figures, figures_of
from bumpless_paper.study.learned import EARLIER, Unlearned, learned_from
from bumpless_paper.study.plants import NOMINAL, Plant
from bumpless_paper.study.scenarios import (
    FAULT_TIME_S,
    HONEST,
    SCENARIOS,
    VARIANTS,
    Overrides,
    Scenario,
    mission_of,
    parameters_of,
)


@dataclass(frozen=True)
class Job:
    """One flight: a scenario by name, a plant, a seed, and parameters laid under the scenario's own."""

    scenario: str
    seed: int = 1
    plant: Plant = NOMINAL
    extra: Overrides = field(default_factory=dict)
    vehicle: str = "ts100"
    learned: bool = False  # the plant has flown S4 before, and the vehicle's file says what its log told


@cache
def _vehicle(name: str) -> Vehicle:
    return load_vehicle(name)


def scenario_named(name: str) -> Scenario:
    """One of the seven, a variant, or one of the honest table's."""
    return next(table[name] for table in (SCENARIOS, VARIANTS, HONEST) if name in table)


@cache
def _mission(name: str) -> Mission:
    return mission_of(scenario_named(name))


def parameters_for(job: Job) -> Parameters:
    """What the autopilot of a job flies with."""
    return parameters_of(scenario_named(job.scenario), _vehicle(job.vehicle), job.extra)


def fly(job: Job) -> Result:
    """The flight of a job, whole."""
    vehicle, alter = _vehicle(job.vehicle), alteration_for(job)
    if job.learned:
        vehicle = learned_from(fly(replace(job, scenario="S4", seed=job.seed + EARLIER, learned=False)))
    return simulate(_mission(job.scenario), vehicle, parameters_for(job), job.seed, alter=alter)


def alteration_for(job: Job) -> Callable[[Any, Any], None]:
    """What makes the true plant of what the autopilot of a job takes for its vehicle."""
    return Unlearned(_vehicle(job.vehicle), job.plant) if job.learned else job.plant


def figures_for(job: Job) -> Figures:
    """The figures of a job. S1 to S4 have no fault: their post-fault figures are taken from the same time."""
    return figures_of(fly(job), job.plant.fault_time or FAULT_TIME_S)


def fly_all(
    jobs: Iterable[Job],
    work: Callable[[Job], Any] = figures_for,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> list[Any]:
    """`work` of every job, in order. workers: processes; 1 flies in this one, None uses every core.

    progress(done, total) is called as answers come in.
    """
    todo = list(jobs)
    return in_order(todo, work, min(workers or os.cpu_count() or 1, len(todo)), progress)
