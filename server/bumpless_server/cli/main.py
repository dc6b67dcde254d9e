"""The command `bumpless`: one file per command, and nothing heavy imported before it is needed."""

import gc
from typing import Any

import typer
from typer.core import TyperGroup

from bumpless.contract.exits import REFUSED
from bumpless_server.cli import (
    campaign,
    compare,
    envelope,
    export,
    identify,
    keys,
    metrics,
    refly,
    repair,
    report,
    reproduce,
    run,
    tune,
    user,
    validate,
    vehicle,
)
from bumpless_server.cli.serve_command import serve


class Commands(TyperGroup):
    """All commands: what the disk refuses ends each of them with one line."""

    def invoke(self, ctx: typer.Context) -> Any:  # type: ignore[override]
        """Run the command that was asked for."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            raise  # whoever read our words is gone: Click's own way
        except OSError as error:
            said = f"{error.filename}: {error.strerror}" if error.filename else str(error)
            typer.echo(f"bumpless {ctx.invoked_subcommand}: {said}", err=True)
            raise typer.Exit(REFUSED) from error


app = typer.Typer(
    name="bumpless",
    cls=Commands,
    help="Mission console and digital twin for over-actuated AUVs that dock.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

# A start makes objects by the hundred thousand that stay: looked through for garbage less often, it takes a
# tenth less
COLLECT_AFTER = (20_000, 50, 100)


@app.callback(invoke_without_command=True)
def _options(version: bool = typer.Option(False, "--version", help="Print the version and end.")) -> None:
    gc.set_threshold(*COLLECT_AFTER)
    if version:
        from bumpless.contract.version import software_version

        typer.echo(f"bumpless {software_version()}")
        raise typer.Exit


app.command()(serve)
app.command()(vehicle.vehicle)
app.command()(run.run)
app.command()(validate.validate)
app.command()(campaign.campaign)
app.command()(tune.tune)
app.command()(metrics.metrics)
app.command()(compare.compare)
app.command()(report.report)
app.command()(refly.refly)
app.command()(identify.identify)
app.command()(export.export)
app.command()(envelope.envelope)
app.command()(repair.repair)
app.command()(reproduce.reproduce)
app.add_typer(user.user, name="user")
app.add_typer(keys.app, name="keys")


if __name__ == "__main__":
    app()
