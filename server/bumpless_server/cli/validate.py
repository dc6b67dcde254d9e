"""`bumpless validate`: are these mission files fit to fly?"""

import hashlib
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
    charts: Annotated[
        Path | None,
        typer.Option(
            help="Folder of depth grids, such as data/charts; a mission's own folder is looked in too.",
            file_okay=False,
        ),
    ] = None,
    schema: Annotated[
        bool, typer.Option("--schema", help="Print the JSON Schema of missions and end.")
    ] = False,
) -> None:
    """Check mission files.

    Every fault is one line: file:line:column: field = value; rule. What the vehicle can't do in the
    mission's current and time is a finding: an error where it can't work, a warning where it is
    unlikely, with the nearest change that would. A depth grid that a mission names is looked for beside
    its file and in --charts. With --stability, a dwell time that no Lyapunov function proves long enough
    is a warning.

    Exit code 1 when a file has a fault or an error, or can't be read; the others are answered all the
    same.
    """
    if schema:
        from bumpless.config.mission import mission_json_schema

        typer.echo(json.dumps(mission_json_schema(), indent=2, ensure_ascii=False))
        return
    if not files:
        typer.echo("bumpless validate: name at least one mission file", err=True)
        raise typer.Exit(2)
    results = [_checked(path, stability, charts) for path in files]
    if not as_json:
        for result in results:
            _say(result)
    if as_json:
        typer.echo(json.dumps(results, indent=2, ensure_ascii=False))
    if not all(result["ok"] for result in results):
        raise typer.Exit(1)


def _checked(path: Path, stability: bool, charts: Path | None) -> dict[str, Any]:
    """The answer for one file, which is whole whatever the file is."""
    from bumpless.config.mission import parse_mission
    from bumpless_server.foresight.checked import checked
    from bumpless_server.plan.charts.beside import laid
    from bumpless_server.plan.charts.content import NotAChart

    try:
        data = path.read_bytes()
    except OSError as error:
        return _unread(path, f"cannot be read: {error.strerror or error}")
    try:
        found = checked(data, str(path), lay=lambda mission: laid(mission, path.parent, charts))
    except NotAChart as error:
        return _unread(path, str(error), "sea_floor.grid", hashlib.sha256(data).hexdigest())
    except Exception as error:  # one odd file costs no answer of the others
        why = f"cannot be checked: {type(error).__name__}: {error}"
        return _unread(path, why, sha256=hashlib.sha256(data).hexdigest())
    read = stability and not found["problems"]
    return {**found, "warnings": _warnings(parse_mission(data, str(path))) if read else []}


def _unread(path: Path, rule: str, field: str = "", sha256: str = "") -> dict[str, Any]:
    from bumpless.config.problems import Problem

    problem = Problem(str(path), None, None, field, None, rule).as_dict()
    told = {"file": str(path), "sha256": sha256, "ok": False, "problems": [problem]}
    return {**told, "findings": [], "warnings": []}


def _say(result: dict[str, Any]) -> None:
    """One line for each fault; the good ones on the other stream."""
    for problem in result["problems"]:
        said = f"{problem['field']} = {problem['value']}" if problem["value"] else problem["field"]
        fault = "; ".join(part for part in (said, problem["rule"]) if part)
        typer.echo(f"{_place(problem['file'], problem)}: {fault}", err=True)
    for finding in result["findings"]:
        word = "error" if finding["severity"] == "hard" else "warning"
        text = f"{finding['path']}: {finding['reason']} {finding['change']}".rstrip()
        typer.echo(f"{_place(result['file'], finding)}: {word}: {text}", err=True)
    for warning in result["warnings"]:
        typer.echo(f"{result['file']}: warning: {warning}", err=True)
    if result["ok"]:
        typer.echo(f"{result['file']}: ok")


def _place(file: str, one: dict[str, Any]) -> str:
    if not one["line"]:
        return file
    return f"{file}:{one['line']}" + (f":{one['column']}" if one["column"] else "")


def _warnings(mission: "Mission") -> list[str]:
    from bumpless.config.vehicle import load_vehicle
    from bumpless.stability import check_dwell, dwell_warning

    warning = dwell_warning(check_dwell(mission, load_vehicle(mission.vehicle)))
    return [warning] if warning else []
