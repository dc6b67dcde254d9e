"""`bumpless repair`: give logs that were cut off their end back."""

from pathlib import Path
from typing import Annotated

import typer


def repair(
    logs: Annotated[list[Path], typer.Argument(help="MCAP files.", exists=True, dir_okay=False)],
) -> None:
    """Give logs that were cut off their end back."""
    from bumpless_server.cli.extras import need

    need("log", "mcap")
    from bumpless.runs.records import is_whole
    from bumpless.runs.repair import repair as rebuild

    failed = False
    for path in logs:
        if is_whole(path):
            typer.echo(f"{path}: whole")
            continue
        try:
            saved = rebuild(path)
        except (ValueError, OSError) as error:
            typer.echo(f"{path}: {error}", err=True)
            failed = True
            continue
        seconds = (saved.last_ns - saved.first_ns) * 1e-9
        typer.echo(f"{path}: repaired; {saved.messages} messages over {seconds:.1f} s")
    if failed:
        raise typer.Exit(1)
