"""The planner under fingers: pan, pinch, drag waypoints, and targets that a finger meets."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, CDPSession, Page, expect

from tests.console import planner
from tests.console.contract_server import ContractServer
from tests.console.test_planner import TEXT, keep, yaml

FINGER_PX = 44
SMALL = """() => [...document.querySelectorAll('main.planner :is(button, select, summary, input)')]
  .filter((e) => e.checkVisibility({visibilityProperty: true}) && !e.classList.contains('sr'))
  .map((e) => [e.ariaLabel || e.textContent, e.getBoundingClientRect()])
  .filter(([, box]) => box.height < 43.5 || box.width < 43.5)
  .map(([name, box]) => `${name}: ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`)"""
Point = tuple[float, float]


@pytest.fixture
def tablet(browser: Browser, server: ContractServer) -> Iterator[Page]:
    """The planner on a tablet, one mission open."""
    planner.default_replies(server)
    server.foresee = lambda _: planner.forecast(198)
    keep(server, TEXT)
    context = browser.new_context(
        viewport={"width": 1024, "height": 768}, has_touch=True, is_mobile=True, device_scale_factor=1
    )
    page = context.new_page()
    page.goto(f"{server.url}#/plan/harbour")
    expect(page.get_by_label("State of the forecast")).to_have_text("up to date")
    yield page
    context.close()


def touch(session: CDPSession, *steps: tuple[Point, ...]) -> None:
    """Fingers down at the first step's places, along the others, and up."""
    for k, fingers in enumerate(steps):
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(fingers)]
        kind = "touchMove" if k else "touchStart"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def frame(page: Page) -> list[float]:
    """East, north and scale of the middle of the plan."""
    canvas = page.get_by_role("application", name="Plan from above").locator("canvas")
    return [float(number) for number in (canvas.get_attribute("data-frame") or "").split()]


def changed(page: Page, before: list[float]) -> list[float]:
    """The frame once it is another one."""
    canvas = page.get_by_role("application", name="Plan from above").locator("canvas")
    told = " ".join(f"{number:.5f}" for number in before)
    expect(canvas).not_to_have_attribute("data-frame", told)
    return frame(page)


def test_fingers_pan_zoom_and_drag(tablet: Page) -> None:
    """Protects touch: one finger on the water pans, two zoom, one on a waypoint takes it along."""
    session = tablet.context.new_cdp_session(tablet)
    before = frame(tablet)
    (x, y), scale = planner.at(tablet, 5, 8), before[2]
    touch(session, ((x, y),), ((x - 20, y),), ((x - 60, y),))
    panned = changed(tablet, before)
    assert abs(panned[0] - before[0] - 60 / scale) < 25 / scale and panned[2] == scale
    touch(session, ((x - 30, y), (x + 30, y)), ((x - 45, y), (x + 45, y)), ((x - 60, y), (x + 60, y)))
    zoomed = changed(tablet, panned)
    assert 1.5 * scale < zoomed[2] < 2.2 * scale

    start, end = planner.at(tablet, 10, 0), planner.at(tablet, 12, 3)
    near = (start[0] + 15, start[1] + 8)  # fingers miss
    middle = ((near[0] + end[0]) / 2, (near[1] + end[1]) / 2)
    touch(session, (near,), (middle,), (end,))
    expect(tablet.get_by_label("End of the leg east, legs[0].to_ned_m")).to_have_value("3")
    assert "[12, 3, 2.0]" in yaml(tablet)


def test_every_target_is_as_large_as_a_finger(tablet: Page) -> None:
    """Protects fingers on a small screen: 44 px each way in all parts of the planner."""
    found = {"mission": tablet.evaluate(SMALL)}
    tablet.get_by_role("button", name="Add a fault").tap()
    for tab in ("Legs", "YAML", "What if", "Keys", "Details"):
        tablet.get_by_role("button", name=tab, exact=True).tap()
        found[tab] = tablet.evaluate(SMALL)
    tablet.get_by_role("button", name="Open …").tap()
    expect(tablet.get_by_label("Missions to open")).to_be_visible()
    found["list"] = tablet.evaluate(SMALL)
    assert not {part: small for part, small in found.items() if small}
