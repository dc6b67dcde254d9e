"""`bumpless campaign`: fly many drawn missions."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from bumpless_server.cli.extras import need

if TYPE_CHECKING:
    from bumpless.campaign.prepared import Prepared
    from bumpless.campaign.summary import Summary

REFUSED, LOST, STOPPED = 1, 3, 130

File = Annotated[Path, typer.Argument(help="Campaign file.", exists=True, dir_okay=False)]
Dask = Annotated[
    str | None, typer.Option("--dask", help="Address of a Dask scheduler, tcp://host:8786.  [default: here]")
]
Workers = Annotated[int | None, typer.Option(min=1, help="Processes to start here.  [default: one per core]")]
Json = Annotated[bool, typer.Option("--json", help="Print the result as JSON.")]


def campaign(
    file: File,
    out: Annotated[
        Path | None, typer.Option(help="Folder for the flights.  [default: campaign-NAME]", file_okay=False)
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Fly what the folder does not hold yet.")] = False,
    dask: Dask = None,
    workers: Workers = None,
    as_json: Json = False,
) -> None:
    """Fly many drawn missions.

    The folder gets the flights as Parquet, index.html and summary.json. Stopped or killed at any moment, it
    goes on with --resume; no flight is lost or counts twice.

    Exit codes: 0 flown, 1 campaign or folder refused or a flight could not be flown, 3 the cluster went away,
    130 stopped.
    """
    prepared = loaded(file)
    from bumpless.campaign.cluster import opened as cluster
    from bumpless.campaign.fly import Pace, fly_missing
    from bumpless.campaign.report import write_report
    from bumpless.campaign.store import opened as store
    from bumpless_server.cli.progress import Progress

    folder = out or Path(f"campaign-{prepared.campaign.name}")
    with said_plainly(), store(folder, prepared, resume) as kept:
        with Progress(prepared.campaign.name) as progress, cluster(dask, workers) as client:

            def show(pace: Pace) -> None:
                progress.update(pace.stored / pace.total, str(pace))

            fly_missing(prepared, kept, client, show)
        summary = write_report(prepared, kept, str(file))
    typer.echo(json.dumps(summary.as_dict(), indent=2) if as_json else text_of(prepared, summary, folder))


def loaded(file: Path) -> "Prepared":
    """The campaign in `file`, or the end with what is wrong with it."""
    need("campaign", "distributed", "jinja2", "matplotlib", "optuna", "pyarrow")
    from bumpless.campaign.read import load_campaign
    from bumpless.config.problems import ProblemsError

    try:
        return load_campaign(file)
    except ProblemsError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(REFUSED) from error


@contextmanager
def said_plainly() -> Iterator[None]:
    """Errors of folder, disk and cluster, and Ctrl-C, as one line and an exit code."""
    from bumpless.campaign.cluster import ClusterError
    from bumpless.campaign.flight import FlightError, OtherSoftware
    from bumpless.campaign.store import StoreError

    again = "what was flown is stored; the same command with --resume goes on"
    try:
        yield
    except StoreError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(REFUSED) from error
    except OSError as error:
        said = f"{error.filename}: {error.strerror}" if error.filename else str(error)
        typer.echo(f"{said}; {again}", err=True)
        raise typer.Exit(REFUSED) from error
    except FlightError as error:
        typer.echo(f"{error}; {again}", err=True)
        raise typer.Exit(REFUSED) from error
    except (ClusterError, OtherSoftware) as error:
        typer.echo(f"{error}; {again}", err=True)
        raise typer.Exit(LOST) from error
    except KeyboardInterrupt as error:
        typer.echo(f"stopped; {again}", err=True)
        raise typer.Exit(STOPPED) from error


def text_of(prepared: "Prepared", summary: "Summary", folder: Path) -> str:
    """What a person reads at the end."""
    lines = [f"{prepared.campaign.title or prepared.campaign.name}: {summary.flights} flights"]
    for name, share in summary.outcomes.items():
        if share.count:
            interval = f"{100 * share.low:.1f} to {100 * share.high:.1f} %"
            lines.append(
                f"  {name.replace('_', ' '):12s} {share.count:7d}  {100 * share.share:5.1f} %  ({interval})"
            )
    return "\n".join([*lines, f"{folder / 'index.html'}"])
