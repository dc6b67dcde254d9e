"""The live view shows what the stream says, and never passes old values off as present ones."""

import pytest
from playwright.sync_api import Browser, Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.replies import vehicle

SIZES = [(1440, 900), (1024, 768)]
WIDER_THAN_ROOM = "all => all.filter(head => head.scrollWidth > head.clientWidth + 1).length"


def in_flight(time_s: float) -> list:
    """A frame of a running mission."""
    return [*flight.mission_status(time_s), *flight.server_status(recording=True), *flight.cycle(time_s)]


# The page's own rules forbid what Playwright's polling does from its second look on.
FRAMED = """wanted => new Promise((done, failed) => {
  const late = setTimeout(() => failed(new Error(`the frame never showed ${wanted}`)), 30_000);
  const look = () => {
    const shown = document.querySelector("iframe").contentDocument;
    if (String(shown && shown.title) !== wanted) return requestAnimationFrame(look);
    clearTimeout(late);
    done();
  };
  look();
})"""


def test_values_follow_the_stream(console: Page, server: ContractServer) -> None:
    """Protects the whole way from a frame's bytes to mode, wrench, plots and actuators on the screen."""
    mode = console.get_by_label("Mode", exact=True)
    server.keep_saying(in_flight(10.0))
    expect(mode.get_by_label("Mode Forward")).to_have_text("F")
    expect(mode).to_contain_text("17.00 m")
    expect(console.get_by_test_id("demanded-N")).to_have_text("+0.80")
    expect(console.get_by_test_id("plot-depth")).to_contain_text("3.03")

    server.keep_saying(in_flight(30.0))
    expect(mode.get_by_label("Mode Reverse")).to_have_text("R")
    server.keep_saying(in_flight(46.5))
    expect(mode.get_by_label("Mode Hover")).to_have_text("H")
    expect(mode).to_contain_text("from R")  # the ramp is under way
    expect(mode).to_contain_text("κ 0.50")
    expect(mode.locator(".panel-body")).to_have_attribute("data-state", "fresh")
    expect(console.get_by_text("REC 2.3 MB")).to_be_visible()


def test_the_way_back_after_a_missed_approach_is_no_leg(console: Page, server: ContractServer) -> None:
    """Protects from "3/2": the vehicle says leg `leg_count` while it goes back for another approach."""
    running = flight.hello(pb.MISSION_PHASE_RUNNING)
    server.keep_saying([*running, ("tlm/guidance", pb.Guidance(leg=2, leg_count=2))])
    expect(console.get_by_label("State", exact=True)).to_contain_text("Legback")


def test_before_a_mission_nothing_is_near_or_solved(console: Page, server: ContractServer) -> None:
    """Protects: a vehicle without a mission tells zeros, which look like having arrived."""
    status = pb.MissionStatus(phase=pb.MISSION_PHASE_IDLE)
    server.keep_saying([*flight.cycle(0.0, pb.MISSION_PHASE_IDLE), ("tlm/mission", status)])
    expect(console.get_by_label("Range to the observation point – metres")).to_be_visible()
    allocation = console.get_by_label("Allocation", exact=True)
    expect(allocation).not_to_contain_text("Solved")  # nothing was


def test_a_heading_never_reads_360(console: Page, server: ContractServer) -> None:
    """Protects the smallest of lies: 359.96° rounds to 0.0, not to a heading that does not exist."""
    nav = pb.Navigation(stamp=flight.stamp(10.0), attitude=pb.Attitude(yaw_deg=359.97))
    server.keep_saying([*in_flight(9.9), ("tlm/navigation", nav)])
    expect(
        console.get_by_label("State", exact=True).get_by_text("Heading").locator("xpath=..")
    ).to_contain_text("Heading0.0")
    expect(console.get_by_test_id("plot-yaw")).to_contain_text("0.0")


def test_saturated_and_limited_actuators_are_marked_by_shape(console: Page, server: ContractServer) -> None:
    """Protects the mark that does not rest on colour."""
    server.keep_saying(in_flight(10.0))
    rows = console.get_by_label("Actuators", exact=True).get_by_role("listitem")
    expect(rows).to_have_count(7)
    expect(rows.nth(1)).to_contain_text("at its bound")
    expect(rows.nth(5)).to_contain_text("rate-limited")
    expect(rows.nth(0).locator(".flag svg")).to_have_count(0)


def test_a_vehicle_with_other_actuators_and_sway_is_shown_whole(
    console: Page, server: ContractServer
) -> None:
    """Protects against a screen that knows one vehicle only."""
    server.reply("GET", "vehicle", vehicle("blue", "Blue", list("XYZKMN")))
    names = [f"thruster_{k}" for k in range(1, 9)]
    about = pb.VehicleDescription(
        vehicle_id="blue", vehicle_name="Blue", actuator_names=names, session_id="two"
    )
    drives = [pb.Actuator(name=n, unit="rpm", amplitude_lower=-900, amplitude_upper=900) for n in names]
    actuators = pb.Actuators(stamp=flight.stamp(1), actuators=drives)
    told = [("tlm/description", about), ("tlm/actuators", actuators)]
    server.keep_saying([*flight.hello(), *in_flight(5.0), *told])
    expect(console.get_by_label("Actuators", exact=True).get_by_role("listitem")).to_have_count(8)
    expect(console.get_by_test_id("demanded-Y")).to_be_visible()


def test_late_telemetry_dims_and_shows_its_age(console: Page, server: ContractServer) -> None:
    """Protects the promise that nothing stale looks live."""
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_STALE))
    server.say(in_flight(10.0), age_s=3.0)
    plots = console.get_by_label("Plots", exact=True)
    expect(plots.locator(".panel-body")).to_have_attribute("data-state", "stale")
    expect(plots.get_by_test_id("age-tlm/navigation")).to_contain_text("stale")
    expect(console.get_by_text("Telemetry is late")).to_be_visible()


def test_a_lost_link_is_a_banner(console: Page, server: ContractServer) -> None:
    """Protects the operator from commanding a vehicle that is not there."""
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_LOST))
    expect(console.get_by_role("alert").filter(has_text="Link to the vehicle lost")).to_be_visible()
    expect(console.get_by_role("button", name="Start", exact=True)).to_be_disabled()


def test_a_run_that_cannot_be_recorded_is_told_at_once(console: Page, server: ContractServer) -> None:
    """Protects a flight whose log somebody counts on from passing unrecorded and unnoticed."""
    why = "12 MB are free on the disk, fewer than 200 MB"
    server.keep_saying(flight.server_status(trouble=why))
    expect(console.get_by_text("Cannot record")).to_be_visible()
    server.keep_saying([*in_flight(5.0), *flight.server_status(trouble=why)])
    banner = console.get_by_role("alert").filter(has_text="This run is not being recorded")
    expect(banner).to_contain_text(why)
    server.keep_saying(in_flight(6.0))
    expect(banner).to_have_count(0)


def test_a_lost_server_is_a_banner_and_the_page_comes_back_by_itself(
    console: Page, server: ContractServer
) -> None:
    """Protects the restart of a server under an open page, whose scene stayed a browser's fault page."""
    banner = console.get_by_role("alert").filter(has_text="Connection to the server lost")
    scene = console.get_by_title("3-D scene of vehicle, path and target")
    server.stop()
    expect(banner).to_be_visible()
    scene.evaluate("one => one.setAttribute('src', one.getAttribute('src'))")
    _until_framed(console, "null")
    expect(console.get_by_label("State", exact=True).locator(".panel-body")).to_have_attribute(
        "data-state", "stale"
    )
    server.start()
    expect(banner).to_have_count(0)
    expect(console.get_by_label("Link: Live")).to_be_visible()
    _until_framed(console, "scene")


def _until_framed(console: Page, title: str) -> None:
    """Until the scene's frame shows the page of this title; "null": one of the browser's own."""
    console.evaluate(FRAMED, title)


def test_plots_keep_what_they_have_over_a_reconnect(console: Page, server: ContractServer) -> None:
    """Protects: the server's past fills what was missed; it took the place of all that the page had."""
    depth = console.get_by_test_id("plot-depth")
    server.keep_saying([])
    for quarter in range(120):
        server.say(flight.cycle(0.25 * quarter))
    expect(depth).to_contain_text("3.05")  # at 29.75 s
    server.stop()
    expect(console.get_by_role("alert").filter(has_text="Connection to the server lost")).to_be_visible()
    server.start()
    expect(console.get_by_label("Link: Live")).to_be_visible()
    for quarter in range(80, 160):
        server.say(flight.cycle(0.25 * quarter), age_s=40.0 - 0.25 * quarter, past=True)
    server.say(flight.cycle(40.0))
    expect(depth).to_contain_text("3.01")
    box = console.get_by_label("Depth over time").locator(".u-over").bounding_box()
    assert box is not None
    for time_s in (6.75, 33.66):  # kept, filled in: two of the lowest points of a sine
        console.mouse.move(box["x"] + time_s / 40.0 * box["width"], box["y"] + box["height"] / 2)
        expect(depth).to_contain_text("2.95")
        console.mouse.move(0, 0)
        expect(depth).to_contain_text("3.01")


def test_events_come_newest_first_and_once(console: Page, server: ContractServer) -> None:
    """Protects the log's order and its severities; a repeated event is not listed twice."""
    early = flight.event(24.0, pb.SEVERITY_INFO, "mode_switch", "Forward to reverse.")
    late = flight.event(31.0, pb.SEVERITY_ALARM, "leak", "Water in the hull.")
    server.say([*late, *early])
    server.say(early)
    rows = console.get_by_role("log").get_by_role("listitem")
    expect(rows).to_have_count(2)
    expect(rows.first).to_contain_text("Alarm")
    expect(rows.first).to_contain_text("T+00:31")
    console.get_by_label("Least severity").get_by_role("button", name="Alarms").click()
    expect(rows).to_have_count(1)


def test_plot_groups_and_window(console: Page, server: ContractServer) -> None:
    """Protects the plots of wrench and actuators, which are made from what the vehicle names."""
    server.keep_saying(in_flight(10.0))
    group = console.get_by_role("group", name="Plot group")
    group.get_by_role("button", name="Wrench").click()
    expect(console.locator("figure.plot")).to_have_count(5)
    group.get_by_role("button", name="Actuators").click()
    expect(console.locator("figure.plot")).to_have_count(7)
    console.get_by_label("Time window of plots and mode strip").select_option("30")
    expect(console.locator("figure.plot canvas")).to_have_count(7)


def test_the_camera_asks_the_server_for_its_own_tab(
    console: Page, server: ContractServer, browser: Browser
) -> None:
    """Protects the camera presets; two tabs turned each other's camera."""
    other = console.context.new_page()
    other.goto(server.url)
    tabs = set()
    for count, page in enumerate((console, other), start=1):
        page.get_by_role("group", name="Camera").get_by_role("button", name="Top").click()
        asked = server.wait_for_call("POST", "scene/camera", count).json()
        assert asked["view"] == "top"
        assert f"scene/{asked['tab']}/" in (page.locator("iframe").get_attribute("src") or "")
        tabs.add(asked["tab"])
        expect(page.get_by_role("button", name="Top")).to_have_attribute("aria-pressed", "true")
    assert len(tabs) == 2 and "" not in tabs
    other.close()


@pytest.mark.parametrize("size", SIZES)
def test_nothing_overlaps_or_scrolls(console: Page, server: ContractServer, size: tuple[int, int]) -> None:
    """Protects the layout at both screen sizes that operators use."""
    console.set_viewport_size({"width": size[0], "height": size[1]})
    server.keep_saying(in_flight(46.5))
    expect(console.get_by_label("Mode Hover")).to_be_visible()
    assert_tidy(console, size)
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_LOST))
    expect(console.get_by_role("alert").filter(has_text="Link to the vehicle lost")).to_be_visible()
    expect(console.get_by_test_id("age-tlm/control")).to_be_visible()
    assert_tidy(console, size)


def assert_tidy(console: Page, size: tuple[int, int]) -> None:
    """No page scroll, no panel over another, no panel's title line wider than the panel."""
    page = console.evaluate("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
    assert page == list(size)
    panels = console.evaluate(
        "[...document.querySelectorAll('.live .panel')].map(p => {"
        " const b = p.getBoundingClientRect(); return [p.ariaLabel, b.left, b.top, b.right, b.bottom] })"
    )
    assert len(panels) == 8
    heads = console.locator(".live .panel-head")
    assert heads.evaluate_all(WIDER_THAN_ROOM) == 0
    for i, (name, left, top, right, bottom) in enumerate(panels):
        assert left >= 0 and top >= 0 and right <= size[0] and bottom <= size[1], name
        for other, left2, top2, right2, bottom2 in panels[i + 1 :]:
            apart = right <= left2 or right2 <= left or bottom <= top2 or bottom2 <= top
            assert apart, f"{name} covers {other}"
