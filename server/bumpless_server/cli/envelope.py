"""`bumpless envelope`: what a vehicle's actuators can do at a speed."""

import json
from typing import TYPE_CHECKING, Annotated, Any

import typer

from bumpless.contract.units import WRENCH

if TYPE_CHECKING:
    from bumpless.physics.envelope import Hull

FORCE, MOMENT = WRENCH[:3], WRENCH[3:]


def envelope(
    vehicle: Annotated[str, typer.Option(help="Vehicle id, or a vehicle file (.toml).")] = "ts100",
    speed: Annotated[float, typer.Option(help="Surge speed through the water, m/s.")] = 0.2,
    sampled: Annotated[bool, typer.Option(help="Also sample commands, as the paper does (Table 3).")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Print the attainable force and moment sets."""
    from bumpless.config.vehicle import VehicleError, load_vehicle
    from bumpless.physics.envelope import attainable_sets, sampled_sets
    from bumpless.physics.model import build_model

    try:
        loaded = load_vehicle(vehicle)
    except VehicleError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(1) from error
    model = build_model(loaded)
    sets = attainable_sets(model, speed)
    result: dict[str, Any] = {
        "vehicle": loaded.id,
        "vehicle_sha256": loaded.sha256,
        "surge_speed_mps": speed,
        "force": _figures(sets.force, FORCE),
        "moment": _figures(sets.moment, MOMENT),
    }
    if sampled:
        result["sampled"] = {
            group: {"force": _figures(s.force, FORCE), "moment": _figures(s.moment, MOMENT)}
            for group, s in sampled_sets(model, speed).items()
        }
    typer.echo(json.dumps(result, indent=2) if as_json else _text(result))


def _figures(hull: "Hull", axes: tuple[str, ...]) -> dict[str, Any]:
    low, high = hull.vertices.min(axis=0), hull.vertices.max(axis=0)
    extent = {axis: [float(a), float(b)] for axis, a, b in zip(axes, low, high, strict=True)}
    return {"extent": extent, "volume": hull.volume, "area": hull.area}


def _text(result: dict[str, Any]) -> str:
    lines = [f"{result['vehicle']} at {result['surge_speed_mps']:g} m/s"]
    for group, sets in {"all actuators, exact": result, **result.get("sampled", {})}.items():
        for name, unit in (("force", "N"), ("moment", "N·m")):
            figures = sets[name]
            spans = ", ".join(f"{axis} {a:.3f} to {b:.3f}" for axis, (a, b) in figures["extent"].items())
            size = f"volume {figures['volume']:.4g} ({unit})³, area {figures['area']:.4g} ({unit})²"
            lines.append(f"  {group}, {name}: {spans} {unit}; {size}")
    return "\n".join(lines)
