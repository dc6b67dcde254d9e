"""What the planner is told in its tests, and its drawing by metres."""

import hashlib
from typing import Any

from playwright.sync_api import Page, expect

from bumpless.config.formats import field_catalogue
from bumpless.config.vehicle import load_vehicle
from bumpless_server.web.answers.planning import Planning
from tests.console.contract_server import ContractServer

VEHICLE = "ts100"
MODES = ("F", "F", "R", "H")


def default_replies(server: ContractServer) -> None:
    """What the planner asks once: the vehicle's figures, the fields, the templates."""
    server.reply("GET", "planning", [VEHICLE])
    server.reply("GET", f"planning/{VEHICLE}", Planning.of(load_vehicle(VEHICLE)).model_dump())
    server.reply("GET", "fields/mission", field_catalogue("mission"))
    server.reply("GET", "mission-templates", [])
    server.reply("GET", "drafts", [])
    server.reply("GET", "charts", [])


def forecast(
    docked: int,
    of: int = 200,
    findings: list[dict[str, Any]] | None = None,
    station: dict[str, Any] | None = None,
) -> list[dict[str, Any]]:
    """Every message of a request that goes well: a straight flight north in F, R and H."""
    north = [0.0, 10.0, 20.0, 22.5]
    track = {
        "t_s": [0.0, 15.0, 30.0, 40.0],
        "north_m": north,
        "east_m": [0.0] * 4,
        "depth_m": [2.0, 2.0, 2.1, 2.0],
        "heading_deg": [0.0] * 4,
        "mode": list(MODES),
        "speed_m_s": [0.7, 0.7, 0.3, 0.0],
        "depth_error_m": [0.0, 0.0, 0.1, 0.0],
        "saturation": [0.2, 0.9, 1.0, 0.4],
        "worst_actuator": ["n_p"] * 4,
        "margin": [],
        "floor_m": [],
        "clearance_m": [],
    }
    flown = [
        {
            "number": i,
            "seed": 1000 + i,
            "outcome": "docked" if i < docked else "waved_off",
            "end_s": 60.0,
            "closest_m": 0.4 if i < docked else 3.0 + i / 1000,
            "north_m": north,
            "east_m": [0.0, 0.1, 0.1, 0.0],
            "depth_m": [2.0] * 4,
            "clearance_m": None,
        }
        for i in range(of)
    ]
    counts = {"docked": docked, "waved_off": of - docked}
    share = docked / of
    chance = {"docked": docked, "of": of, "low": max(0.0, share - 0.03), "high": min(1.0, share + 0.02)}
    nominal = {
        "kind": "nominal",
        "track": track,
        "switches": [{"t_s": 30.0, "from": "F", "to": "R"}, {"t_s": 40.0, "from": "R", "to": "H"}],
        "outcome": {
            "ending": "docked",
            "reason": "in hover for 10 s",
            "basis": "true",
            "mode": "H",
            "held_s": 10.0,
            "closest_m": 0.5,
            "closest_s": 50.0,
            "true_errors": None,
            "believed_errors": None,
            "tries": 1,
        },
        "arrival_s": 40.0,
        "energy_j": 55.0,
        "length_m": 22.6,
        "least_clearance_m": None,
        "sha256": "0" * 64,
        "seed": 1,
        "digest": "",
        "elapsed_ms": 40.0,
    }
    return [
        {"kind": "findings", "findings": findings or [], "floor": None, "station": station},
        nominal,
        {"kind": "fan", "flights": flown, "done": of, "of": of, "chance": {**chance, "counts": counts}},
        {"kind": "done"},
    ]


def hopeless(heading: float) -> dict[str, Any]:
    """A finding that blocks the start, mended by another heading of the dock."""
    return {
        "severity": "hard",
        "code": "current_not_holdable",
        "path": "target.heading_deg",
        "line": 20,
        "column": 3,
        "reason": "At 0° ts100 can't hold station in this current, for want of sideways thrust.",
        "change": "Can be held: 88° to 92°.",
        "mends": [{"label": f"Approach with {heading:.0f}°", "path": "target.heading_deg", "value": heading}],
    }


def doubtful(code: str) -> dict[str, Any]:
    """A finding that lowers the chance, of another leg and depth."""
    mend = {"label": "Longer", "path": "duration_s", "value": 400.0}
    return {**hopeless(90), "severity": "soft", "code": code, "reason": f"For {code}.", "mends": [mend]}


def stored(name: str, text: str, **more: Any) -> dict[str, Any]:
    """A mission file as the server tells it."""
    digest = hashlib.sha256(text.encode()).hexdigest()
    entry = {"name": name, "file": f"{name}.yaml", "title": name, "summary": "", "vehicle": VEHICLE}
    state = {"duration_s": 90.0, "seed": 1, "sha256": digest, "builtin": False, "valid": True, "problems": []}
    return {**entry, **state, "modified": "2026-01-01T00:00:00Z", "yaml": text, **more}


def at(page: Page, north: float, east: float) -> tuple[float, float]:
    """Where a place of the plan is on the page, px, once what was done before is drawn."""
    page.evaluate("new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)))")
    canvas = page.get_by_role("application", name="Plan from above").locator("canvas")
    x, y, scale, turn = map(float, (canvas.get_attribute("data-frame") or "").split())
    assert turn == 0.0
    box = canvas.bounding_box()
    assert box is not None
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    return middle[0] + (east - x) * scale, middle[1] - (north - y) * scale


def click(page: Page, north: float, east: float) -> None:
    """Click a place of the plan."""
    page.mouse.click(*at(page, north, east))


def drag(page: Page, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Drag from one place of the plan to another, NE, m."""
    page.mouse.move(*at(page, *start))
    page.mouse.down()
    page.mouse.move(*at(page, *end), steps=5)
    page.mouse.up()


def drag_current(page: Page, right: float, down: float) -> None:
    """Drag the arrow of the current's dial, px."""
    box = page.get_by_role("application", name="Plan from above").locator("canvas").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 62, box["y"] + 66)
    page.mouse.down()
    page.mouse.move(box["x"] + 62 + right, box["y"] + 66 + down, steps=4)
    page.mouse.up()


def draw_zone(page: Page, *corners: tuple[float, float]) -> None:
    """A keep-out zone, corner by corner."""
    page.get_by_role("button", name="Keep out").click()
    for north, east in corners:
        click(page, north, east)
    page.get_by_role("status", name="Next step").get_by_role("button", name="Close it").click()


def draw(page: Page) -> None:
    """A new mission: three waypoints, and a dock with a heading."""
    page.get_by_role("button", name="New mission").click()
    next_step = page.get_by_role("status", name="Next step")
    expect(next_step).to_contain_text("each click is a waypoint")
    for north, east in ((8, 0), (16, 0), (24, 0)):
        click(page, north, east)
    next_step.get_by_role("button", name="Place the dock").click()
    drag(page, (36, 0), (39, 0))
