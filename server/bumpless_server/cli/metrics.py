"""`bumpless metrics`: the figures of a recorded run."""

import json
from pathlib import Path
from typing import Annotated

import typer


def metrics(
    log: Annotated[Path, typer.Argument(help="MCAP file of a run.", exists=True, dir_okay=False)],
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Compute the metrics of a recorded run."""
    import bumpless
    from bumpless.metrics import as_dict
    from bumpless_server.cli.extras import need
    from bumpless_server.cli.tables import metrics_text

    need("log", "mcap")
    try:
        run = bumpless.open_run(log)
        found, outcome = run.metrics, run.outcome
    except ValueError as error:
        typer.echo(f"{log}: {error}", err=True)
        raise typer.Exit(1) from error
    text = f"{outcome.sentence}\n\n{metrics_text(found)}"
    typer.echo(json.dumps(as_dict(found), indent=2) if as_json else text)
