"""`bumpless run`: fly a mission as fast as the machine can."""

import json
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from bumpless.campaign.plant import Alteration
    from bumpless.config.mission import Mission
    from bumpless.config.parameters import Parameters
    from bumpless.config.vehicle import Vehicle

REFUSED, BROKEN = 1, 3


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
) -> None:
    """Fly a mission as fast as the machine can.

    Prints its metrics and writes its log.

    Exit codes: 0 flown, 1 mission or parameters refused or the log cannot be written, 2 wrong usage,
    3 the simulation broke down.
    """
    from bumpless.config.problems import ProblemsError
    from bumpless_server.cli.progress import Progress

    try:
        if draw is None:
            flown, who, parameters = _prepare(mission, vehicle, changes or [])
            alter = None
        else:
            flown, who, parameters, alter = _drawn(mission, draw, changes or [])
    except ProblemsError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(REFUSED) from error
    with Progress(flown.name) as progress:
        from bumpless.sim.twin import simulate

        begin = time.perf_counter()
        progress.watch_compiler()
        simulate(replace(flown, duration_s=1.0), who, parameters, seed)  # compiled code is loaded by this
        ready = time.perf_counter()
        result = simulate(flown, who, parameters, seed, progress.update, alter)
        wall_s = time.perf_counter() - ready
    from bumpless.metrics import Run, as_dict, metrics_of
    from bumpless_server.cli.run_log import identity, write_log

    metrics = metrics_of(Run.from_log(result.log, len(who.actuators)), who)
    info = identity(result)
    metrics.run_id = info["run_id"]
    summary: dict[str, Any] = {
        **info,
        "seed": result.seed,
        "simulated_s": metrics.duration_s,
        "wall_s": wall_s,
        "real_time_factor": metrics.duration_s / wall_s,
        "load_s": ready - begin,
        "log": None if out is None else str(out),
    }
    if out is not None:
        try:
            with Progress(f"writing {out.name}") as progress:
                write_log(out, result, info, metrics, progress.update)
        except OSError as error:
            typer.echo(f"{out}: {error.strerror or error}", err=True)
            raise typer.Exit(REFUSED) from error
    typer.echo(
        json.dumps({**summary, "metrics": as_dict(metrics)}, indent=2) if as_json else _text(summary, metrics)
    )
    if not _finite(result.log):
        typer.echo("the simulation broke down: a state is not finite", err=True)
        raise typer.Exit(BROKEN)


def _prepare(path: Path, vehicle: str | None, changes: list[str]) -> "tuple[Mission, Vehicle, Parameters]":
    """The mission, its vehicle and parameters; raises ProblemsError."""
    from bumpless.config.mission import MissionError, parse_mission
    from bumpless.config.parameters import ParameterError, check, default_parameters, with_overrides
    from bumpless.config.problems import Problem
    from bumpless.config.vehicle import load_vehicle

    chosen = None if vehicle is None else load_vehicle(vehicle)
    try:
        text = path.read_bytes().decode()
    except UnicodeDecodeError as error:
        raise MissionError([Problem(str(path), None, None, "", None, "is not UTF-8 text")]) from error
    mission = parse_mission(text, str(path), chosen, any_vehicle=True)
    flown_by = chosen or load_vehicle(mission.vehicle)
    parameters = with_overrides(default_parameters(flown_by), mission.parameters)
    try:
        parameters = with_overrides(parameters, _changes(changes))
    except ParameterError as error:
        raise ParameterError([replace(problem, file="--set") for problem in error.problems]) from error
    problems = check(parameters, flown_by, "--set")
    if problems:
        raise ParameterError(problems)
    return replace(mission, source=path.name), flown_by, parameters


def _drawn(path: Path, number: int, changes: list[str]) -> "tuple[Mission, Vehicle, Parameters, Alteration]":
    """The same for a campaign's flight, and what is true of its plant; raises ProblemsError."""
    from bumpless.campaign.read import load_campaign
    from bumpless.campaign.replay import replayed

    return replayed(load_campaign(path).with_parameters(_changes(changes)), number)


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


def _finite(log: Any) -> bool:
    import numpy as np

    return all(bool(np.isfinite(log[name]).all()) for name in ("eta", "nu", "u", "tau_d"))


def _text(summary: dict[str, Any], metrics: Any) -> str:
    from bumpless_server.cli.tables import metrics_text

    head = (
        f"{summary['mission']} on {summary['vehicle']}, seed {summary['seed']}: "
        f"{summary['simulated_s']:.1f} s flown in {summary['wall_s']:.3f} s, "
        f"{summary['real_time_factor']:.0f} times real time"
    )
    tail = f"\n\nlog: {summary['log']}" if summary["log"] else ""
    return f"{head}\n\n{metrics_text(metrics)}{tail}"
