"""Our missions for other programs, each with what does not carry over."""

import csv
import io
import json
from dataclasses import dataclass
from typing import Any
from xml.sax.saxutils import escape

from bumpless.config.mission import Mission
from bumpless.config.mission.origin import Origin
from bumpless_server.plan.exchange.route import Item

WAYPOINT, CHANGE_SPEED, GLOBAL_RELATIVE = 16, 178, 3


class NotExportable(ValueError):
    """The mission lacks what the format needs; the text says what."""


@dataclass(frozen=True)
class Exported:
    """A file of another program."""

    data: bytes
    ending: str
    media_type: str
    items: tuple[Item, ...]


def exported(mission: Mission, to: str) -> Exported:
    """The mission as "plan", "wpl", "geojson", "kml" or "csv". Raises NotExportable."""
    write, ending, media_type = FORMATS[to]
    return Exported(write(mission).encode(), ending, media_type, tuple(_left(mission, to)))


def _left(mission: Mission, to: str) -> list[Item]:
    """What of the mission the format has no place for."""
    lost = {
        "target": "standoff, tolerance and true offset" if to in ("geojson", "kml") else "the dock",
        "environment": "current, waves and bottom",
        "sensors": "changes of the sensors",
        "faults": "faults",
        "parameters": "control parameters",
        "trim": "ballast",
        "end": "the early end",
        "seed": "the seed",
    }
    empty = Mission(
        **{
            k: getattr(mission, k)
            for k in ("version", "name", "vehicle", "duration_s", "start", "legs", "target")
        }
    )
    changed = [k for k in lost if k == "target" or getattr(mission, k) != getattr(empty, k)]
    always = [Item("vehicle, duration and start's heading", False, "the file has no place for them")]
    return always + [Item(k, False, f"{lost[k]}: the file has no place for it") for k in changed]


def _origin(mission: Mission) -> Origin:
    if mission.origin is None:
        raise NotExportable("needs latitudes and longitudes: give the mission an origin")
    return mission.origin


def _places(mission: Mission) -> list[tuple[float, float, float]]:
    """(latitude, longitude, depth) of the waypoints, the start first."""
    origin = _origin(mission)
    return [(*origin.to_geographic(n, e), d) for n, e, d in mission.path_ned_m]


def _plan(mission: Mission) -> str:
    places, items = _places(mission), list[dict[str, Any]]()
    for leg, (latitude, longitude, depth) in zip(mission.legs, places[1:], strict=True):
        for command, params in (
            (CHANGE_SPEED, [1, leg.speed_mps, -1, 0, 0, 0, 0]),
            (WAYPOINT, [0, 0, 0, None, round(latitude, 8), round(longitude, 8), -depth]),
        ):
            item = {"autoContinue": True, "command": command, "doJumpId": len(items) + 1}
            items.append(item | {"frame": GLOBAL_RELATIVE, "params": params, "type": "SimpleItem"})
            if command == WAYPOINT:
                items[-1] |= {"AMSLAltAboveTerrain": None, "Altitude": -depth, "AltitudeMode": 1}
    plan = {
        "fileType": "Plan",
        "geoFence": {"circles": [], "polygons": [], "version": 2},
        "groundStation": "QGroundControl",
        "mission": {
            "cruiseSpeed": mission.legs[0].speed_mps,
            "firmwareType": 3,
            "globalPlanAltitudeMode": 1,
            "hoverSpeed": mission.legs[0].speed_mps,
            "items": items,
            "plannedHomePosition": [round(places[0][0], 8), round(places[0][1], 8), 0],
            "vehicleType": 12,
            "version": 2,
        },
        "rallyPoints": {"points": [], "version": 2},
        "version": 1,
    }
    return json.dumps(plan, indent=2) + "\n"


def _wpl(mission: Mission) -> str:
    places = _places(mission)
    rows = [(0, WAYPOINT, [0.0] * 4, (*places[0][:2], 0.0))]
    for leg, place in zip(mission.legs, places[1:], strict=True):
        rows.append((GLOBAL_RELATIVE, CHANGE_SPEED, [1.0, leg.speed_mps, -1.0, 0.0], (0.0, 0.0, 0.0)))
        rows.append((GLOBAL_RELATIVE, WAYPOINT, [0.0] * 4, (place[0], place[1], -place[2])))
    lines = ["QGC WPL 110"]
    for i, (frame, command, params, (latitude, longitude, altitude)) in enumerate(rows):
        cells = [
            i,
            int(i == 0),
            frame,
            command,
            *params,
            f"{latitude:.8f}",
            f"{longitude:.8f}",
            f"{altitude:.6f}",
            1,
        ]
        lines.append("\t".join(map(str, cells)))
    return "\n".join(lines) + "\n"


def _geojson(mission: Mission) -> str:
    places, target = _places(mission), mission.target
    origin = _origin(mission)
    latitude, longitude = origin.to_geographic(*target.position_ned_m[:2])
    way = {
        "type": "Feature",
        "geometry": {
            "type": "LineString",
            "coordinates": [[round(lon, 8), round(lat, 8), -d] for lat, lon, d in places],
        },
        "properties": {"name": mission.name, "speed_mps": mission.legs[0].speed_mps},
    }
    dock = {
        "type": "Feature",
        "geometry": {
            "type": "Point",
            "coordinates": [round(longitude, 8), round(latitude, 8), -target.position_ned_m[2]],
        },
        "properties": {"name": "target", "heading_deg": (target.heading_deg + origin.heading_deg) % 360.0},
    }
    return json.dumps({"type": "FeatureCollection", "features": [way, dock]}, indent=2) + "\n"


def _kml(mission: Mission) -> str:
    origin = _origin(mission)
    way = " ".join(f"{lon:.8f},{lat:.8f},{-d:g}" for lat, lon, d in _places(mission))
    latitude, longitude = origin.to_geographic(*mission.target.position_ned_m[:2])
    dock = f"{longitude:.8f},{latitude:.8f},{-mission.target.position_ned_m[2]:g}"
    mode = "<altitudeMode>absolute</altitudeMode>"
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2"><Document>\n'
        f"<name>{escape(mission.title or mission.name)}</name>\n"
        f"<Placemark><name>{escape(mission.name)}</name><LineString>{mode}"
        f"<coordinates>{way}</coordinates></LineString></Placemark>\n"
        f"<Placemark><name>target</name><Point>{mode}<coordinates>{dock}</coordinates></Point></Placemark>\n"
        "</Document></kml>\n"
    )


def _csv(mission: Mission) -> str:
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\n")
    head = ["north_m", "east_m", "depth_m", "speed_mps"]
    table.writerow(head if mission.origin is None else [*head, "latitude_deg", "longitude_deg"])
    speeds = [mission.start.speed_mps, *(leg.speed_mps for leg in mission.legs)]
    for place, speed in zip(mission.path_ned_m, speeds, strict=True):
        row = [*(f"{value:g}" for value in place), f"{speed:g}"]
        if mission.origin is not None:
            row += [f"{value:.8f}" for value in mission.origin.to_geographic(*place[:2])]
        table.writerow(row)
    return out.getvalue()


FORMATS = {
    "plan": (_plan, ".plan", "application/json"),
    "wpl": (_wpl, ".waypoints", "text/plain"),
    "geojson": (_geojson, ".geojson", "application/geo+json"),
    "kml": (_kml, ".kml", "application/vnd.google-earth.kml+xml"),
    "csv": (_csv, ".csv", "text/csv"),
}
