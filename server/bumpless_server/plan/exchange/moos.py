"""MOOS-IvP's behaviour files: the points of BHV_Waypoint, with the depth of BHV_ConstantDepth."""

import re

from bumpless_server.plan.exchange.route import NotImportable, Point, Route, number

MOOS = "a MOOS-IvP behaviour file"
_BLOCK = re.compile(r"^\s*Behavior\s*=\s*(\w+)\s*\{([^{}]*)\}", re.IGNORECASE | re.MULTILINE)
_WAYS = ("points", "point", "polygon")
_KNOWN = {"name", *_WAYS, "speed"}


def read_bhv(text: str, part: str | None = None) -> Route:
    """One behaviour's points; x is east and y is north, in m from the mission's datum.

    part: the behaviour's name; by default the first with points.
    """
    text = "\n".join(line.partition("//")[0] for line in text.splitlines())
    route = Route(MOOS, geographic=False)
    blocks = [(kind, _fields(body)) for kind, body in _BLOCK.findall(text)]
    if not blocks:
        raise NotImportable("holds no behaviour")
    depth = _depth(blocks)
    ways = [fields for kind, fields in blocks if kind.upper() == "BHV_WAYPOINT" and fields.keys() & {*_WAYS}]
    route.parts = tuple(fields.get("name", "") for fields in ways)
    if part is not None and part not in route.parts:
        raise NotImportable(f"has no behaviour {part!r} with points; there are {', '.join(route.parts)}")
    for kind, fields in blocks:
        what = f"{kind} {fields.get('name', '')}".strip()
        if kind.upper() == "BHV_CONSTANTDEPTH":
            route.carried(what, "is the depth of every waypoint")
        elif kind.upper() != "BHV_WAYPOINT":
            route.left(what, "other behaviours are not flown")
        elif route.points or (part is not None and fields.get("name", "") != part):
            route.left(what, "one way is imported at a time")
        else:
            _way(route, what, fields, depth)
    return route


def _way(route: Route, what: str, fields: dict[str, str], depth: float | None) -> None:
    given = next((fields[name] for name in _WAYS if name in fields), None)
    if given is None:
        route.left(what, "it has no points: they are given while it runs")
        return
    if "format=" in given.replace(" ", ""):
        route.left(what, f"a pattern ({given[:40]}) is made by MOOS; list its points")
        return
    speed = number(fields["speed"], f"{what}, speed") if "speed" in fields else None
    for k, pair in enumerate(re.sub(r"^pts\s*=\s*\{|\}.*$", "", given.strip()).split(":"), 1):
        values = [number(v, f"{what}, point {k}") for v in pair.split(",") if v.strip()]
        if len(values) < 2:
            raise NotImportable(f"{what}, point {k} is {pair[:40]!r}, not x,y")
        own = values[2] if len(values) > 2 else depth
        route.points.append(Point(values[1], values[0], own, speed))
    route.carried(what, f"{len(route.points)} points")
    for name in sorted(fields.keys() - _KNOWN):
        route.left(f"{what}, {name}", "conditions, flags and radii belong to the helm")


def _depth(blocks: list[tuple[str, dict[str, str]]]) -> float | None:
    found = [fields.get("depth") for kind, fields in blocks if kind.upper() == "BHV_CONSTANTDEPTH"]
    return number(found[0], "the depth") if found and found[0] else None


def _fields(body: str) -> dict[str, str]:
    """The last value of each field; `=` in a value stays in it."""
    pairs = (line.partition("=") for line in body.splitlines())
    return {name.strip().lower(): value.strip() for name, equals, value in pairs if equals}
