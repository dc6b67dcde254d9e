"""Fly a mission as fast as the machine can, and open what was flown before. The public face."""

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from bumpless.config.mission import Mission, MissionError, missions_folder, parse_mission
from bumpless.config.parameters import ParameterError, Parameters, check, default_parameters, with_overrides
from bumpless.config.problems import Problem
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.runs.flown import Flown
from bumpless.runs.run import Run

GIVEN = "parameters"  # the file that problems of given parameters name
Alter = Callable[[Any, Any], None]
Overrides = Mapping[str, Mapping[str, Any]]  # section -> key -> value, as in a mission's `parameters`


def load_mission(source: str | Path, vehicle: Vehicle | None = None) -> Mission:
    """The mission of a file, or the one that ships under that name, such as "docking".

    It is checked against `vehicle`, which may be another than the one it asks for; without, against that one.
    A depth grid that it names is taken from its folder, where it lies there as an ESRI ASCII grid.
    Raises MissionError with every problem and its place, OSError when the file cannot be read.
    """
    from bumpless.chart.beside import beside
    from bumpless.chart.grid import NotAGrid

    path = Path(source)
    if not path.suffix and not path.exists():
        path = missions_folder() / f"{source}.yaml"
    mission = parse_mission(path.read_bytes(), str(path), vehicle, any_vehicle=vehicle is not None)
    try:
        mission = beside(mission, path.parent)
    except NotAGrid as error:
        raise MissionError([Problem(path.name, None, None, "sea_floor.grid", None, str(error))]) from error
    return replace(mission, source=path.name)


def fly(
    mission: Mission | str | Path,
    vehicle: Vehicle | str | None = None,
    *,
    seed: int | None = None,
    parameters: Parameters | Overrides | None = None,
    started_ns: int | None = None,
    progress: Callable[[float], None] | None = None,
    alter: Alter | None = None,
) -> Run:
    """Fly a mission to its end with the simulated vehicle.

    mission: or its file or name, see `load_mission`. vehicle: or its id or file; the mission's own when None.
    seed: of every random number; the mission's own when None. parameters: all of them, or those that shall
    differ from the vehicle's and the mission's, {"hover": {"lambda": 0.01}}. started_ns: UNIX time of mission
    time 0; now when None. progress: called with the share flown. alter: changes the records of the true
    vehicle and of the truth in place; the autopilot learns nothing of it.

    The same arguments give the same flight to the bit, but for measured solve times.
    Raises MissionError, VehicleError or ParameterError with every problem.
    """
    from bumpless.sim.twin import simulate

    who = load_vehicle(vehicle) if isinstance(vehicle, str) else vehicle
    flown = mission if isinstance(mission, Mission) else load_mission(mission, who)
    who = who or load_vehicle(flown.vehicle)
    chosen = _parameters(who, flown, parameters)
    result = simulate(flown, who, chosen, seed, progress, alter)
    return Run(Flown(result, time.time_ns() if started_ns is None else started_ns))


def open_run(path: str | Path) -> Run:
    """The run of a log (MCAP), whole or cut off. Needs the extra `log`.

    Raises ValueError when the file is no MCAP, OSError when it cannot be read.
    """
    from bumpless.contract.extras import imported

    imported("mcap", "log")
    from bumpless.runs.read import check_log
    from bumpless.runs.recorded import Recorded

    found = Path(path)
    check_log(found)
    return Run(Recorded(found))


def _parameters(vehicle: Vehicle, mission: Mission, given: Parameters | Overrides | None) -> Parameters:
    if not isinstance(given, Parameters):
        own = with_overrides(default_parameters(vehicle), mission.parameters)
        try:
            given = with_overrides(own, given or {})
        except ParameterError as error:
            raise ParameterError([replace(problem, file=GIVEN) for problem in error.problems]) from error
    problems = check(given, vehicle, GIVEN)
    if problems:
        raise ParameterError(problems)
    return given
