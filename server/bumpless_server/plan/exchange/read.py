"""A foreign file of whatever kind: what it is, its way, and the mission made of it."""

import json
from dataclasses import dataclass

from bumpless.config.text import BOM, NotText, decoded, foreign_kind
from bumpless_server.plan.exchange.charts import KML, read_geojson, read_kml
from bumpless_server.plan.exchange.hostile import unpacked
from bumpless_server.plan.exchange.mavlink import read_plan, read_wpl
from bumpless_server.plan.exchange.mission_text import mission_text
from bumpless_server.plan.exchange.moos import read_bhv
from bumpless_server.plan.exchange.neptus import NEPTUS, read_nmis
from bumpless_server.plan.exchange.route import Item, NotImportable, Route
from bumpless_server.plan.exchange.table import read_csv

_TABLES = (".csv", ".tsv", ".txt")


@dataclass(frozen=True)
class Imported:
    """A mission made of a foreign file, and what became of each thing in it."""

    kind: str
    yaml: str
    items: tuple[Item, ...]
    parts: tuple[str, ...] = ()  # names that `part` may take


def imported(data: bytes, file_name: str, vehicle: str, part: str | None = None) -> Imported:
    """The mission that a foreign file holds, for a vehicle. Raises NotImportable with the reason.

    part: which of several ways, by its name.
    """
    route = read_route(data, file_name, part)
    if not route.points:
        left = [item for item in route.items if not item.carried]
        steps = [item for item in left if ":" in item.what]  # "item 3: ..."; not what stands around them
        reasons = [f"{item.what}: {item.note}" for item in (steps or left)[:3]]
        raise NotImportable("holds no place to go to" + (f" ({'; '.join(reasons)})" if reasons else ""))
    return Imported(route.kind, mission_text(route, file_name, vehicle), tuple(route.items), route.parts)


def read_route(data: bytes, file_name: str, part: str | None = None) -> Route:
    """The way in a file, by what its bytes are; its name decides only where they leave it open."""
    name, start = file_name.lower(), data[:4096].removeprefix(BOM.encode())
    if not data.strip():
        raise NotImportable("is empty")
    if start.startswith(b"PK\x03\x04"):
        inside, content = unpacked(data, ".nmis", ".kml", "mission.xml")
        return read_route(content, inside, part)
    if start.lstrip().startswith(b"<"):
        return _xml(data, start, part)
    kind = foreign_kind(data)
    text = _text(data, file_name, kind)
    if start.lstrip().startswith((b"{", b"[")):
        return _json(text)
    if kind is not None and "WPL" in kind:
        return read_wpl(text)
    if name.endswith((".bhv", ".bhv.txt")) or "behavior" in text[:20_000].lower().split("=")[0]:
        return read_bhv(text, part)
    if kind is not None and "MOOS" not in kind:
        raise NotImportable(f"is {kind}, which holds no mission that could be imported")
    if kind is not None:
        return read_bhv(text, part)
    if name.endswith(_TABLES):
        return read_csv(text)
    raise NotImportable("is of no kind that is known: .plan, WPL, GeoJSON, KML, CSV, .bhv, .nmis")


def _xml(data: bytes, start: bytes, part: str | None) -> Route:
    lower = start.lower()
    if b"<kml" in lower or b"opengis.net/kml" in lower:
        return read_kml(data)
    if b"mission-def" in lower or b"neptus" in lower:
        return read_nmis(data, part)
    kind = foreign_kind(data)
    if kind is not None and kind != "an XML file":
        raise NotImportable(f"is {kind}, which holds no mission that could be imported")
    raise NotImportable(f"is an XML file, but neither {KML} nor {NEPTUS}")


def _json(text: str) -> Route:
    try:
        tree = json.loads(text.removeprefix(BOM))
    except (ValueError, RecursionError) as error:
        raise NotImportable(f"is not valid JSON: {error}") from None
    if isinstance(tree, dict) and ("mission" in tree or tree.get("fileType") == "Plan"):
        if tree.get("fileType") not in (None, "Plan"):
            raise NotImportable(f"is a {tree['fileType']} file of QGroundControl, not a plan")
        return read_plan(text)
    return read_geojson(text)


def _text(data: bytes, file_name: str, kind: str | None) -> str:
    try:
        return decoded(data, file_name)
    except NotText as error:
        raise NotImportable(f"is {kind}" if kind else error.problem.rule) from None
