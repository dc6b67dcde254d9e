"""Commands that need more than a vehicle's own installation say in one sentence what to install."""

import typer

from bumpless.contract.extras import lack_of


def need(extra: str, *modules: str) -> None:
    """End with exit code 1 and that sentence when one of these modules is not installed."""
    if lack := lack_of(extra, *modules):
        typer.echo(f"bumpless: {lack}", err=True)
        raise typer.Exit(1)
