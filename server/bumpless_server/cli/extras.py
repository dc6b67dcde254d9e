"""What only some commands need is installed by an extra; without it they end with the word that helps."""

from importlib.util import find_spec

import typer


def needs(*packages: str) -> None:
    """End unless all of these packages of the extra `campaign` are installed."""
    lacking = [name for name in packages if find_spec(name) is None]
    if lacking:
        typer.echo(f"not installed: {', '.join(lacking)}; pip install 'bumpless[campaign]'", err=True)
        raise typer.Exit(1)
