"""What can't be pressed now keeps the keyboard's place and says why, in every view and state."""

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.server.serving import Running

# Views, each with something that is there once it is.
VIEWS = {
    "Live": "Events",
    "Missions": "Start this mission",
    "Mode weights": "Revert all",
    "Runs": "Compare",
    "System": "Diagnostics",
}
# Buttons that are wrong: the browser drops the focus of a disabled one, or no reason is said.
WRONG = """() => [...document.querySelectorAll("button")]
  .filter((one) => one.checkVisibility())
  .filter((one) => one.disabled || (one.getAttribute("aria-disabled") === "true" && !one.title.trim()))
  .map((one) => one.textContent.trim() || one.ariaLabel)"""
BARRED = """() => [...document.querySelectorAll('button[aria-disabled="true"]')]
  .filter((one) => one.checkVisibility()).length"""


STATES = {
    "at rest": flight.hello(),
    "flying": [*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)],
    "lost": flight.server_status(link=pb.LINK_STATE_LOST),
}


@pytest.mark.parametrize("state", ["at rest", "flying", "lost"])
def test_each_button_that_is_barred_says_why_and_can_be_focused(
    console: Page, server: ContractServer, state: str
) -> None:
    """Protects the keyboard's place, and people from buttons that are dead without a word."""
    server.keep_saying(STATES[state])
    expect(console.get_by_label("Link: Link lost" if state == "lost" else "Link: Live")).to_be_visible()
    expect(console.get_by_label("Mission phase")).to_have_text("Running" if state == "flying" else "Idle")
    barred = 0
    for view, there in VIEWS.items():
        show(console, view)
        expect(console.locator("main:not([hidden])").get_by_text(there).first).to_be_visible()
        assert console.evaluate(WRONG) == [], f"in {view}"
        barred += console.evaluate(BARRED)
    assert barred > 3


def test_plan_bars_nothing_without_a_word(page: Page, running: Running) -> None:
    """Protects the same in the planner: its library, a plan that is begun, a whole one, and each tab."""
    barred = 0
    for place, there in (("plan", "New from it"), ("plan/docking", "Saved, not on the vehicle")):
        page.goto(f"{running.url}/#/{place}")
        expect(page.get_by_text(there).first).to_be_visible()
        for tab in (None, "Legs", "YAML", "What if", "Charts", "Keys") if "/" in place else (None,):
            if tab:
                page.get_by_role("button", name=tab, exact=True).click()
            assert page.evaluate(WRONG) == [], f"in {place}, {tab}"
            barred += page.evaluate(BARRED)
    page.get_by_role("button", name="YAML", exact=True).click()
    page.locator(".cm-content").click()
    page.keyboard.press("Control+a")
    page.keyboard.type("version: 1")
    up = page.get_by_role("button", name="Dock up")
    expect(up).to_have_attribute("aria-disabled", "true")
    expect(up).to_have_attribute("title", "No dock is placed yet")
    up.focus()
    up.press("Enter")
    expect(up).to_be_focused()
    assert page.evaluate(WRONG) == []
    assert barred > 3


def test_a_button_keeps_the_focus_when_it_is_barred_under_the_finger(
    console: Page, server: ContractServer
) -> None:
    """Protects who reverts, undoes and applies by keyboard: the last undo bars the button that is focused."""
    show(console, "Mode weights")
    console.get_by_label("Hover: Q Z", exact=True).fill("6.5")
    undo = console.get_by_role("button", name="Undo", exact=True)
    undo.focus()
    console.keyboard.press("Enter")
    expect(undo).to_be_disabled()
    expect(undo).to_be_focused()
    expect(undo).to_have_attribute("title", "Nothing to undo")
    console.keyboard.press("Enter")
    redo = console.get_by_role("button", name="Redo", exact=True)
    redo.press("Enter")
    expect(console.get_by_label("Hover: Q Z", exact=True)).to_have_value("6.5")
    revert = console.get_by_role("button", name="Revert all")
    revert.focus()
    console.keyboard.press("Space")
    expect(revert).to_be_focused()
    expect(revert).to_have_attribute("title", "The draft has no change")
