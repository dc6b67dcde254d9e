"""`bumpless serve`: its options. The work is in `bumpless_server.cli.serve`."""

from pathlib import Path
from typing import Annotated

import typer


def serve(
    host: Annotated[str | None, typer.Option(help="Address to serve on.  [default: 127.0.0.1]")] = None,
    port: Annotated[int | None, typer.Option(help="Port; 0 takes a free one.  [default: 8080]")] = None,
    data_dir: Annotated[
        Path | None, typer.Option(help="Runs, uploaded missions, presets.  [default: data]")
    ] = None,
    vehicle: Annotated[str | None, typer.Option(help="Vehicle id or file.  [default: ts100]")] = None,
    manage_node: Annotated[
        bool | None,
        typer.Option("--node/--no-node", help="Start the vehicle node, or wait for one.  [default: node]"),
    ] = None,
    zenoh_listen: Annotated[list[str] | None, typer.Option(help="Endpoint of the bus to listen on.")] = None,
    zenoh_connect: Annotated[
        list[str] | None, typer.Option(help="Endpoint of the bus to connect to.")
    ] = None,
    zenoh_config: Annotated[
        Path | None, typer.Option(help="Zenoh configuration of the bus, instead of the endpoints.")
    ] = None,
    scene: Annotated[str | None, typer.Option(help="full, light or off.  [default: full]")] = None,
) -> None:
    """Serve the console and start the vehicle.

    Each option is also a setting BUMPLESS_<NAME> of the environment, such as BUMPLESS_PORT.
    """
    from bumpless_server.cli.extras import need

    need("console", "pydantic_settings", "fastapi", "uvicorn", "viser", "mcap")
    from bumpless_server.settings import SettingsError, load_settings

    given = {
        "host": host,
        "port": port,
        "data_dir": data_dir,
        "vehicle": vehicle,
        "manage_node": manage_node,
        "zenoh_listen": tuple(zenoh_listen) if zenoh_listen else None,
        "zenoh_connect": tuple(zenoh_connect) if zenoh_connect else None,
        "zenoh_config": zenoh_config,
        "scene": scene,
    }
    try:
        settings = load_settings(**given)
    except SettingsError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(2) from error
    from bumpless_server.cli.serve import run

    raise typer.Exit(run(settings))
