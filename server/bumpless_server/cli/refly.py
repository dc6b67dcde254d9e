"""`bumpless refly`: a recorded run's mission flown again with other numbers, and both compared."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from bumpless.contract.exits import MISUSED, REFUSED

if TYPE_CHECKING:
    from bumpless import Run


def refly(
    log: Annotated[Path, typer.Argument(help="MCAP file of a run.", exists=True, dir_okay=False)],
    changes: Annotated[
        list[str] | None,
        typer.Option("--set", help="A parameter that shall differ: hover.lambda=0.01; repeat it."),
    ] = None,
    allocator: Annotated[str | None, typer.Option(help="Another allocator: mdca, wls or pid_direct.")] = None,
    vehicle: Annotated[str | None, typer.Option(help="Another vehicle: id or file (.toml).")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="Another seed.  [default: the run's]")] = None,
    as_seen: Annotated[
        bool | None,
        typer.Option(
            "--as-seen/--as-planned",
            help="With the current and target that the vehicle saw, or those of the mission.  "
            "[default: as seen where nobody knows the truth]",
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="MCAP file to write; beside the log by default.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the comparison as JSON.")] = False,
) -> None:
    """Fly a recorded run's mission again with other numbers, and compare both flights.

    Exit codes: 0 flown, 1 refused (the log tells no mission, or parameters break a rule), 2 wrong usage.
    """
    from bumpless_server.cli.extras import need

    need("log", "mcap", "foxglove_schemas_protobuf")
    import bumpless
    from bumpless.review.refly import refly as flown_again
    from bumpless.runs.run import NoFigures

    values: dict[str, Any] = dict(_change(change) for change in changes or [])
    if allocator is not None:
        values["allocation.allocator"] = allocator
    target = out or log.with_name(f"{log.stem}-again.mcap")
    if target.exists() and target.samefile(log):
        typer.echo("bumpless refly: would replace the log by itself; name another file with --out", err=True)
        raise typer.Exit(MISUSED)
    try:
        who = None if vehicle is None else bumpless.load_vehicle(vehicle)
        again = flown_again(bumpless.open_run(log), values, who, seed, as_seen)
        _save(again, target)
        typer.echo(_compared(log, target, as_json))
    except bumpless.ProblemsError as error:
        typer.echo("\n".join(str(problem) for problem in error.problems), err=True)
        raise typer.Exit(REFUSED) from error
    except (NoFigures, ValueError, OSError) as error:
        typer.echo(f"bumpless refly: {error}", err=True)
        raise typer.Exit(REFUSED) from error


def _change(text: str) -> tuple[str, Any]:
    """`section.key=value` with a JSON value."""
    import json

    path, equals, value = text.partition("=")
    if not equals or "." not in path:
        raise typer.BadParameter(f"{text!r}: must be section.key=value", param_hint="--set")
    try:
        return path.strip(), json.loads(value)
    except ValueError:
        return path.strip(), value.strip()


def _save(run: "Run", target: Path) -> None:
    from bumpless_server.views.foxglove import Foxglove

    run.save(target, [Foxglove()])


def _compared(log: Path, target: Path, as_json: bool) -> str:
    from bumpless.review.compare import compare
    from bumpless.review.subject import subject_of
    from bumpless_server.cli.compare import json_of, text_of

    comparison = compare([subject_of(log), subject_of(target)])
    return json_of(comparison, []) if as_json else f"{target}\n\n{text_of(comparison, [])}"
