"""A counterfactual: a run's mission flown again with other numbers, another allocator or another vehicle."""

from collections.abc import Mapping
from math import degrees
from typing import Any

import numpy as np
import yaml

from bumpless.campaign.mission_text import as_yaml
from bumpless.campaign.parameter_path import changes_of
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import ParameterError, Parameters, check, default_parameters, with_overrides
from bumpless.config.problems import Problem
from bumpless.config.text import BOM
from bumpless.config.vehicle import Vehicle
from bumpless.runs.flight import fly
from bumpless.runs.run import Run

SETTLED_S = 10.0  # after so long an estimate of the current counts, where there is as much


def refly(
    run: Run,
    changes: Mapping[str, Any] | None = None,
    vehicle: Vehicle | None = None,
    seed: int | None = None,
    as_seen: bool | None = None,
) -> Run:
    """Fly it again, with `changes` by path ({"hover.lambda": 0.01}) of what it was flown with.

    vehicle: another one; its own defaults and the mission's overrides then take the place of the run's
    parameters. as_seen: with the current and the target that the vehicle believed in and from where it began,
    instead of what the mission says; by default for a run whose truth nobody knows, such as a real vehicle's.

    Raises ValueError where the log tells no mission or no vehicle, ParameterError or MissionError for what
    can't be flown.
    """
    mission, own = run.mission, run.vehicle
    if mission is None or own is None:
        raise ValueError("the log tells no mission or no vehicle that could be flown again")
    who = vehicle or own
    if vehicle is not None and vehicle.id != own.id:
        mission = _for_another(mission, vehicle)
    if as_seen if as_seen is not None else not knows_truth(run):
        mission = seen(run, mission, who)
    parameters = _changed(_base(run, mission, who), changes or {}, who)
    return fly(mission, who, seed=run.info.seed if seed is None else seed, parameters=parameters)


def knows_truth(run: Run) -> bool:
    """Whether the log tells what was true, as that of a simulated vehicle does."""
    return bool(np.isfinite(run.columns.eta).all())


def seen(run: Run, mission: Mission, vehicle: Vehicle) -> Mission:
    """The mission in the world that its vehicle saw: mean current, the target's last and its own first place.

    Waves, gusts and noise of the mission's sensors stay as they are; the text is the mission's that is given
    back. Raises ValueError without a cycle, MissionError for what no mission may hold.
    """
    columns = run.columns
    if not len(columns):
        raise ValueError("the log holds no cycle of a mission")
    current = _current(run)
    believed = columns.target[-1, :3]
    planned = np.array(mission.target.position_ned_m)
    start = columns.eta_hat[0]
    table = yaml.safe_load(mission.text.removeprefix(BOM)) or {}
    sea = {name: told for name, told in table.get("environment", {}).items() if name != "current_profile"}
    table["environment"] = sea | {"current_ned_mps": _three(current)}
    table["target"] |= {"true_offset_ned_m": _three(believed - planned)}
    table["start"] |= {
        "position_ned_m": _three(start[:3]),
        "heading_deg": round(degrees(start[5]), 4),
        "speed_mps": round(max(0.0, float(columns.nu_r_hat[0, 0])), 4),
    }
    return parse_mission(as_yaml(table), f"{mission.name}.yaml", vehicle, any_vehicle=True)


def _current(run: Run) -> np.ndarray:
    """Mean of the current as estimated, NED, m/s."""
    time, found = [], []
    for topic, message in run.messages():
        if topic == "tlm/navigation":
            told: Any = message
            at = told.current_estimate_ned_mps
            time.append(told.stamp.mission_time_s)
            found.append((at.x, at.y, at.z))
    table, when = np.array(found), np.array(time)
    settled = table[when - when[0] >= min(SETTLED_S, 0.5 * (when[-1] - when[0]))]
    return np.nan_to_num(settled.mean(axis=0))


def _three(values: np.ndarray) -> tuple[float, float, float]:
    n, e, d = (round(float(value), 4) for value in values)
    return n, e, d


def _for_another(mission: Mission, vehicle: Vehicle) -> Mission:
    """The mission checked against another vehicle, without what names parts of the first."""
    from bumpless.config.mission import parse_mission

    return parse_mission(mission.text, mission.source or "mission.yaml", vehicle, any_vehicle=True)


def _base(run: Run, mission: Mission, vehicle: Vehicle) -> Parameters:
    own = run.parameters
    if own is not None and run.vehicle is not None and run.vehicle.id == vehicle.id:
        return own
    return with_overrides(default_parameters(vehicle), mission.parameters)


def _changed(parameters: Parameters, changes: Mapping[str, Any], vehicle: Vehicle) -> Parameters:
    try:
        changed = with_overrides(parameters, changes_of(parameters, changes))
    except ParameterError:
        raise
    except (ValueError, TypeError) as error:
        path, _, rule = str(error).partition(": ")
        raise ParameterError([Problem("", None, None, path, None, rule or str(error))]) from error
    problems = check(changed, vehicle)
    if problems:
        raise ParameterError(problems)
    return changed
