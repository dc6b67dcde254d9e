"""`bumpless keys`: certificates, passwords and rights for everybody on the bus."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(no_args_is_help=True, help="Keys for the bus: who may speak on it, and for whom.")

Folder = Annotated[Path, typer.Option("--out", help="Folder of the keys.")]
KEYS = Path("keys")


@app.command()
def init(
    host: Annotated[
        list[str] | None,
        typer.Option(
            help="Name or address of the router; the first is dialled.  [default: 127.0.0.1, localhost]"
        ),
    ] = None,
    vehicle: Annotated[list[str] | None, typer.Option(help="Vehicle id.  [default: ts100]")] = None,
    observer: Annotated[list[str] | None, typer.Option(help="Name of somebody who may listen.")] = None,
    port: Annotated[int, typer.Option(min=1, max=65535, help="Port of the router.")] = 7447,
    users_at: Annotated[
        str, typer.Option(help="Where the router will find users.txt.  [default: in this folder]")
    ] = "",
    out: Folder = KEYS,
) -> None:
    """Make a small certificate authority, and for each party one file with all that it needs.

    The router, the server, each vehicle and each observer get a Zenoh configuration with certificate,
    password and, for the router, the rights of all.
    """
    from bumpless_server.keys import folder

    hosts = tuple(host or ("127.0.0.1", "localhost"))
    _tell(
        lambda: folder.init(out, hosts, tuple(vehicle or ("ts100",)), tuple(observer or ()), port, users_at)
    )


@app.command()
def add(
    role: Annotated[str, typer.Argument(help="vehicle or observer.")],
    name: Annotated[str, typer.Argument(help="Vehicle id, or an observer's name.")],
    out: Folder = KEYS,
) -> None:
    """Give keys to one more party; the router learns of it when it is started anew with its files."""
    from bumpless_server.keys import folder
    from bumpless_server.keys.access import Party

    _tell(lambda: folder.add(out, Party(role, name)))


@app.command()
def remove(
    role: Annotated[str, typer.Argument(help="vehicle or observer.")],
    name: Annotated[str, typer.Argument(help="Vehicle id, or an observer's name.")],
    out: Folder = KEYS,
) -> None:
    """Take a party's rights; the router, started anew with its files, lets it do nothing any more."""
    from bumpless_server.keys import folder
    from bumpless_server.keys.access import Party

    _tell(lambda: folder.remove(out, Party(role, name)))


def _tell(make: Callable[[], list[Path]]) -> None:
    from bumpless_server.cli.extras import need

    need("console", "cryptography")
    from bumpless_server.keys.folder import KeysError

    try:
        written = make()
    except (KeysError, OSError) as error:
        typer.echo(f"bumpless: {error}", err=True)
        raise typer.Exit(1) from error
    for path in written:
        typer.echo(str(path))
