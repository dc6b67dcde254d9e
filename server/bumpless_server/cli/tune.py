"""`bumpless tune`: search control parameters over drawn missions."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from bumpless_server.cli.campaign import REFUSED, Dask, File, Json, Workers, loaded, said_plainly

if TYPE_CHECKING:
    from bumpless.campaign.tune.result import Tuned

FAILED_SHOWN = 5


def tune(
    file: File,
    out: Annotated[
        Path | None, typer.Option(help="Folder for the search.  [default: tune-NAME]", file_okay=False)
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with the folder's search.")] = False,
    dask: Dask = None,
    workers: Workers = None,
    as_json: Json = False,
) -> None:
    """Search control parameters over drawn missions.

    The campaign's `tune` part says which and how long. Flights that end well come first, then tracking,
    smoothness and cost. The best is judged on flights that no trial has flown; parameters.toml gets it.

    Stopped or killed at any moment, it goes on with --resume: the same trials with the same result.

    Exit codes: 0 done, 1 campaign or folder refused or a flight could not be flown, 3 the cluster went away,
    130 stopped.
    """
    prepared = loaded(file)
    if prepared.campaign.tune is None:
        typer.echo(f"{file}: tune; is missing: what to search", err=True)
        raise typer.Exit(REFUSED)
    from bumpless.campaign.cluster import opened as cluster
    from bumpless.campaign.tune import journal, result, study
    from bumpless_server.cli.progress import Progress

    folder = out or Path(f"tune-{prepared.campaign.name}")
    with said_plainly(), journal.opened(folder, prepared, resume) as found:
        with Progress(f"tune {prepared.campaign.name}") as progress, cluster(dask, workers) as client:
            fly = study.flier(client)

            def show(done: int, total: int, more: str) -> None:
                progress.update(done / total, f"trial {done} of {total}, {more}")

            study.search(found, prepared, fly, show)
            tuned = result.judge(found, prepared, fly)
        result.write(folder, prepared, tuned)
    typer.echo(json.dumps(tuned.as_dict(), indent=2) if as_json else _text(tuned, folder))


def _text(tuned: "Tuned", folder: Path) -> str:
    lines = [f"{len(tuned.failed)} of {tuned.trials} trials could not be flown"] if tuned.failed else []
    lines += [f"  {reason}" for reason in tuned.failed[:FAILED_SHOWN]]
    if tuned.trial == 0:
        lines.append(f"nothing better found in {tuned.trials} trials than the parameters it began with")
    else:
        lines.append(f"trial {tuned.trial} of {tuned.trials} is the best")
    lines += [f"  {path} = {value:.6g}" for path, value in tuned.values.items()]
    for name, judged in (("before", tuned.before), ("after", tuned.after)):
        d = judged.docked
        lines.append(
            f"{name}: {d.count} of {d.total} held-out flights docked "
            f"({100 * d.low:.1f} to {100 * d.high:.1f} %), score {judged.score:.3f} "
            f"({judged.low:.3f} to {judged.high:.3f})"
        )
    low, high = tuned.gain
    lines.append(f"on held-out flights {tuned.verdict}: score smaller by {low:.3f} to {high:.3f}")
    return "\n".join([*lines, str(folder / "parameters.toml")])
