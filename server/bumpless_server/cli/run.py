"""`bumpless run`: fly a mission as fast as the machine can."""

import json
import time
from dataclasses import asdict, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from bumpless.contract.exits import BROKEN, NOT_AS_REQUIRED, REFUSED

if TYPE_CHECKING:
    from bumpless import Mission, Problem, Run, Vehicle
    from bumpless.campaign.replay import Replay
    from bumpless.metrics import Columns


def run(
    mission: Annotated[Path, typer.Argument(help="Mission file.", exists=True, dir_okay=False)],
    out: Annotated[Path | None, typer.Option(help="MCAP file to write.", dir_okay=False)] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.")] = False,
    seed: Annotated[int | None, typer.Option(min=0, help="Seed.  [default: the mission's]")] = None,
    vehicle: Annotated[
        str | None, typer.Option(help="Vehicle id or file (.toml).  [default: the mission's]")
    ] = None,
    changes: Annotated[
        list[str] | None,
        typer.Option("--set", help="Change a parameter: hover.lambda=0.01, bumpless.ramp=false."),
    ] = None,
    draw: Annotated[
        int | None, typer.Option(min=0, help="The file is a campaign: fly this number of it.")
    ] = None,
    charts: Annotated[
        Path | None,
        typer.Option(help="Folder of depth grids, beside the mission's own, such as data/charts."),
    ] = None,
    require: Annotated[
        str | None,
        typer.Option(help="Outcomes that will do, such as docked or docked,held; any other is exit code 4."),
    ] = None,
) -> None:
    """Fly a mission as fast as the machine can.

    Prints how it ended and its metrics, and writes its log. What `validate` says against the mission is said
    here too, and it is flown all the same.

    Exit codes: 0 flown (and ended as required), 1 mission or parameters refused or the log cannot be written,
    2 wrong usage, 3 the simulation broke down, 4 flown, but the outcome is not one that --require names.
    """
    wanted = _wanted(require)
    import bumpless
    from bumpless_server.cli.extras import need
    from bumpless_server.cli.progress import Progress

    if out is not None:
        need("log", "mcap", "foxglove_schemas_protobuf")
    tables = _changes(changes or [])
    if draw is not None and vehicle is not None:
        raise typer.BadParameter("a campaign says which vehicle flies", param_hint="--vehicle")
    try:
        if draw is None:
            who = None if vehicle is None else bumpless.load_vehicle(vehicle)
            flown, numbers, alter = _laid(bumpless.load_mission(mission, who), mission, charts), tables, None
            _foretell(flown, who, mission)
        else:
            flown, who, numbers, alter = _drawn(mission, draw, tables)
        fly = partial(bumpless.fly, vehicle=who, seed=seed, parameters=numbers, alter=alter)
        with Progress(flown.name) as progress:
            begin = time.perf_counter()
            progress.watch_compiler()
            fly(replace(flown, duration_s=1.0))  # loads what is compiled
            ready = time.perf_counter()
            result = fly(flown, progress=progress.update)
            wall_s = time.perf_counter() - ready
    except bumpless.ProblemsError as error:
        typer.echo("\n".join(_named(problem) for problem in error.problems), err=True)
        raise typer.Exit(REFUSED) from error
    if out is not None:
        _save(result, out)
    summary = _summary(result, wall_s, ready - begin, out)
    typer.echo(json.dumps(summary, indent=2) if as_json else _text(result, summary))
    if _broke_down(result.columns):
        typer.echo("the simulation broke down: a state is not finite", err=True)
        raise typer.Exit(BROKEN)
    if wanted and result.outcome.ending not in wanted:
        often = " or ".join(ending.replace("_", " ") for ending in wanted)
        typer.echo(f"required: {often}; the run ended {result.outcome.ending.words}", err=True)
        raise typer.Exit(NOT_AS_REQUIRED)


def _wanted(require: str | None) -> list[str]:
    """The endings that `--require` names; none asked for, none required."""
    if require is None:
        return []
    from bumpless import Ending

    known = [ending.value for ending in Ending]
    named = [word.strip().replace(" ", "_").replace("-", "_") for word in require.split(",")]
    strange = [word for word in named if word not in known]
    if strange:
        said = f"{strange[0]!r}: must be one or more of {', '.join(known)}"
        raise typer.BadParameter(said, param_hint="--require")
    return named


def _laid(mission: "Mission", path: Path, charts: Path | None) -> "Mission":
    """The mission with its depth grid, of whatever kind it is; raises ProblemsError."""
    if mission.sea_floor is None or mission.depth_grid is not None:
        return mission
    from bumpless import MissionError, Problem
    from bumpless_server.plan.charts.beside import laid
    from bumpless_server.plan.charts.content import NotAChart

    try:
        return laid(mission, path.parent, charts)
    except NotAChart as error:
        raise MissionError([Problem(path.name, None, None, "sea_floor.grid", None, str(error))]) from error


def _foretell(mission: "Mission", vehicle: "Vehicle | None", path: Path) -> None:
    """Say what `validate` would, and fly all the same: a simulation harms nobody."""
    from bumpless import check

    for found in check(mission, vehicle):
        word = "error" if found.blocks else "warning"
        typer.echo(f"{path}: {word}: {found.field}: {found.text} {found.change}".rstrip(), err=True)


def _drawn(path: Path, number: int, changes: dict[str, dict[str, Any]]) -> "Replay":
    """A campaign's flight, with what is true of its plant; raises ProblemsError."""
    from bumpless.campaign.read import load_campaign
    from bumpless.campaign.replay import replayed
    from bumpless.config.parameters import ParameterError

    prepared = load_campaign(path)
    try:
        return replayed(prepared.with_parameters(changes), number)
    except ParameterError as error:
        raise ParameterError([replace(problem, file="--set") for problem in error.problems]) from error


def _save(result: "Run", out: Path) -> None:
    """Write the log, Foxglove's views with it."""
    from bumpless_server.cli.progress import Progress
    from bumpless_server.views.foxglove import Foxglove

    try:
        with Progress(f"writing {out.name}") as progress:
            result.save(out, [Foxglove()], progress.update)
    except OSError as error:
        typer.echo(f"{out}: {error.strerror or error}", err=True)
        raise typer.Exit(REFUSED) from error


def _summary(result: "Run", wall_s: float, load_s: float, out: Path | None) -> dict[str, Any]:
    from bumpless.metrics import as_dict

    metrics = result.metrics
    return {
        **asdict(result.info),
        "simulated_s": metrics.duration_s,
        "wall_s": wall_s,
        "real_time_factor": metrics.duration_s / wall_s,
        "load_s": load_s,
        "log": None if out is None else str(out),
        "outcome": result.outcome.as_dict(),
        "metrics": as_dict(metrics),
    }


def _named(problem: "Problem") -> str:
    """A problem of given parameters names the option that gave them."""
    from bumpless.runs.flight import GIVEN

    return str(replace(problem, file="--set") if problem.file == GIVEN else problem)


def _changes(changes: list[str]) -> dict[str, dict[str, Any]]:
    """`section.key=value` with a JSON value as nested tables."""
    tables: dict[str, dict[str, Any]] = {}
    for change in changes:
        path, equals, value = change.partition("=")
        section, dot, key = path.strip().partition(".")
        if not equals or not dot:
            raise typer.BadParameter(f"{change!r}: must be section.key=value", param_hint="--set")
        try:
            parsed = json.loads(value)
        except json.JSONDecodeError:
            parsed = value.strip()
        tables.setdefault(section, {})[key] = parsed
    return tables


def _broke_down(columns: "Columns") -> bool:
    """Whether a number that is none came out of the simulation, for a moment or for good."""
    import numpy as np

    true = all(np.isfinite(values).all() for values in (columns.eta, columns.nu))
    return columns.lost or columns.missing > 0 or not true


def _text(result: "Run", summary: dict[str, Any]) -> str:
    from bumpless_server.cli.tables import metrics_text

    head = (
        f"{summary['mission']} on {summary['vehicle']}, seed {summary['seed']}: "
        f"{summary['simulated_s']:.1f} s flown in {summary['wall_s']:.3f} s, "
        f"{summary['real_time_factor']:.0f} times real time"
    )
    outcome = result.outcome.sentence
    tail = f"\n\nlog: {summary['log']}" if summary["log"] else ""
    return f"{head}\n{outcome}\n\n{metrics_text(result.metrics)}{tail}"
