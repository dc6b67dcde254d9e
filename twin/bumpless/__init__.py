"""Bumpless: fly over-actuated AUVs that dock, in simulation, and read what was flown.

    import bumpless

    run = bumpless.fly("docking", seed=3, parameters={"hover": {"lambda": 0.01}})
    print(run.outcome.ending, run.metrics.d_u_rh)
    frame = run.to_pandas()
    run.save("docking.mcap")
    same = bumpless.open_run("docking.mcap")

What is named here is the public face: it is documented and typed, and changes only with notice in the
changelog. Beside it stand three open rooms: `bumpless.contract` (messages, keys, names), `bumpless.config`
(vehicles, missions, parameters) and `bumpless.runs` (the format of logs). Everything else is private by its
place: it may move or change with any version.

Importing this loads nothing: each name is brought in when it is first asked for.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from bumpless.config.mission import Mission, MissionError
    from bumpless.config.parameters import ParameterError, Parameters
    from bumpless.config.problems import Problem, ProblemsError
    from bumpless.config.vehicle import Vehicle, VehicleError, load_vehicle, vehicle_names
    from bumpless.contract.extras import ExtraMissing
    from bumpless.feasibility.finding import Finding, Mend
    from bumpless.metrics.outcome import Ending, Outcome
    from bumpless.runs.checked import check
    from bumpless.runs.flight import fly, load_mission, open_run
    from bumpless.runs.info import RunInfo
    from bumpless.runs.run import NoFigures, Run

    __version__: str

_PLACES = {
    "bumpless.config.mission": ("Mission", "MissionError"),
    "bumpless.config.parameters": ("ParameterError", "Parameters"),
    "bumpless.config.problems": ("Problem", "ProblemsError"),
    "bumpless.config.vehicle": ("Vehicle", "VehicleError", "load_vehicle", "vehicle_names"),
    "bumpless.contract.extras": ("ExtraMissing",),
    "bumpless.feasibility.finding": ("Finding", "Mend"),
    "bumpless.metrics.outcome": ("Ending", "Outcome"),
    "bumpless.runs.checked": ("check",),
    "bumpless.runs.flight": ("fly", "load_mission", "open_run"),
    "bumpless.runs.info": ("RunInfo",),
    "bumpless.runs.run": ("NoFigures", "Run"),
}
_HOMES = {name: place for place, names in _PLACES.items() for name in names}

__all__ = [
    "Ending",
    "ExtraMissing",
    "Finding",
    "Mend",
    "Mission",
    "MissionError",
    "NoFigures",
    "Outcome",
    "ParameterError",
    "Parameters",
    "Problem",
    "ProblemsError",
    "Run",
    "RunInfo",
    "Vehicle",
    "VehicleError",
    "__version__",
    "check",
    "fly",
    "load_mission",
    "load_vehicle",
    "open_run",
    "vehicle_names",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from bumpless.contract.version import software_version

        return software_version()
    if name not in _HOMES:
        raise AttributeError(f"module 'bumpless' has no attribute {name!r}")
    from importlib import import_module

    found = getattr(import_module(_HOMES[name]), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
