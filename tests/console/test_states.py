"""Forty states, five faults in each of eight phases: what must be shown, and that nothing contradicts it.

Each phase is one page that goes through the faults one after the other, told through a real socket.
"""

import json
from dataclasses import dataclass
from typing import Any

import pytest
from playwright.sync_api import Error, Page

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.test_truth import at, at_rest

RUNNING, PAUSED = pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED
COMPLETED, ABORTED, IDLE = pb.MISSION_PHASE_COMPLETED, pb.MISSION_PHASE_ABORTED, pb.MISSION_PHASE_IDLE
HOVER = pb.MODE_HOVER
TROUBLE = "the disk is full"
PATIENCE_MS = 30_000


@dataclass(frozen=True)
class Phase:
    """What the vehicle does, and what of that is to be seen whatever else is wrong."""

    frame: list
    chip: str
    mode: str
    flies: bool = False  # a mission is flown: hold is there and start is not
    controlled: bool = False  # control is in force: demands, lamps and solutions are of now
    moves: bool = False  # an actuator may move: abort is there
    recorded: bool = False
    after: str = ""  # what it does once its mission is over


PHASES = {
    "idle": Phase(at_rest(0.0, IDLE), "Idle", "–"),
    "forward": Phase(at(20.0, RUNNING, pb.MODE_FORWARD), "Running", "F", True, True, True, True),
    "reverse": Phase(at(30.0, RUNNING, pb.MODE_REVERSE), "Running", "R", True, True, True, True),
    "hover": Phase(at(50.0, RUNNING, HOVER), "Running", "H", True, True, True, True),
    "holding": Phase(at(30.0, PAUSED, HOVER), "Holding", "H", True, True, True, True),
    "over": Phase(at(89.0, COMPLETED, HOVER), "Over", "H", False, True, True, True, "Holding station"),
    "stopping": Phase(
        at(30.0, ABORTED), "Aborted", "–", moves=True, recorded=True, after="Actuators are stopping"
    ),
    "drifting": Phase(at_rest(31.0, ABORTED), "Aborted", "–", after="Actuators stopped: drifting"),
}
FAULTS = ("none", "no recording", "late", "link lost", "server lost")
LINKS: dict[str, str] = dict(
    zip(FAULTS, ("Live", "Live", "Telemetry late", "Link lost", "Server lost"), strict=True)
)

SNAPSHOT = """() => {
    const text = e => e ? e.textContent.trim() : null;
    const off = e => e ? e.disabled || e.getAttribute('aria-disabled') === 'true' : null;
    const bar = document.querySelector('.commandbar');
    const buttons = [...bar.querySelectorAll('.action, .abort')];
    const named = word => buttons.find(e => text(e.querySelector('.hold-label') ?? e) === word);
    const shown = e => Boolean(e && e.getClientRects().length);
    const panels = [...document.querySelectorAll('.live .panel-body[data-state]')];
    const link = document.querySelector('.link-chip');
    const allocation = document.querySelector('.allocation-panel');
    return {
        link: link.getAttribute('aria-label'),
        green: document.querySelectorAll('.topbar .chip[data-look="live"]').length,
        phase: text(bar.querySelector('.phase')),
        mode: text(document.querySelector('.mode-panel .mode-badge')),
        abort: !off(named('Hold to abort')),
        hold: named('Hold') || named('Resume') ? !off(named('Hold') ?? named('Resume')) : null,
        start: named('Start') ? !off(named('Start')) : null,
        clock: shown(bar.querySelector('.progress')),
        after: text(bar.querySelector('.mission-now > .chip:not(.phase)')) ?? '',
        recording: text([...document.querySelectorAll('.topbar .chip')].find(e => /REC|ecord/.test(text(e)))),
        lamps: document.querySelectorAll('.lamp[data-on="yes"]').length > 0,
        allocation: text(allocation.querySelector('.chip')),
        demand: allocation.textContent.includes('KKT'),
        states: [...new Set(panels.map(e => e.dataset.state))].sort(),
        ages: document.querySelectorAll('.live .age-chip').length > 0,
        banner: text(document.querySelector('.banner strong')) ?? '',
        odd: /NaN|undefined|null|Infinity/.test(document.body.innerText),
    }
}"""


def tell(server: ContractServer, phase: Phase, fault: str) -> None:
    """Let the page be told of that state."""
    trouble = TROUBLE if fault == "no recording" else ""
    recording = phase.recorded and not trouble
    states = {"late": pb.LINK_STATE_STALE, "link lost": pb.LINK_STATE_LOST}
    status = flight.server_status(states.get(fault, pb.LINK_STATE_LIVE), recording, trouble)
    vehicle = [(topic, message) for topic, message in phase.frame if not topic.startswith("server/")]
    if fault == "server lost":
        server.stop()
    elif fault in states:
        server.keep_saying(status)
        server.say(vehicle, age_s=3.0 if fault == "late" else 20.0)
    else:
        server.keep_saying([*status, *vehicle])


def wanted(phase: Phase, fault: str) -> dict[str, Any]:
    """What must be shown."""
    present = fault in ("none", "no recording")
    reachable = present or fault == "late"
    offline = fault == "server lost"
    recording = "REC 2.3 MB" if phase.recorded else "Not recording"
    if fault == "no recording":
        recording = "Cannot record"
    idle = "Stopped" if phase.chip == "Aborted" else "Idle"
    return {
        "link": f"Link: {LINKS[fault]}",
        "green": int(present),
        "phase": phase.chip,
        "mode": phase.mode,
        "abort": phase.moves and not offline,
        "hold": reachable if phase.flies else None,
        "start": None if phase.flies else reachable,
        "clock": phase.flies,
        "after": phase.after,
        "recording": "Recording unknown" if offline else recording,
        "lamps": phase.controlled,
        "allocation": "Solved" if phase.controlled else idle,
        "demand": phase.controlled,
        "states": ["fresh"] if present else ["stale"],
        "ages": not present,
        "banner": _banner(phase, fault),
        "odd": False,
    }


def _banner(phase: Phase, fault: str) -> str:
    """What stands across the page, whichever view is shown."""
    if fault == "no recording":
        return "This run is not being recorded" if phase.moves else ""
    lost = {"link lost": "Link to the vehicle lost", "server lost": "Connection to the server lost"}
    return {"none": "", "late": "Telemetry is late"}.get(fault) or lost.get(fault, "")


@pytest.mark.parametrize("phase", PHASES)
def test_each_fault_in_each_phase_is_told_as_it_is(console: Page, server: ContractServer, phase: str) -> None:
    """Protects the truth of the screen: nothing old, stopped or unknown looks live in any of 40 states."""
    server.say(flight.description())
    for fault in FAULTS:
        want = wanted(PHASES[phase], fault)
        tell(server, PHASES[phase], fault)
        try:
            console.wait_for_function(
                f"want => {{ const now = ({SNAPSHOT})(); return want.every(([k, v]) =>"
                " JSON.stringify(now[k]) === JSON.stringify(v)) }",
                arg=list(want.items()),
                timeout=PATIENCE_MS,
            )
        except Error:
            assert console.evaluate(SNAPSHOT) == want, f"{phase}, {fault}"
            raise
    server.start()


def test_there_are_forty_states() -> None:
    """Protects the count, and that no two of the states look alike where they must not."""
    told = {json.dumps(wanted(phase, fault)) for phase in PHASES.values() for fault in FAULTS}
    assert len(PHASES) * len(FAULTS) == 40
    assert len(told) >= 37, "forward, reverse and hover differ by their mode; drifting is never recorded"
