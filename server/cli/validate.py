"""`bumpless validate`: are these mission files fit to fly?"""

import json
from pathlib import Path
from typing import Annotated, Any

import typer


def validate(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Mission files.", exists=True, dir_okay=False, readable=True)
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.")] = False,
    schema: Annotated[
        bool, typer.Option("--schema", help="Print the JSON Schema of missions and end.")
    ] = False,
) -> None:
    """Check mission files.

    Every fault is one line: file:line:column: field = value; rule.

    Exit code 1 when a file has a fault.
    """
    from twin.mission import MissionError, mission_json_schema, parse_mission

    if schema:
        typer.echo(json.dumps(mission_json_schema(), indent=2, ensure_ascii=False))
        return
    if not files:
        typer.echo("bumpless validate: name at least one mission file", err=True)
        raise typer.Exit(2)
    results: list[dict[str, Any]] = []
    for path in files:
        problems = ()
        try:
            parse_mission(path.read_bytes().decode(), str(path))
        except MissionError as error:
            problems = error.problems
        except UnicodeDecodeError:
            typer.echo(f"{path}: is not UTF-8 text", err=True)
            raise typer.Exit(1) from None
        results.append({"file": str(path), "ok": not problems, "problems": [p.as_dict() for p in problems]})
        if not as_json:
            for problem in problems:
                typer.echo(str(problem), err=True)
            if not problems:
                typer.echo(f"{path}: ok")
    if as_json:
        typer.echo(json.dumps(results, indent=2, ensure_ascii=False))
    if not all(result["ok"] for result in results):
        raise typer.Exit(1)
