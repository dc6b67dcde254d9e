"""Missions and commands: what is sent, how refusals look, and an abort that nobody does by accident."""

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import mission

BAD = {
    "detail": "bad.yaml has 1 problem",
    "problems": [
        {
            "file": "bad.yaml",
            "line": 9,
            "column": 1,
            "field": "duration_s",
            "value": "soon",
            "rule": "must be a number",
        }
    ],
}


def at_rest() -> flight.Messages:
    """A vehicle that waits for a mission, its actuators at rest."""
    frame = flight.hello()
    actuators = next(message for topic, message in frame if topic == "tlm/actuators")
    assert isinstance(actuators, pb.Actuators)
    for actuator in actuators.actuators:
        actuator.command = actuator.feedback = 0.0
    return frame


def upload(page: Page, name: str, text: str) -> None:
    """Choose a file."""
    page.set_input_files(
        "input[type=file]", files=[{"name": name, "mimeType": "text/yaml", "buffer": text.encode()}]
    )


def test_a_bad_file_is_refused_with_its_places(console: Page, server: ContractServer) -> None:
    """Protects the table of file, line, field, value and rule."""
    server.reply("POST", "missions", BAD, status=422)
    show(console, "Missions")
    upload(console, "bad.yaml", "duration_s: soon")
    row = console.get_by_role("table", name="Problems").get_by_role("row").nth(1)
    expect(row.get_by_role("cell")).to_have_text(
        ["bad.yaml", "9:1", "duration_s", "soon", "must be a number"]
    )
    expect(console.get_by_role("alert")).to_contain_text("bad.yaml not stored.")


def test_a_good_file_is_stored_and_chosen(console: Page, server: ContractServer) -> None:
    """Protects upload by drop: body and name arrive as they are, and the new mission is shown."""
    new = mission("harbour", "Harbour run", "Into the harbour.", 60.0) | {"builtin": False}
    server.reply("POST", "missions", new, status=201)
    server.reply("GET", "missions", [new])
    server.reply(
        "GET",
        "missions/harbour",
        {**new, "yaml": "name: harbour # note\n", "path_ned_m": [[0, 0, 1], [5, 5, 1]]},
    )
    show(console, "Missions")
    transfer = console.evaluate_handle(
        "() => { const t = new DataTransfer();"
        " t.items.add(new File(['name: harbour # note\\n'], 'harbour.yaml')); return t }"
    )
    console.locator(".dropzone").dispatch_event("drop", {"dataTransfer": transfer})
    call = server.wait_for_call("POST", "missions")
    assert (call.query, call.body) == ("name=harbour.yaml", "name: harbour # note\n")
    expect(console.get_by_label("Harbour run").get_by_text("Into the harbour.")).to_be_visible()
    expect(console.get_by_role("img", name="Plan from above: 2 waypoints, north up")).to_be_visible()
    expect(console.get_by_label("Mission file", exact=True).locator(".yaml-comment")).to_have_text("# note")


def test_start_flies_what_is_shown_and_waits_while_a_file_is_being_stored(
    console: Page, server: ContractServer
) -> None:
    """Protects a quick click after an upload from starting the mission that was shown before."""
    new = mission("harbour", "Harbour run", "", 60.0) | {"builtin": False, "sha256": "ab" * 32}
    server.reply("POST", "missions", new, status=201)
    server.reply("GET", "missions/harbour", {**new, "yaml": "name: harbour\n", "path_ned_m": [[0, 0, 1]]})
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    show(console, "Missions")
    start = console.get_by_role("button", name="Start this mission")
    expect(start).to_be_enabled()
    listed = [*server.replies["GET", "missions"][1], new]
    server.reply("GET", "missions", listed)
    stored, read = server.hold("POST", "missions"), server.hold("GET", "missions/harbour")
    upload(console, "harbour.yaml", "name: harbour\n")
    expect(start).to_be_disabled()
    expect(console.get_by_role("button", name="Start", exact=True)).to_be_disabled()
    stored.set()
    server.wait_for_call("GET", "missions/harbour")
    expect(start).to_be_disabled()
    read.set()
    start.click()
    assert server.wait_for_call("POST", "mission/start").json() == {"name": "harbour", "sha256": "ab" * 32}


def test_a_name_that_exists_can_be_replaced(console: Page, server: ContractServer) -> None:
    """Protects stored files from being overwritten unasked."""
    server.reply("POST", "missions", {"detail": "docking exists already"}, status=409)
    show(console, "Missions")
    upload(console, "docking.yaml", "name: docking")
    expect(console.get_by_role("alert")).to_contain_text("docking exists already")
    server.reply("POST", "missions", mission("docking.yaml", "Docking flight", "", 90.0), status=201)
    console.get_by_role("button", name="Replace the stored file").click()
    expect(console.get_by_text("docking.yaml is checked and stored.")).to_be_visible()
    assert server.calls_of("POST", "missions")[-1].query == "name=docking.yaml&replace=true"


def test_start_sends_mission_and_seed_and_shows_a_refusal_as_it_came(
    console: Page, server: ContractServer
) -> None:
    """Protects the vehicle's own words."""
    said = "Battery at 12 %: at least 30 % is needed."
    server.reply("POST", "mission/start", {"accepted": False, "reason": said}, status=409)
    bar = console.get_by_label("Mission control")
    bar.get_by_label("Mission", exact=True).select_option("docking_current.yaml")
    bar.get_by_label("Seed").fill("42")
    bar.get_by_role("button", name="Start", exact=True).click()
    assert server.wait_for_call("POST", "mission/start").json() == {
        "name": "docking_current.yaml",
        "sha256": mission("", "", "", 0.0)["sha256"],
        "seed": 42,
    }
    alert = console.get_by_role("alert").filter(has_text="Start refused.")
    expect(alert).to_contain_text(said)
    alert.get_by_role("button", name="Dismiss").click()
    expect(alert).to_have_count(0)


def test_start_begins_with_a_mission_for_the_vehicle_that_is_there(
    console: Page, server: ContractServer
) -> None:
    """Protects from a start that is refused: what is for another vehicle says so and can't be chosen."""
    other = mission("azimuth", "Docking with azimuth pods", "", 90.0) | {"vehicle": "twinpod"}
    server.reply("GET", "missions", [other, *server.replies["GET", "missions"][1]])
    console.reload()
    choice = console.get_by_label("Mission", exact=True)
    expect(choice.locator("option")).to_have_text(
        ["Docking flight", "Docking in a current", "Docking with azimuth pods (for twinpod)"]
    )
    expect(choice).to_have_value("docking.yaml")
    expect(choice.locator("option").last).to_be_disabled()
    show(console, "Missions")
    console.get_by_role("button", name="Docking with azimuth pods").click()
    start = console.get_by_label("Mission control").get_by_role("button", name="Start")
    expect(start).to_be_disabled()
    expect(start).to_have_attribute("title", "This mission is for twinpod")


def test_a_bad_seed_cannot_be_sent(console: Page) -> None:
    """Protects the vehicle from a seed that is no whole number."""
    bar = console.get_by_label("Mission control")
    bar.get_by_label("Seed").fill("-1.5")
    expect(bar.get_by_role("button", name="Start", exact=True)).to_be_disabled()


def test_pause_and_resume(console: Page, server: ContractServer) -> None:
    """Protects the two commands and that start is out of reach in flight."""
    server.reply("POST", "mission/pause", {"accepted": True, "reason": ""})
    server.reply("POST", "mission/resume", {"accepted": True, "reason": ""})
    flying = [*flight.server_status(), *flight.cycle(10.0)]
    server.keep_saying([*flying, *flight.mission_status(10.0)])
    console.get_by_role("button", name="Hold", exact=True).click()
    server.wait_for_call("POST", "mission/pause")
    server.keep_saying([*flying, *flight.mission_status(10.0, pb.MISSION_PHASE_PAUSED)])
    console.get_by_role("button", name="Resume").click()
    server.wait_for_call("POST", "mission/resume")
    expect(console.get_by_role("button", name="Start", exact=True)).to_have_count(0)


def test_it_is_brought_up_by_holding_while_somebody_steers(console: Page, server: ContractServer) -> None:
    """Protects: beside what lets the vehicle drift stands what brings it up, and no stray click does it."""
    server.reply("POST", "mission/surface", {"accepted": True, "reason": ""})
    up = console.get_by_role("button", name="Surface: press and hold")
    expect(up).to_have_count(0)
    server.keep_saying([*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)])
    up.click()
    assert server.calls_of("POST", "mission/surface") == []
    up.focus()
    console.keyboard.down("Space")
    server.wait_for_call("POST", "mission/surface")
    console.keyboard.up("Space")
    server.keep_saying(flight.hello(pb.MISSION_PHASE_ABORTED))
    expect(up).to_have_count(0)


def test_abort_wants_to_be_held(console: Page, server: ContractServer) -> None:
    """Protects a mission from a stray click or key; holding aborts, by pointer and by keyboard."""
    server.reply("POST", "mission/abort", {"accepted": True, "reason": ""})
    abort = console.get_by_role("button", name="Abort mission: press and hold for 1.0 s")
    server.keep_saying(at_rest())
    expect(abort).to_be_disabled()
    server.keep_saying([*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)])
    expect(abort).to_be_enabled()

    abort.click()
    abort.press("Enter")
    expect(abort).not_to_have_attribute("data-holding", "yes")
    assert server.calls_of("POST", "mission/abort") == []

    abort.hover()
    console.mouse.down()
    expect(abort).to_have_attribute("data-holding", "yes")
    server.wait_for_call("POST", "mission/abort")
    console.mouse.up()

    abort.focus()
    console.keyboard.down("Space")
    server.wait_for_call("POST", "mission/abort", count=2)
    console.keyboard.up("Space")


def test_the_keyboard_keeps_its_place_when_controls_come_and_go(
    console: Page, server: ContractServer
) -> None:
    """Protects who starts and aborts by keyboard from being thrown back to the top of the page."""
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    server.reply("POST", "mission/abort", {"accepted": True, "reason": ""})
    idle = at_rest()
    flying = [*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)]
    bar = console.get_by_label("Mission control")
    bar.get_by_role("button", name="Start", exact=True).press("Enter")
    server.wait_for_call("POST", "mission/start")
    server.keep_saying(flying)
    expect(bar.get_by_role("button", name="Hold", exact=True)).to_be_focused()

    abort = bar.get_by_role("button", name="Hold to abort")
    abort.focus()
    console.keyboard.down("Space")
    server.wait_for_call("POST", "mission/abort")
    console.keyboard.up("Space")
    server.keep_saying(idle)
    expect(abort).to_be_disabled()
    expect(abort).to_be_focused()


@pytest.mark.parametrize("order", ["flight first", "answer first"])
def test_the_keyboard_stays_at_the_mission_however_late_the_answer_comes(
    console: Page, server: ContractServer, order: str
) -> None:
    """Protects against a start whose flight shows before its answer: the key's place fell to Abort then."""
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    answered = server.hold("POST", "mission/start")
    bar = console.get_by_label("Mission control")
    start = bar.get_by_role("button", name="Start")
    start.press("Enter")
    server.wait_for_call("POST", "mission/start")
    waiting = bar.get_by_role("button", name="Starting")
    expect(waiting).to_be_focused()
    expect(waiting).to_be_disabled()
    console.keyboard.press("Enter")
    flying = [*flight.server_status(), *flight.cycle(10.0), *flight.mission_status(10.0)]
    hold = bar.get_by_role("button", name="Hold", exact=True)
    if order == "answer first":
        answered.set()
        expect(start).to_be_enabled()
        server.keep_saying(flying)
    else:
        server.keep_saying(flying)
        expect(hold).to_be_focused()
        expect(hold).to_be_disabled()
        answered.set()
    expect(hold).to_be_enabled()
    expect(hold).to_be_focused()
    assert len(server.calls_of("POST", "mission/start")) == 1
