"""Commands that need more than a vehicle's own installation say in one sentence what to install."""

from importlib.util import find_spec

import typer


def need(extra: str, *modules: str) -> None:
    """End with exit code 1 and that sentence when one of these modules is not installed."""
    lacking = [name for name in modules if find_spec(name) is None]
    if lacking:
        typer.echo(
            f"bumpless: {', '.join(lacking)} is not installed; pip install 'bumpless[{extra}]' brings it",
            err=True,
        )
        raise typer.Exit(1)
