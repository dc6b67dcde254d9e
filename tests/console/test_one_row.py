"""The bar over every view stays one row from a tablet's width on, whatever it has to say."""

import re

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer

ROW_PX = 60
LONG = "A title so long that nobody would give it, and somebody gave it all the same, twice over"

ENDED = pb.MissionStatus(
    stamp=flight.stamp(90.0), phase=pb.MISSION_PHASE_COMPLETED, run_id="a", mission_name=LONG, end_reason=LONG
)
STATES = {
    "at rest": flight.hello(),
    "flying": [*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)],
    "over": [
        *flight.server_status(),
        *flight.cycle(90.0, phase=pb.MISSION_PHASE_COMPLETED),
        ("tlm/mission", ENDED),
    ],
}
WORST = [
    *flight.server_status(recording=True),
    ("tlm/health", pb.Health(stamp=flight.stamp(10.0), missed_cycles=105)),
    *flight.cycle(10.0),
    *flight.mission_status(10.0),
]
INSIDE = """() => { const bar = document.querySelector(".commandbar").getBoundingClientRect();
  const parts = [...document.querySelectorAll(".commandbar > *")].map((one) => one.getBoundingClientRect());
  return { high: bar.height, apart: parts.every((a, i) => i === 0 || a.left >= parts[i - 1].right - 1),
    within: parts.every((one) => one.right <= bar.right + 1) }; }"""


# Links and buttons of both bars of which something else lies on top.
ON_TOP = """() => [...document.querySelectorAll("header.topbar :is(a, button), .commandbar :is(a, button)")]
  .filter((one) => { const at = one.getBoundingClientRect();
    const top = document.elementFromPoint(at.left + at.width / 2, at.top + at.height / 2);
    return at.width > 0 && !one.contains(top); })
  .map((one) => one.textContent)"""


@pytest.mark.parametrize("width", [1024, 1440])
@pytest.mark.parametrize("state", ["at rest", "flying", "over"])
def test_the_bar_is_one_row_and_nothing_in_it_overlaps(
    console: Page, server: ContractServer, state: str, width: int
) -> None:
    """Protects the height of the live view, and buttons from what is written over them."""
    console.set_viewport_size({"width": width, "height": 768})
    server.keep_saying(STATES[state])
    words = {"at rest": "Idle", "flying": "Running", "over": "Over"}
    expect(console.get_by_label("Mission phase")).to_have_text(words[state])
    bar = console.evaluate(INSIDE)
    assert bar["high"] < ROW_PX
    assert bar["apart"] and bar["within"], bar


def test_no_view_lays_something_over_the_bars(console: Page, server: ContractServer) -> None:
    """Protects abort: styles of a view that came later once laid a button of the bar over all."""
    server.keep_saying(STATES["flying"])
    for view in ("Plan", "Missions", "Mode weights", "Runs", "System", "Live"):
        show(console, view)
        expect(console.locator("main:not([hidden])")).to_be_visible()
        bar = console.evaluate(INSIDE)
        assert bar["high"] < ROW_PX and bar["apart"] and bar["within"], (view, bar)
        assert console.evaluate(ON_TOP) == [], view


def alarms(*priorities: int) -> pb.Alarms:
    """One of each, none seen."""
    return pb.Alarms(
        alarms=[
            pb.Alarm(id=str(k), code=str(k), priority=priority, text="something", raised_ns=flight.START_NS)
            for k, priority in enumerate(priorities)
        ]
    )


def test_the_header_stays_one_row_when_all_is_lost(console: Page, server: ContractServer) -> None:
    """Protects the views from a second row in the moment in which they matter most."""
    console.set_viewport_size({"width": 1024, "height": 768})
    server.keep_saying([*WORST, ("server/alarms", alarms(1, 1, 2, 2, 3, 3))])
    header = console.get_by_role("banner")
    expect(header).to_contain_text(re.compile(r"\b105\b"))
    server.stop()
    expect(header).to_contain_text("Server lost")
    expect(header.get_by_title("Not known: the server does not answer")).to_be_visible()
    assert header.evaluate("one => one.getBoundingClientRect().height") < ROW_PX
    server.start()


def test_the_header_is_one_row_at_a_tablet_s_width(console: Page, server: ContractServer) -> None:
    """Protects the time with its zone, which was left out there, and the views below from a second row."""
    console.set_viewport_size({"width": 1024, "height": 768})
    server.keep_saying(WORST)
    header = console.get_by_role("banner")
    expect(header).to_contain_text(re.compile(r"\b105\b"))
    expect(header.get_by_role("button", name="UTC")).to_be_visible()
    assert header.evaluate("one => one.getBoundingClientRect().height") < ROW_PX
