"""The planner's drawing tools in a real browser: zones, sea, faults and outages, and the plan in space."""

import math
import re

from playwright.sync_api import Page, expect

from tests.console import planner
from tests.console.contract_server import ContractServer
from tests.console.test_axe import faults
from tests.console.test_planner import planned, yaml

__all__ = ["planned"]  # the fixture


def test_a_zone_is_drawn_corner_by_corner_edited_by_its_corners_and_undone(planned: Page) -> None:
    """Protects keep-out zones by mouse: drawn, broken at a side, moved whole, deleted, each one step."""
    planner.draw_zone(planned, (4, 4), (9, 4), (9, 9), (4, 9))
    expect(planned.get_by_role("heading", name="Keep-out zone 1")).to_be_visible()
    planned.get_by_label("Lower end").fill("3")
    planner.drag(planned, (9, 9), (10, 11))
    expect(planned.get_by_role("heading", name="Keep-out zone 1, corner 3")).to_be_visible()
    text = yaml(planned)
    assert "- {north_m: 10, east_m: 11}" in text and "to_depth_m: 3" in text and "# enough" in text
    planned.get_by_role("button", name="Details").click()
    planned.get_by_role("button", name="The whole outline").click()
    planner.drag(planned, (6, 6), (6, 8))  # taken hold of inside
    assert "- {north_m: 10, east_m: 13}" in yaml(planned)
    planned.get_by_role("application", name="Plan from above").focus()
    planned.keyboard.press("Delete")
    assert "keep_out" not in yaml(planned)
    for _ in range(5):
        planned.get_by_role("button", name="Undo").click()
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")


def test_a_boundary_is_one_drag_and_its_corners_go_by_keys(planned: Page) -> None:
    """Protects the keep-in boundary as a rectangle, and corners without a pointer."""
    planned.get_by_role("application", name="Plan from above").focus()
    planned.keyboard.press("b")
    planner.drag(planned, (-4, -6), (30, 8))
    expect(planned.get_by_role("heading", name="Keep-in boundary", exact=True)).to_be_visible()
    planned.keyboard.press("]")
    planned.keyboard.press("ArrowDown")
    text = yaml(planned)
    assert "keep_in:" in text and "- {north_m: -4.5, east_m: -6}" in text
    assert "- {north_m: 30, east_m: 8}" in text


def test_waves_are_drawn_as_the_current_is(planned: Page) -> None:
    """Protects the waves' dial: a drag on the water gives height and direction, its form the rest."""
    planned.get_by_role("button", name="Waves").click()
    x, y = planner.at(planned, 20, 8)
    planned.mouse.move(x, y)
    planned.mouse.down()
    planned.mouse.move(x + 21, y, steps=4)  # half the dial's radius, eastward
    planned.mouse.up()
    expect(planned.get_by_role("heading", name="Waves")).to_be_visible()
    expect(planned.get_by_label("Height from trough to crest")).to_have_value("0.25")
    assert "direction_deg: 90" in yaml(planned)


def test_faults_and_outages_are_dragged_along_the_time(planned: Page) -> None:
    """Protects the timeline: added, moved by pointer and keys, another actuator chosen, undone."""
    line = planned.get_by_label("Faults and outages")
    line.get_by_role("button", name="Add a fault").click()
    fault = line.get_by_role("button", name="Fault of delta_1 from 30.0 s, 0 % left")
    expect(fault).to_be_visible()
    line.get_by_label("Actuator of fault 1").select_option(index=1)
    line.get_by_role("button", name="Add an outage: Sight").click()
    outage = line.get_by_role("button", name="Target not seen from 30.0 to 40.0 s")
    box = outage.bounding_box()
    assert box is not None
    planned.mouse.move(box["x"] + box["width"] - 3, box["y"] + 5)
    planned.mouse.down()
    planned.mouse.move(box["x"] + 2 * box["width"] - 3, box["y"] + 5, steps=4)
    planned.mouse.up()
    outage = line.get_by_role("button", name="Target not seen from 30.0 to 50.0 s")
    expect(outage).to_be_visible()
    outage.focus()
    planned.keyboard.press("ArrowRight")
    planned.keyboard.press("Alt+ArrowLeft")
    text = yaml(planned)
    assert "{from_s: 31, to_s: 50}" in text and "at_s: 30, effectiveness: 0}" in text
    assert "actuator: delta_2," in text
    assert not faults(planned)
    for _ in range(6):
        planned.keyboard.press("ControlOrMeta+z")
    expect(line.locator(".event-bar")).to_have_count(0)


def seen(page: Page, north: float, east: float, down: float) -> tuple[float, float]:
    """Where a place of the plan in space is on the page, px."""
    canvas = page.get_by_label("Plan in space", exact=True).locator("canvas")
    n, e, d, azimuth, elevation, far = map(float, (canvas.get_attribute("data-frame") or "").split())
    box = canvas.bounding_box()
    assert box is not None
    dn, de, du = north - n, east - e, d - down
    ahead = math.cos(azimuth) * dn + math.sin(azimuth) * de
    right = math.cos(azimuth) * de - math.sin(azimuth) * dn
    up = math.sin(elevation) * ahead + math.cos(elevation) * du
    depth = far + math.cos(elevation) * ahead - math.sin(elevation) * du
    scale = box["height"] / 2 / math.tan(math.radians(20)) / depth
    return box["x"] + box["width"] / 2 + scale * right, box["y"] + box["height"] / 2 - scale * up


def test_the_plan_in_space_selects_and_edits_the_same_document(planned: Page, server: ContractServer) -> None:
    """Protects the third linked view: a waypoint chosen or dragged there is chosen and moved everywhere."""
    planned.get_by_role("button", name="3-D").click()
    space = planned.get_by_label("Plan in space", exact=True)
    expect(space.locator("canvas")).to_have_attribute("data-frame", re.compile("^13"))
    planned.mouse.click(*seen(planned, 10, 0, 2))
    expect(planned.get_by_role("heading", name="Waypoint 1")).to_be_visible()
    planned.mouse.move(*seen(planned, 10, 0, 2))
    planned.mouse.down()
    planned.mouse.move(*seen(planned, 8, 2, 2), steps=5)
    planned.mouse.up()
    expect(planned.get_by_label("End of the leg north, legs[0].to_ned_m")).to_have_value("8")
    expect(planned.get_by_label("End of the leg east, legs[0].to_ned_m")).to_have_value("2")
    planned.keyboard.down("Shift")
    planned.mouse.move(*seen(planned, 8, 2, 2))
    planned.mouse.down()
    planned.mouse.move(*seen(planned, 8, 2, 3), steps=5)
    planned.mouse.up()
    planned.keyboard.up("Shift")
    depth = planned.get_by_label("End of the leg down, legs[0].to_ned_m").input_value()
    assert 2.6 <= float(depth) <= 3.4
    before = space.locator("canvas").get_attribute("data-frame") or ""
    box = space.bounding_box()
    assert box is not None
    x, y = box["x"] + 0.8 * box["width"], box["y"] + 0.8 * box["height"]
    planned.mouse.move(x, y)
    planned.mouse.down()
    planned.mouse.move(x - 60, y + 20, steps=4)
    planned.mouse.up()
    expect(space.locator("canvas")).not_to_have_attribute("data-frame", before)
    assert not faults(planned)
    planned.reload()  # the choice to see it stays
    expect(space).to_be_visible()
    expect(planned.get_by_label("State of the forecast")).to_have_text("up to date")
    planner.click(planned, 26, 0)
    expect(planned.get_by_role("heading", name="Dock", exact=True)).to_be_visible()
