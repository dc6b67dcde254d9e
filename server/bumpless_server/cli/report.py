"""`bumpless report`: a recorded run as one HTML file to send."""

from pathlib import Path
from typing import Annotated

import typer


def report(
    log: Annotated[Path, typer.Argument(help="MCAP file of a run.", exists=True, dir_okay=False)],
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="HTML file; beside the log by default.")
    ] = None,
) -> None:
    """Write a run's report: one HTML file that fetches nothing and prints on A4."""
    from bumpless_server.cli.extras import need

    need("report", "mcap", "jinja2", "matplotlib")
    from bumpless.config.whole import write_text
    from bumpless.review.report import report_of
    from bumpless_server.scene.hull_picture import hull_picture

    target = out or log.with_suffix(".html")
    try:
        text = report_of(log, hull_picture)
    except ValueError as error:
        typer.echo(f"{log}: {error}", err=True)
        raise typer.Exit(1) from error
    write_text(target, text)
    typer.echo(f"{target}: {len(text.encode()) // 1000} kB")
