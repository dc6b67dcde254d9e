"""Nothing on the screen misleads: what is shown in each state that once was shown wrongly."""

import re

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.contract_server import ContractServer

RUNNING, PAUSED = pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED
COMPLETED, ABORTED, IDLE = pb.MISSION_PHASE_COMPLETED, pb.MISSION_PHASE_ABORTED, pb.MISSION_PHASE_IDLE
MODE_OF_PHASE = {
    RUNNING: "R",
    PAUSED: "H",
    COMPLETED: "H",
    ABORTED: "–",
    IDLE: "–",
}


def at(
    time_s: float, phase: "pb.MissionPhase", flown: "pb.Mode" = pb.MODE_UNSPECIFIED, **said: object
) -> list:
    """A frame in that phase; `said`: fields of Supervisor; a screw still turns after an abort."""
    frame = dict(flight.cycle(time_s, phase))
    supervisor = frame["tlm/supervisor"]
    assert isinstance(supervisor, pb.Supervisor)
    supervisor.flown = flown
    for name, value in said.items():
        setattr(supervisor, name, value)
    return [*flight.mission_status(time_s, phase), *flight.server_status(recording=True), *frame.items()]


def at_rest(time_s: float, phase: "pb.MissionPhase") -> list:
    """A frame whose actuators have come to rest."""
    frame = at(time_s, phase)
    actuators = next(message for topic, message in frame if topic == "tlm/actuators")
    for actuator in actuators.actuators:
        actuator.command = actuator.feedback = 0.0
    return frame


@pytest.mark.parametrize("phase", [RUNNING, PAUSED, COMPLETED])
def test_while_an_actuator_may_move_abort_is_there_and_the_mode_is_named(
    console: Page, server: ContractServer, phase: "pb.MissionPhase"
) -> None:
    """Protects: after "Completed" the thrusters ran on as "No mode", and abort was disabled."""
    flown = {RUNNING: pb.MODE_REVERSE}.get(phase, pb.MODE_HOVER)
    server.keep_saying(at(30.0, phase, flown))
    panel = console.get_by_label("Mode", exact=True)
    expect(panel.locator(".mode-badge")).to_have_text(MODE_OF_PHASE[phase])
    abort = console.get_by_role("button", name="Hold to abort")
    expect(abort).to_be_enabled()
    expect(abort).to_have_attribute(
        "title", re.compile("stops all actuators. The vehicle then drifts, and rises")
    )
    if phase == COMPLETED:
        expect(console.get_by_text("Holding station", exact=True)).to_be_visible()
        expect(panel).to_contain_text("mission over; holding station")


def test_abort_stays_until_the_actuators_have_come_to_rest(console: Page, server: ContractServer) -> None:
    """Protects the second after an abort, in which screws still turn."""
    abort = console.get_by_role("button", name="Hold to abort")
    server.keep_saying(at(30.0, ABORTED))
    expect(console.get_by_text("Actuators are stopping")).to_be_visible()
    expect(abort).to_be_enabled()
    server.keep_saying(at_rest(31.0, ABORTED))
    expect(console.get_by_text("Actuators stopped: drifting", exact=True)).to_be_visible()
    expect(abort).to_be_disabled()


def test_after_an_abort_nothing_frozen_looks_live(console: Page, server: ContractServer) -> None:
    """Protects: range froze undimmed, "Filtered" and "Solved" stayed lit."""
    server.keep_saying(at(30.0, RUNNING, pb.MODE_REVERSE))
    expect(console.locator(".lamp[data-on='yes']")).to_have_count(2)
    server.keep_saying(at(30.05, ABORTED))
    expect(console.get_by_label("Range to the observation point – metres")).to_be_visible()
    expect(console.locator(".lamp[data-on='yes']")).to_have_count(0)
    allocation = console.get_by_label("Allocation", exact=True)
    expect(allocation).to_contain_text("Stopped")
    expect(allocation).not_to_contain_text("Solved")
    expect(console.get_by_label("Wrench", exact=True)).to_contain_text("no control is in force")
    expect(console.get_by_label("Mode", exact=True)).to_contain_text("actuators stopped: drifting")
    expect(console.get_by_test_id("plot-depth").locator(".value-reference")).to_have_text("–")


def test_in_a_pause_the_clock_says_so_and_the_mode_is_the_hold(console: Page, server: ContractServer) -> None:
    """Protects: T+ ran on in a pause while the badge said Forward."""
    frame = at(80.0, PAUSED, pb.MODE_HOVER, mode=pb.MODE_FORWARD)
    status = next(message for topic, message in frame if topic == "tlm/mission")
    status.held_s, status.duration_s = 20.0, 110.0
    server.keep_saying(frame)
    panel = console.get_by_label("Mode", exact=True)
    expect(panel.get_by_label("Mode Hover")).to_have_text("H")
    expect(panel).to_contain_text("holding station; mission waits in F")
    bar = console.get_by_label("Mission control")
    expect(bar.get_by_label("Mission phase")).to_have_text("Holding")
    expect(bar).to_contain_text("T+01:20 / 01:50, held for 00:20")
    expect(bar.get_by_role("progressbar")).to_have_attribute("aria-valuenow", "67")


def test_a_ramp_after_a_pause_comes_from_the_hold(console: Page, server: ContractServer) -> None:
    """Protects: it was labelled "from F" after the mode before the pause."""
    server.keep_saying([])
    server.say(at(30.0, PAUSED, pb.MODE_HOVER, kappa=1.0))
    for k in range(4):
        server.say(at(30.05 + 0.05 * k, RUNNING, pb.MODE_REVERSE, kappa=0.1 + 0.05 * k))
    expect(console.get_by_label("Mode", exact=True)).to_contain_text("from H")


def alarm(**said: object) -> list:
    """The list of alarms with this one."""
    one = pb.Alarm(id="1", code="node_restarted", severity=pb.SEVERITY_ALARM, raised_ns=flight.START_NS)
    for name, value in said.items():
        setattr(one, name, value)
    return [("server/alarms", pb.Alarms(alarms=[one]))]


def test_what_went_wrong_stays_until_somebody_has_seen_it(console: Page, server: ContractServer) -> None:
    """Protects: a node died, and four seconds later all was green; parameters were lost without a word."""
    server.reply("POST", "alarms/1/acknowledge", None)
    text = "Parameters lost: since its restart the vehicle flies with revision 1, which is not what was set."
    server.say(alarm(text=text, returned_ns=flight.START_NS + 1))
    bar = console.get_by_role("region", name="Alarms")
    expect(bar).to_contain_text(text)
    expect(bar).to_contain_text("over, not seen")
    expect(bar.locator("time")).to_contain_text("UTC")
    for view in ("Missions", "Runs", "Live"):
        console.get_by_role("navigation").get_by_role("link", name=view).click()
        expect(bar).to_contain_text(text)
    bar.get_by_role("button", name="Seen").click()
    server.wait_for_call("POST", "alarms/1/acknowledge")
    server.say([("server/alarms", pb.Alarms())])
    expect(bar).to_have_count(0)


def test_an_alarm_that_holds_can_be_shelved(console: Page, server: ContractServer) -> None:
    """Protects the screen from being covered by what is known and wanted."""
    server.reply("POST", "alarms/1/shelve", None)
    server.say(alarm(text="At its bound.", severity=pb.SEVERITY_WARNING))
    bar = console.get_by_role("region", name="Alarms")
    bar.get_by_role("button", name="Shelve").click()
    assert server.wait_for_call("POST", "alarms/1/shelve").json() == {"seconds": 600}


def test_values_that_are_no_numbers_are_shown_as_none(console: Page, server: ContractServer) -> None:
    """Protects the page from a vehicle that says NaN, and the reader from "NaN"."""
    nan = float("nan")
    frame = at(30.0, RUNNING, pb.MODE_REVERSE, range_m=nan, kappa=nan, time_in_mode_s=nan)
    nav = pb.Navigation(stamp=flight.stamp(30.0), depth_m=nan, attitude=pb.Attitude(yaw_deg=nan))
    status = pb.MissionStatus(phase=RUNNING, run_id="r", mission_name="m", duration_s=nan, elapsed_s=nan)
    server.keep_saying([*frame, ("tlm/navigation", nav), ("tlm/mission", status)])
    state = console.get_by_label("State", exact=True)
    expect(state).to_contain_text("Depth–")
    expect(state).to_contain_text("Heading–")
    expect(console.get_by_role("main")).not_to_contain_text("NaN")
    expect(console.get_by_role("progressbar")).to_have_attribute("aria-valuenow", "0")


def test_a_clock_that_steps_back_wipes_nothing(console: Page, server: ContractServer) -> None:
    """Protects plots and events from the vehicle's clock: both began anew, new events stood below old."""
    server.keep_saying([])
    for k in range(40):
        server.say(flight.cycle(30.0 + 0.25 * k))
    depth = console.get_by_test_id("plot-depth")
    expect(depth).to_contain_text("3.02")  # at 39.75 s
    server.say(flight.event(39.0, pb.SEVERITY_INFO, "one", "Before the step."), age_s=2.0)
    server.say(flight.event(1.0, pb.SEVERITY_INFO, "two", "After the step."), age_s=1.0)
    for k in range(8):
        server.say(flight.cycle(1.0 + 0.25 * k))
    rows = console.get_by_role("log").get_by_role("listitem")
    expect(rows.first).to_contain_text("After the step.")
    box = console.get_by_label("Depth over time").locator(".u-over").bounding_box()
    assert box is not None
    console.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(depth.locator(".value-measured")).to_have_text(re.compile(r"^[23]\.\d\d$"))


def test_times_of_day_carry_their_zone_and_it_can_be_chosen(console: Page, server: ContractServer) -> None:
    """Protects two crews on two coasts from each other."""
    clock = console.get_by_role("banner").locator("button.clock")
    expect(clock).to_have_text(re.compile(r"^\d\d:\d\d:\d\d\sUTC$"))
    expect(clock).to_have_attribute("title", "Show local time everywhere")
    clock.click()
    expect(clock).to_have_attribute("title", "Show UTC everywhere")
    expect(clock).to_have_text(re.compile(r"^\d\d:\d\d:\d\d\sUTC"))


@pytest.mark.parametrize(("width", "height"), [(720, 900), (900, 700), (720, 450)])
def test_nothing_is_covered_on_a_narrow_screen_or_magnified(
    console: Page, server: ContractServer, width: int, height: int
) -> None:
    """Protects at 720 to 900 px and at 200 % of 1440 x 900: the link chip was covered, labels overlapped."""
    console.set_viewport_size({"width": width, "height": height})
    server.keep_saying(at(46.5, RUNNING, pb.MODE_HOVER))
    expect(console.get_by_label("Mode Hover")).to_be_visible()
    assert console.evaluate("document.documentElement.scrollWidth") == width
    covered = console.evaluate(
        """() => [...document.querySelectorAll('.topbar > *, .commandbar > *')]
            .filter(e => e.getBoundingClientRect().width > 1)
            .flatMap((e, i, all) => all.slice(i + 1).map(o => [e, o]))
            .filter(([a, b]) => {
                const [p, q] = [a.getBoundingClientRect(), b.getBoundingClientRect()];
                return Math.min(p.right, q.right) - Math.max(p.left, q.left) > 1
                    && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 1;
            }).map(([a, b]) => a.className + ' over ' + b.className)"""
    )
    assert covered == []
    labels = console.evaluate(
        """() => { const boxes = [...document.querySelectorAll('.threshold[data-row="0"] .threshold-text')]
                .map(e => e.getBoundingClientRect()).sort((a, b) => a.left - b.left);
            return boxes.filter((b, i) => i && b.left < boxes[i - 1].right - 1).length }"""
    )
    assert labels == 0
    link = console.get_by_label("Link: Live")
    expect(link).to_be_in_viewport(ratio=1)


def test_before_a_first_flight_no_panel_lies_over_another_at_200_percent(
    console: Page, server: ContractServer
) -> None:
    """Protects the first screen there is, magnified: beside the first steps all panels shared one row."""
    console.set_viewport_size({"width": 720, "height": 450})
    server.keep_saying(flight.hello())
    expect(console.get_by_role("region", name="First steps")).to_be_visible()
    covered = console.evaluate(
        """() => [...document.querySelectorAll('.live .panel, .first-steps article')]
            .map(e => [e.getAttribute('aria-label'), e.getBoundingClientRect()])
            .filter(([, box]) => box.height > 1)
            .flatMap(([name, a], i, all) => all.slice(i + 1)
                .filter(([, b]) => Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1)
                .map(([other]) => name + ' over ' + other))"""
    )
    assert covered == []


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_last_known_values_stay_readable(console: Page, server: ContractServer, theme: str) -> None:
    """Protects what is needed most when nothing new comes: it faded to a contrast of 1.8 to 1."""
    console.evaluate(f"document.documentElement.dataset.theme = '{theme}'")
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_STALE))
    server.say(at(30.0, RUNNING, pb.MODE_REVERSE), age_s=3.0)
    expect(console.get_by_label("State", exact=True).locator(".panel-body")).to_have_attribute(
        "data-state", "stale"
    )
    worst = console.evaluate(
        """() => {
        const lum = c => { const [r, g, b] = c.map(v => v / 255)
            .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
            return 0.2126 * r + 0.7152 * g + 0.0722 * b };
        const rgb = text => text.match(/[\\d.]+/g).map(Number);
        const ground = e => { for (; e; e = e.parentElement) {
            const c = rgb(getComputedStyle(e).backgroundColor); if ((c[3] ?? 1) > 0.7) return c } };
        const shown = e => { let o = 1;
            for (; e; e = e.parentElement) o *= +getComputedStyle(e).opacity; return o };
        let worst = 99, of = '';
        for (const e of document.querySelectorAll('.live [data-state="stale"] *')) {
            const own = [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim());
            if (!own || e.closest('.sr, .mode-badge, .mode-letter') || !e.getClientRects().length) continue;
            const back = ground(e), share = shown(e);
            const ink = rgb(getComputedStyle(e).color).slice(0, 3)
                .map((v, i) => share * v + (1 - share) * back[i]);
            const [a, b] = [lum(ink), lum(back.slice(0, 3))];
            const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            if (contrast < worst) [worst, of] = [contrast, e.outerHTML.slice(0, 120)];
        }
        return [worst, of];
    }"""
    )
    assert worst[0] >= 4.5, worst


def test_what_the_next_switch_waits_for_is_a_checklist_of_the_vehicles_own(
    console: Page, server: ContractServer
) -> None:
    """Protects "why this mode": each way out with what is met and what is not, and when it will be taken."""
    guards = [
        pb.Guard(name="seen in 5 frames", value=5, limit=3, at_least=True, met=True),
        pb.Guard(name="range", value=0.82, limit=0.6, unit="m"),
    ]
    exits = pb.Exits(exits=[pb.ModeExit(to=pb.MODE_HOVER, name="hover", guards=guards, expected_s=4.2)])
    server.keep_saying([*at(30.0, RUNNING, pb.MODE_REVERSE), ("tlm/exits", exits)])
    row = console.get_by_label("Ways out of this mode").get_by_role("listitem")
    expect(row).to_have_count(1)
    expect(row).to_contain_text("seen in 5 frames: 5 of 3, met")
    expect(row).to_contain_text("range 0.82 > 0.60 m, not met")
    expect(row).to_contain_text("in about 4 s")
    server.keep_saying([*at(31.0, ABORTED), ("tlm/exits", exits)])
    expect(row).to_have_count(0)


def test_a_past_switch_opens_to_what_would_have_prevented_it(console: Page, server: ContractServer) -> None:
    """Protects the ledger: what was true then, in the vehicle's words."""
    told = {"unless": "a range above it", "dwelt_s": "21.95", "dwell_s": "3.00", "range_m": "0.598"}
    server.say(
        flight.event(
            46.0, pb.SEVERITY_INFO, "mode_switch", "Reverse to hover: range.", detected="true", **told
        )
    )
    event = console.get_by_role("log").get_by_role("listitem")
    event.get_by_text("Reverse to hover").click()
    expect(event).to_contain_text("a range above it")
    expect(event).to_contain_text("21.95 s of 3.00 s")
