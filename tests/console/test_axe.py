"""axe-core finds nothing serious or moderate in any view, in both themes, present and stale."""

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web import views
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer

AXE = Path(__file__).parents[2] / "console_web" / "node_modules" / "axe-core" / "axe.min.js"
RUN = """async () => {
    const tags = ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'];
    const found = await axe.run({ runOnly: tags, iframes: false });
    return found.violations.filter(v => v.impact !== 'minor')
        .map(v => `${v.id} (${v.impact}): ${v.nodes[0].html.slice(0, 100)}`);
}"""


def faults(page: Page) -> list[Any]:
    """What axe finds, but for what it calls minor."""
    page.evaluate(AXE.read_text())
    return page.evaluate(RUN)


def alarm() -> list:
    """An alarm in the bar."""
    one = pb.Alarm(
        id="1",
        code="saturated",
        severity=pb.SEVERITY_WARNING,
        text="At its bound.",
        raised_ns=flight.START_NS,
    )
    return [("server/alarms", pb.Alarms(alarms=[one]))]


@pytest.mark.parametrize("theme", ["dark", "light"])
@pytest.mark.parametrize("state", ["present", "stale"])
def test_no_view_has_a_serious_or_moderate_fault(
    console: Page, server: ContractServer, theme: str, state: str
) -> None:
    """Protects who reads by ear, by keyboard or with low contrast, in every state that counts."""
    console.set_viewport_size({"width": 1440, "height": 900})
    console.evaluate("theme => { document.documentElement.dataset.theme = theme }", theme)
    flown = [*flight.mission_status(46.5), *flight.server_status(recording=True), *flight.cycle(46.5)]
    server.say(alarm())
    if state == "stale":
        server.keep_saying(flight.server_status(link=pb.LINK_STATE_STALE))
        server.say(flown, age_s=3.0)
        expect(console.get_by_text("Telemetry is late")).to_be_visible()
    else:
        server.keep_saying(flown)
        expect(console.get_by_label("Mode Hover")).to_be_visible()
    found = {}
    for view in views.VIEWS:
        show(console, view.name)
        expect(console.get_by_role("heading", level=1)).to_have_count(1)
        expect(console.locator("main:not([hidden]) .panel").first).to_be_visible()
        if bad := faults(console):
            found[view.id] = bad
    for arrangement in ("operate", "wall"):
        console.goto(f"{server.url}#/live?as={arrangement}")
        expect(console.get_by_role("heading", name=f"Live view, {arrangement.title()}")).to_be_attached()
        expect(console.get_by_role("main").get_by_text("Depth").first).to_be_visible()
        found |= {arrangement: bad} if (bad := faults(console)) else {}
    for key, sheet in (("?", "Words and keys"), ("Control+k", "Find everything")):
        console.keyboard.press(key)
        expect(console.get_by_role("dialog", name=sheet)).to_be_visible()
        found |= {sheet: bad} if (bad := faults(console)) else {}
        console.keyboard.press("Escape")
        expect(console.get_by_role("dialog", name=sheet)).to_have_count(0)
    assert not found
