"""`bumpless vehicle`: the vehicle node, on this machine or on the vehicle's own."""

from pathlib import Path
from typing import Annotated

import typer


def vehicle(
    name: Annotated[str | None, typer.Argument(help="Vehicle id, or a vehicle file (.toml).")] = None,
    vehicle_id: Annotated[
        str | None, typer.Option("--id", help="Id on the bus.  [default: the vehicle's own]")
    ] = None,
    connect: Annotated[list[str] | None, typer.Option(help="Endpoint of the bus to connect to.")] = None,
    listen: Annotated[list[str] | None, typer.Option(help="Endpoint of the bus to listen on.")] = None,
    mode: Annotated[
        str | None, typer.Option(help="Zenoh mode, peer or client.  [default: as the endpoints need]")
    ] = None,
    zenoh_config: Annotated[
        Path | None,
        typer.Option(
            exists=True,
            dir_okay=False,
            help="Zenoh configuration, such as `bumpless keys` makes; instead of the endpoints.",
        ),
    ] = None,
    memory: Annotated[
        Path | None,
        typer.Option(dir_okay=False, help="File by which a node back from a crash knows that it was flying."),
    ] = None,
    mission: Annotated[
        Path | None, typer.Option(exists=True, dir_okay=False, help="Mission to fly at once.")
    ] = None,
    realtime: Annotated[
        bool, typer.Option("--realtime/--fast", help="Pace to the wall clock, or fly as fast as it goes.")
    ] = True,
) -> None:
    """Run a simulated vehicle on the bus.

    It runs until it is told to stop.

    Exit code 3 means that a vehicle of this id is alive already.
    """
    from bumpless.config.vehicle import VehicleError, load_vehicle
    from bumpless.node import main

    source = name or vehicle_id or "ts100"
    if vehicle_id is None:
        try:
            vehicle_id = load_vehicle(source).id
        except VehicleError as error:
            typer.echo(str(error), err=True)
            raise typer.Exit(1) from error
    raise typer.Exit(
        main(
            vehicle_id,
            vehicle_file=source,
            connect=tuple(connect or ()),
            listen=tuple(listen or ()),
            realtime=realtime,
            mission=mission,
            mode=mode,
            zenoh_config=zenoh_config,
            memory=memory,
        )
    )
