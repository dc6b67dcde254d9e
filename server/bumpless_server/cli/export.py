"""`bumpless export`: a recorded run, whole or a range of it, for another program."""

from pathlib import Path
from typing import Annotated

import typer

from bumpless.contract.exits import MISUSED


def export(
    log: Annotated[Path, typer.Argument(help="MCAP file of a run.", exists=True, dir_okay=False)],
    kind: Annotated[
        str, typer.Option("--as", help="mcap, csv, parquet, alog (for MOOS tools), or layout (Foxglove's).")
    ] = "mcap",
    part: Annotated[
        str, typer.Option("--range", help="FROM:TO in s of mission time; either may be left out.")
    ] = ":",
    signals: Annotated[
        list[str] | None,
        typer.Option("--signal", help="Of a table: a column or pattern, such as 'navigation.*'; repeat it."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="File to write; beside the log by default.")
    ] = None,
) -> None:
    """Export a recorded run: an MCAP file of a range, a table of signals, or a log for MOOS tools.

    A run that is still being recorded is exported as far as it has reached the disk.
    """
    from bumpless_server.cli.extras import need

    need("log", "mcap")
    from bumpless.config.whole import whole
    from bumpless.contract.extras import ExtraMissing
    from bumpless.runs.cut import Range
    from bumpless.runs.export import KINDS
    from bumpless.runs.export import export as written

    try:
        if kind == "layout":
            from bumpless_server.views.foxglove import LAYOUT, layout

            target = out or log.with_name(LAYOUT)
            with whole(target) as partial:
                partial.write_bytes(layout())
        elif kind in KINDS:
            chosen = Range.read(part)
            target = out or _beside(log, kind, chosen.all)
            if target.exists() and target.samefile(log):
                raise ValueError("would replace the log by itself; name another file with --out")
            written(log, target, kind, chosen, signals or ())
        else:
            raise ValueError(f"--as {kind!r}: must be one of {', '.join(KINDS)}, layout")
    except (ValueError, OSError, ExtraMissing) as error:
        typer.echo(f"bumpless export: {error}", err=True)
        raise typer.Exit(MISUSED) from error
    typer.echo(f"{target}: {target.stat().st_size // 1000} kB")


def _beside(log: Path, kind: str, whole: bool) -> Path:
    """A name beside the log that isn't the log's."""
    return log.with_name(f"{log.stem}{'-part' if kind == 'mcap' and not whole else ''}"
                         f"{'-whole' if kind == 'mcap' and whole else ''}.{kind}")  # fmt: skip
