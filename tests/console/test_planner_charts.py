"""Charts beneath the plan in a real browser: places both ways, depths, the sea floor and its clearance."""

import re
from typing import Any

from playwright.sync_api import Page, expect

from bumpless.config.mission.origin import Origin
from tests.console import planner
from tests.console.contract_server import ContractServer
from tests.console.test_axe import faults
from tests.console.test_planner import TEXT, keep, planned, yaml

__all__ = ["planned"]  # the fixture
ORIGIN = Origin(latitude_deg=54.4, longitude_deg=10.2, heading_deg=20.0)
PLACED = f"{TEXT}origin: {{latitude_deg: 54.4, longitude_deg: 10.2, heading_deg: 20}}\n"


def chart(name: str, kind: str, geographic: bool = False) -> dict[str, Any]:
    """A chart in the list."""
    known = {"title": name, "format": "a file", "file_name": name, "size": 100, "sha256": "0" * 64}
    more = {"stored": "2026-01-01T00:00:00Z", "geographic": geographic, "missions": [], "notes": []}
    return {"name": name, "kind": kind, **known, **more}


def shown(name: str, kind: str, **more: Any) -> dict[str, Any]:
    """What is drawn of it."""
    return {
        "name": name,
        "kind": kind,
        "corners": None,
        "features": [],
        "depths": None,
        "picture": "",
        **more,
    }


def with_charts(server: ContractServer) -> None:
    """A depth grid in the mission's frame, and shapes that lie on the earth."""
    server.reply("GET", "charts", [chart("bay.asc", "depths"), chart("pier.geojson", "features", True)])
    depths = {"rows": 2, "columns": 2, "depth_m": [2, 8, 2, 8], "least_m": 2, "deepest_m": 8}
    corners = [[30, -10], [30, 10], [-5, 10], [-5, -10]]
    server.reply("GET", "charts/bay.asc/shown", shown("bay.asc", "depths", depths=depths, corners=corners))
    pier = {"kind": "line", "name": "pier", "colour": "", "parts": [[[0, 4], [20, 4]]]}
    server.reply("GET", "charts/pier.geojson/shown", shown("pier.geojson", "features", features=[pier]))


def reopened(page: Page, server: ContractServer, text: str) -> None:
    """The mission opened anew with another text."""
    keep(server, text)
    page.reload()
    expect(page.get_by_label("State of the forecast")).to_have_text("up to date")


def test_places_are_told_and_typed_on_the_earth(planned: Page, server: ContractServer) -> None:
    """Protects both ways of a place: what the console shows is what the server's origin says."""
    reopened(planned, server, PLACED)
    planner.click(planned, 10, 0)
    latitude, longitude = ORIGIN.to_geographic(10.0, 0.0)
    expect(planned.get_by_label("Latitude", exact=True)).to_have_value(f"{round(latitude, 7):.10g}")
    expect(planned.get_by_label("Longitude", exact=True)).to_have_value(f"{round(longitude, 7):.10g}")
    expect(planned.get_by_label("Pointer")).to_contain_text(re.compile(r"54\.4000\d\d° N 10\.2000\d\d° E"))
    wanted = ORIGIN.to_geographic(12.0, 3.0)
    planned.get_by_label("Latitude", exact=True).fill(f"{wanted[0]:.7f}")
    planned.get_by_label("Longitude", exact=True).fill(f"{wanted[1]:.7f}")
    found = re.search(r"to_ned_m: \[([\d.]+), ([\d.]+), 2\.0\]", yaml(planned))
    assert found is not None
    assert abs(float(found[1]) - 12) < 0.02 and abs(float(found[2]) - 3) < 0.02


def test_charts_are_shown_hidden_and_made_the_sea_floor(planned: Page, server: ContractServer) -> None:
    """Protects overlays and depths: what lies on the earth waits for an origin, a grid becomes the floor."""
    with_charts(server)
    reopened(planned, server, TEXT)
    planned.get_by_role("button", name="Charts").click()
    details = planned.get_by_label("Details", exact=True)
    expect(details).to_contain_text("give the mission an origin")
    expect(details.get_by_role("checkbox", name="pier.geojson")).to_be_disabled()
    grid = details.get_by_role("checkbox", name="bay.asc")
    expect(grid).to_be_checked()
    assert not faults(planned)
    details.get_by_role("button", name="Sea floor").click()
    expect(details.get_by_role("button", name="Sea floor")).to_have_attribute("aria-pressed", "true")
    grid.uncheck()
    text = yaml(planned)
    assert "sea_floor:" in text and "grid: bay.asc" in text and "clearance_m: 1" in text
    planned.get_by_role("button", name="Undo").click()
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")
    reopened(planned, server, PLACED)
    query = server.wait_for_call("GET", "charts/pier.geojson/shown").query
    assert query == "latitude_deg=54.4&longitude_deg=10.2&heading_deg=20"
    planned.get_by_role("button", name="Charts").click()
    expect(details.get_by_role("checkbox", name="bay.asc")).not_to_be_checked()  # the choice stays


def test_a_picture_is_laid_on_its_corners_and_a_bad_file_says_why(
    planned: Page, server: ContractServer
) -> None:
    """Protects bringing charts in: bytes as they are, corners as typed, a refusal in the server's words."""
    planned.get_by_role("button", name="Charts").click()
    refused = {"detail": "harbour.png is no picture that can be read"}
    server.reply("PUT", "charts/harbour.png", refused, 422)
    planned.get_by_label("Its numbers are metres").check()
    file = {"name": "harbour.png", "mimeType": "image/png", "buffer": b"no picture"}
    planned.get_by_label("Chart file").set_input_files([file])  # type: ignore[list-item]
    lay = planned.get_by_role("button", name="Lay it there")
    expect(lay).to_be_disabled()
    planned.get_by_label("Corners of the picture").fill("9,0; 9,5; 0,5; 0,0")
    lay.click()
    call = server.wait_for_call("PUT", "charts/harbour.png")
    assert call.body == "no picture" and "local=true" in call.query and "corners=9%2C0%3B" in call.query
    expect(planned.get_by_role("alert")).to_contain_text("no picture that can be read")


def test_the_sea_floor_stands_under_the_way_with_its_clearance(planned: Page, server: ContractServer) -> None:
    """Protects the profile's floor and the clearance that is told of the plan and of the flight."""
    floor = {
        "along_m": [0, 10, 20],
        "north_m": [0, 10, 20],
        "east_m": [0, 0, 0],
        "depth_m": [2, 2, 2],
        "floor_m": [6, 5, None],
        "wanted_m": 1.0,
        "least_m": 2.9,
    }

    def foresee(_: dict[str, Any]) -> list[dict[str, Any]]:
        findings, nominal, *rest = planner.forecast(198)
        return [{**findings, "floor": floor}, {**nominal, "least_clearance_m": 2.7}, *rest]

    server.foresee = foresee
    planned.reload()
    expect(planned.get_by_label("Depth profile").first).to_contain_text("clearance 2.9 m")
    expect(planned.get_by_label("Forecast", exact=True)).to_contain_text("2.7 m")


def test_a_base_map_is_fetched_only_where_an_address_is_set(planned: Page, server: ContractServer) -> None:
    """Protects who is offline and unseen: no tile by default, then those of the named server alone."""
    asked: list[str] = []
    planned.on("request", lambda request: asked.append(request.url))
    reopened(planned, server, PLACED)
    planner.click(planned, 10, 0)
    assert not any("/tiles/" in url for url in asked if "/api/" not in url)
    tiles = {"address": f"{server.url}tiles/{{z}}/{{x}}/{{y}}.png", "attribution": "© somebody"}
    server.reply("GET", "charts/tiles", tiles)
    with planned.expect_request(re.compile(r"/tiles/19/\d+/\d+\.png")):
        planned.reload()


def test_a_chart_is_kept_to_one_mission_and_taken_into_another(planned: Page, server: ContractServer) -> None:
    """Protects: one mission's overlays do not lie beneath every other, and none is lost from sight."""
    mine = {**chart("bay.asc", "depths"), "missions": ["harbour"]}
    other = {**chart("pier.geojson", "features"), "missions": ["tank"]}
    server.reply("GET", "charts", [chart("bay.asc", "depths"), other])
    for each in ("bay.asc", "pier.geojson"):
        server.reply("PUT", f"charts/{each}/owners", mine)
        server.reply("GET", f"charts/{each}/shown", shown(each, "features"))
    reopened(planned, server, TEXT)
    planned.get_by_role("button", name="Charts").click()
    own = planned.get_by_role("button", name="This mission", exact=True)
    expect(own).to_have_count(1)  # the other mission's chart is not beneath this one
    expect(own).to_have_attribute("aria-pressed", "false")
    server.reply("GET", "charts", [mine, other])
    own.click()
    assert server.wait_for_call("PUT", "charts/bay.asc/owners").json() == {"missions": ["harbour"]}
    expect(own).to_have_attribute("aria-pressed", "true")
    planned.get_by_text("Of other missions").click()
    planned.get_by_role("button", name="Here too").click()
    taken = server.wait_for_call("PUT", "charts/pier.geojson/owners").json()
    assert taken == {"missions": ["tank", "harbour"]}
