"""System: nothing silent, who did what, who may; and who holds control, in a real browser."""

import json

from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import CLIENT, me

ADA = "aaaaaaaaaaaa"


def test_what_was_not_taken_as_it_came_is_shown_with_its_last_example(console: Page) -> None:
    """Protects: nothing is ignored, late or malformed without a place where it is seen."""
    show(console, "System")
    row = console.get_by_role("row", name="cannot be decoded")
    expect(row).to_contain_text("3")
    expect(row).to_contain_text("tlm/control")
    expect(console.get_by_text("Commands that reached the vehicle after their time")).to_have_count(0)
    console.get_by_label("all kinds").check()
    expect(console.get_by_text("Commands that reached the vehicle after their time")).to_be_visible()
    expect(console.get_by_text("runs/odd.mcap")).to_be_visible()


def test_the_audit_says_who_changed_what_and_is_found_by_words(console: Page) -> None:
    """Protects: a crew can see by whom a flight was begun and tuned, without opening a file."""
    show(console, "System")
    console.get_by_role("button", name="Audit").click()
    expect(console.get_by_text("hover.lambda 0.1 → 0.2")).to_be_visible()
    console.get_by_label("Search in the audit").fill("ada docking")
    expect(console.get_by_role("row", name="start")).to_be_visible()
    expect(console.get_by_text("hover.lambda 0.1 → 0.2")).to_have_count(0)
    link = console.get_by_role("link", name="All as a file")
    expect(link).to_have_attribute("href", "api/audit.jsonl")


def test_somebody_elses_control_is_seen_and_taken_with_a_reason(
    console: Page, server: ContractServer
) -> None:
    """Protects: two operators never command against each other without knowing it; stopping stays open."""
    expect(console.get_by_label("Control:")).to_have_count(0)  # alone: nothing to tell
    server.keep_saying([*flight.cycle(10.0), *flight.mission_status(10.0), *flight.held_by(ADA, "Ada")])
    chip = console.get_by_label("Control: Ada")
    expect(chip).to_be_visible()
    expect(console.get_by_role("button", name="Hold", exact=True)).to_be_enabled()
    expect(console.get_by_role("button", name="Abort mission")).to_be_enabled()
    chip.click()
    server.reply("POST", "control/take", {})
    console.get_by_label("Why control is taken").fill("Ada is on the phone")
    console.get_by_role("button", name="Take control").click()
    body = server.wait_for_call("POST", "control/take").json()
    assert body == {"reason": "Ada is on the phone"}


def test_a_request_for_control_is_seen_and_granted(console: Page, server: ContractServer) -> None:
    """Protects: who holds control sees that it is asked for, on every view, and hands it over."""
    asked = [pb.ControlRequest(client=ADA, name="Ada", since_ns=flight.START_NS, reason="my turn")]
    server.keep_saying([*flight.hello(), *flight.held_by(CLIENT, "Browser 0123", requests=asked)])
    console.get_by_label("Control: yours, 1 asking").click()
    expect(console.get_by_text("Ada asks for control: my turn")).to_be_visible()
    server.reply("POST", "control/hand", {})
    console.get_by_role("button", name="Hand control to Ada").click()
    assert server.wait_for_call("POST", "control/hand").json() == {"client": ADA}


def test_an_observer_sees_and_can_start_nothing(page: Page, server: ContractServer) -> None:
    """Protects: what a role may not is not offered; it is told who one is."""
    server.reply("GET", "me", me("observer", accounts=True, name="olga"))
    page.goto(f"{server.url}#/system/people")
    expect(page.get_by_text("Logged in as olga, observer")).to_be_visible()
    expect(page.get_by_text("Engineers see and change accounts here.")).to_be_visible()
    expect(page.get_by_role("button", name="Start")).to_have_attribute("aria-disabled", "true")


def test_an_engineer_makes_an_account_and_a_token_that_is_shown_once(
    page: Page, server: ContractServer
) -> None:
    """Protects: accounts need no terminal; a password is sent to the server and shown nowhere."""
    server.reply("GET", "me", me(accounts=True, name="erna"))
    user = {"name": "erna", "role": "engineer", "since": "2026-01-01T00:00:00Z", "sessions": 1, "tokens": 0}
    server.reply("GET", "users", [user])
    page.goto(f"{server.url}#/system/people")
    form = page.get_by_role("form", name="New account")
    form.get_by_label("Name").fill("nina")
    form.get_by_label("Password").fill("correct horse")
    form.get_by_label("Role").select_option("observer")
    server.reply("POST", "users", {**user, "name": "nina"}, 201)
    form.get_by_role("button").click()
    wanted = {"name": "nina", "role": "observer", "password": "correct horse"}
    assert server.wait_for_call("POST", "users").json() == wanted
    made = {"id": "t", "name": "nightly", "user": "erna", "role": "operator", "until": None}
    made |= {"since": "2026-01-01T00:00:00Z", "secret": "bmp_only-once"}
    server.reply("POST", "tokens", made, 201)
    form = page.get_by_role("form", name="New token")
    form.get_by_label("Name").fill("nightly")
    form.get_by_role("button").click()
    expect(page.get_by_text("bmp_only-once")).to_be_visible()
    assert json.loads(server.calls_of("POST", "tokens")[0].body)["days"] == 30


def test_a_session_that_is_over_leads_to_the_login(console: Page, server: ContractServer) -> None:
    """Protects: a page whose session has ended does not stand there as if it still worked."""
    show(console, "Runs")
    server.reply("GET", "me", {"detail": "log in first", "problems": []}, 401)
    server.stop()
    server.start()
    console.wait_for_url(f"{server.url}login#/runs")


def test_commands_carry_a_name_of_their_own(console: Page, server: ContractServer) -> None:
    """Protects: a command whose answer was lost is not carried out twice when it is sent again."""
    server.reply("POST", "mission/start", {"accepted": True, "reason": "", "problems": [], "id": "x"})
    with console.expect_request("**/api/mission/start") as first:
        console.get_by_role("button", name="Start").click()
    key = first.value.header_value("idempotency-key")
    assert key and len(key) == 24
