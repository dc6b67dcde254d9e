"""`bumpless validate`: are these mission files fit to fly?"""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from bumpless.config.mission import Mission


def validate(
    files: Annotated[list[Path] | None, typer.Argument(help="Mission files.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.")] = False,
    stability: Annotated[
        bool,
        typer.Option("--stability", help="Also warn of an unproven dwell time; some time per file."),
    ] = False,
    schema: Annotated[
        bool, typer.Option("--schema", help="Print the JSON Schema of missions and end.")
    ] = False,
) -> None:
    """Check mission files.

    Every fault is one line: file:line:column: field = value; rule. What the vehicle can't do in the
    mission's current and time is a finding: an error where it can't work, a warning where it is
    unlikely, with the nearest change that would. With --stability, a dwell time that no Lyapunov
    function proves long enough is a warning.

    Exit code 1 when a file has a fault or an error, or can't be read; the others are answered all the
    same.
    """
    from bumpless import check
    from bumpless.config.mission import MissionError, mission_json_schema, parse_mission
    from bumpless.config.problems import Problem

    if schema:
        typer.echo(json.dumps(mission_json_schema(), indent=2, ensure_ascii=False))
        return
    if not files:
        typer.echo("bumpless validate: name at least one mission file", err=True)
        raise typer.Exit(2)
    results: list[dict[str, Any]] = []
    for path in files:
        problems, warnings, findings = (), [], ()
        try:
            mission = parse_mission(path.read_bytes(), str(path))
            warnings = _warnings(mission) if stability else []
            findings = check(mission)
        except MissionError as error:
            problems = error.problems
        except OSError as error:
            reason = f"cannot be read: {error.strerror or error}"
            problems = (Problem(str(path), None, None, "", None, reason),)
        ok = not problems and not any(finding.blocks for finding in findings)
        found = {"ok": ok, "problems": [p.as_dict() for p in problems], "warnings": warnings}
        results.append({"file": str(path), **found, "findings": [f.as_dict() for f in findings]})
        if not as_json:
            for problem in problems:
                typer.echo(str(problem), err=True)
            for finding in findings:
                typer.echo(f"{path}: {finding.word}: {finding}", err=True)
            for warning in warnings:
                typer.echo(f"{path}: warning: {warning}", err=True)
            if ok:
                typer.echo(f"{path}: ok")
    if as_json:
        typer.echo(json.dumps(results, indent=2, ensure_ascii=False))
    if not all(result["ok"] for result in results):
        raise typer.Exit(1)


def _warnings(mission: "Mission") -> list[str]:
    from bumpless.config.vehicle import load_vehicle
    from bumpless.stability import check_dwell, dwell_warning

    warning = dwell_warning(check_dwell(mission, load_vehicle(mission.vehicle)))
    return [warning] if warning else []
