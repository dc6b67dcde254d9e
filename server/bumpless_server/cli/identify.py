"""`bumpless identify`: a vehicle's thrust, lift and drag from the logs of its flights."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from bumpless.contract.exits import MISUSED, REFUSED

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle
    from bumpless.identify import Change, Estimate, Found


def identify(
    logs: Annotated[
        list[Path], typer.Argument(help="MCAP files of one vehicle.", exists=True, dir_okay=False)
    ],
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", dir_okay=False, help="Vehicle file (.toml) to write it into."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Find out how a vehicle's thrust, lift and drag differ from its file.

    A flight tells them by a start, a brake, turns and a hover; what it doesn't tell is left as it is.

    Exit codes: 0 found or nothing told, 1 refused (the logs are of several vehicles, or hold too little),
    2 wrong usage.
    """
    from bumpless_server.cli.extras import need

    need("log", "mcap")
    import bumpless
    from bumpless.config.whole import write_text
    from bumpless.identify import changes, flight_of, learned_text
    from bumpless.identify import identify as fitted

    if out is not None and out.with_name(out.stem + ".control.toml").exists():
        typer.echo(f"bumpless identify: {out.stem}.control.toml lies beside; name another file", err=True)
        raise typer.Exit(MISUSED)
    try:
        runs = [bumpless.open_run(log) for log in logs]
        vehicle = _one([run.vehicle for run in runs])
        found = fitted([flight_of(run) for run in runs], vehicle)
        if out is not None:
            write_text(out, learned_text(vehicle, found.factors))
    except (ValueError, OSError) as error:
        typer.echo(f"bumpless identify: {error}", err=True)
        raise typer.Exit(REFUSED) from error
    changed = changes(vehicle, found.factors)
    if as_json:
        typer.echo(json.dumps(_as_dict(vehicle, found, changed), indent=2))
        return
    typer.echo(_text(vehicle, found, changed))
    if out is not None:
        typer.echo(f"\nWritten to {out}.")


def _one(vehicles: "list[Vehicle | None]") -> "Vehicle":
    known = [vehicle for vehicle in vehicles if vehicle is not None]
    if len(known) < len(vehicles):
        raise ValueError("a log describes no vehicle that can be read")
    if len({vehicle.sha256 for vehicle in known}) > 1:
        raise ValueError("the logs are of vehicles whose files differ; identify from those of one")
    return known[0]


def _text(vehicle: "Vehicle", found: "Found", changed: "list[Change]") -> str:
    from bumpless_server.cli.tables import table

    rows = [[one.scale.title, *_figures(one), _said(one, found.sound(one))] for one in found.estimates]
    left_out = f", {found.left_out_s:.0f} s left out" if found.left_out_s >= 1.0 else ""
    parts = [
        f"{vehicle.id}, {found.flown_s:.0f} s of flight{left_out}; 1 is as in the vehicle's file",
        table(["", "scale", "95 % interval", "which is"], rows),
    ]
    if changed:
        lines = [[one.path, f"{one.before:g}", f"{one.after:g}"] for one in changed]
        parts.append(table(["in the vehicle's file", "now", "as found"], lines))
    return "\n\n".join(parts)


def _figures(one: "Estimate") -> list[str]:
    low, high = one.interval
    return [f"{one.value:.3f}" if one.told else "-", f"{low:.2f} to {high:.2f}"]


def _said(one: "Estimate", sound: bool) -> str:
    if not one.told:
        return "not told by these flights"
    if not one.steady:
        return "not the same all the time: a fault, a load, something caught in it?"
    if not sound:
        return "doubtful: what it is weighed against was not the same all the time"
    low, high = one.interval
    if low <= 1.0 <= high:
        return "maybe as the file says"
    return f"{100.0 * abs(one.value - 1.0):.0f} % {'less' if one.value < 1.0 else 'more'} than the file says"


def _as_dict(vehicle: "Vehicle", found: "Found", changed: "list[Change]") -> dict[str, Any]:
    return {
        "vehicle": vehicle.id,
        "vehicle_sha256": vehicle.sha256,
        "flown_s": found.flown_s,
        "left_out_s": found.left_out_s,
        "scales": [
            {
                "what": one.scale.what,
                "actuators": list(one.scale.names),
                "scale": one.value,
                "interval": list(one.interval),
                "told": one.told,
                "steady": found.sound(one),
            }
            for one in found.estimates
        ],
        "changes": [{"path": one.path, "before": one.before, "after": one.after} for one in changed],
    }
