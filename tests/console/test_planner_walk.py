"""The five-minute walk on the real server and vehicle: drawn, judged, mended, saved, started, watched."""

import re
from pathlib import Path

from playwright.sync_api import Page, expect

from tests.console import planner
from tests.console.conftest import show
from tests.server.serving import Running

ROOT = Path(__file__).parents[2]
COMPILES_MS = 600_000  # patience with a machine that has never compiled the control cycle
FORESEES_MS = 180_000  # patience with a busy one that flies 200 missions


def docks(page: Page) -> float:
    """The share of flights that dock, as the forecast says."""
    docked, of = (int(n) for n in re.findall(r"\d+", page.get_by_label("Chance").inner_text())[:2])
    assert of >= 100
    return docked / of


def test_a_newcomer_draws_mends_starts_and_watches_a_mission(page: Page, running: Running) -> None:
    """Protects the first five minutes: each step is named on the screen, and none needs a manual."""
    page.goto(f"{running.url}/")
    expect(page.get_by_label("Link: Live")).to_be_visible(timeout=COMPILES_MS)
    show(page, "Plan")
    planner.draw(page)
    planner.draw_zone(page, (6, 8), (12, 8), (12, 14), (6, 14))
    expect(page.get_by_role("heading", name="Keep-out zone 1")).to_be_visible()
    state = page.get_by_label("State of the forecast")
    expect(state).to_have_text("up to date", timeout=COMPILES_MS)

    next_step = page.get_by_role("status", name="Next step")
    expect(next_step).to_contain_text("This will dock.", timeout=FORESEES_MS)
    assert docks(page) >= 0.95  # a fixed heading in still water, in currents drawn about none

    planner.drag_current(page, right=9, down=0)  # from the west, across the approach
    findings = page.get_by_label("Findings")
    expect(findings).to_contain_text("no sideways thrust", timeout=FORESEES_MS)
    expect(next_step).to_contain_text("This can't work as it is.")
    next_step.get_by_role("button").click()
    expect(state).to_have_text("up to date", timeout=FORESEES_MS)
    assert docks(page) >= 0.95, page.get_by_label("Forecast", exact=True).inner_text()

    next_step.get_by_role("button", name="Save and start").click()
    sheet = page.get_by_role("dialog", name="Before the start")
    expect(sheet).to_contain_text("It reports a leak: it holds station at the surface.")
    warned = sheet.get_by_role("checkbox")
    if warned.count():
        warned.check()
    sheet.get_by_role("button", name="Hold to save and start").hover()
    page.mouse.down()
    expect(page.get_by_role("main", name="Live")).to_be_visible(timeout=FORESEES_MS)
    page.mouse.up()
    expect(page.get_by_label("Mission phase")).to_have_text("Running")
    expect(page.get_by_label("Mode Forward")).to_have_text("F")
    show(page, "Plan")
    expect(page.get_by_label("How it is kept")).to_have_text("Saved, on the vehicle")
    assert running.console.missions.get("mission") is not None
