"""The planner in a real browser: one document in three views, kept, judged and started as it is shown."""

import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.console import planner
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.planner import stored
from tests.console.test_axe import faults

TEXT = """version: 1
name: harbour
vehicle: ts100
duration_s: 90  # enough
start:
  position_ned_m: [0, 0, 2.0]
  heading_deg: 0
legs:
  - {to_ned_m: [10, 0, 2.0], speed_mps: 0.7}
  - {to_ned_m: [24.5, 0, 2.3], speed_mps: 0.7}
target:
  position_ned_m: [26, 0, 2.3]
  heading_deg: 0
  standoff_m: 1.5
"""


@pytest.fixture
def planned(console: Page, server: ContractServer) -> Iterator[Page]:
    """The planner with one stored mission open."""
    planner.default_replies(server)
    server.foresee = lambda _: planner.forecast(198)
    keep(server, TEXT)
    console.goto(f"{server.url}#/plan/harbour")
    expect(console.get_by_label("How it is kept")).to_contain_text("Saved")
    expect(console.get_by_label("State of the forecast")).to_have_text("up to date")
    yield console


def keep(server: ContractServer, text: str) -> None:
    """Store a text as `harbour`."""
    server.reply("GET", "missions", [stored("harbour", text)])
    server.reply("GET", "missions/harbour", stored("harbour", text))


def yaml(page: Page) -> str:
    """The text in the editor."""
    page.get_by_role("button", name="YAML").click()
    expect(page.locator(".cm-line").first).to_be_visible()
    return "\n".join(page.locator(".cm-line").all_inner_texts())


def test_a_drag_changes_plan_form_and_text_at_once_and_is_undone_as_one(planned: Page) -> None:
    """Protects the one document: what is dragged is typed, comments stay, and one undo takes it back."""
    planner.drag(planned, (10, 0), (12, 3))
    expect(planned.get_by_role("heading", name="Waypoint 1")).to_be_visible()
    expect(planned.get_by_label("End of the leg east, legs[0].to_ned_m")).to_have_value("3")
    text = yaml(planned)
    assert "  - {to_ned_m: [12, 3, 2.0], speed_mps: 0.7}" in text and "# enough" in text
    expect(planned.get_by_label("How it is kept")).to_contain_text("Not saved")
    planned.get_by_role("button", name="Undo").click()
    expect(planned.locator(".cm-content")).to_contain_text("[10, 0, 2.0]")
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")


def test_a_shipped_mission_is_opened_as_it_is_and_an_edit_makes_a_copy(
    planned: Page, server: ContractServer
) -> None:
    """Protects what is shipped: shown, forecast and startable by its address, never edited itself."""
    shipped = stored("docking", TEXT.replace("name: harbour", "name: docking"), builtin=True)
    other = stored("pods", TEXT, builtin=True, vehicle="twinpod")
    server.reply("GET", "missions", [other, shipped])
    server.reply("GET", "missions/docking", shipped)
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    planned.get_by_role("button", name="Open …").click()
    missions = planned.get_by_label("Missions to open")
    expect(missions.locator(".library-row")).to_have_count(2)
    expect(missions.locator(".library-row").last).to_contain_text("for twinpod")
    missions.locator(".library-open", has_text="docking").click()
    kept = planned.get_by_label("How it is kept")
    expect(kept).to_contain_text("Saved")
    expect(planned.get_by_label("State of the forecast")).to_have_text("up to date")

    planner.drag(planned, (10, 0), (12, 3))
    expect(kept).to_contain_text("Not saved")
    expect(planned).to_have_url(f"{server.url}#/plan/docking_2")
    text = yaml(planned)
    assert "name: docking_2" in text and "[12, 3, 2.0]" in text and "# enough" in text
    planned.get_by_role("button", name="Undo").click()
    expect(kept).to_contain_text("Saved")
    expect(planned).to_have_url(f"{server.url}#/plan/docking")

    expect(planned.get_by_label("State of the forecast")).to_have_text("up to date")
    planned.get_by_role("button", name="Start …").first.click()
    hold = planned.get_by_role("dialog", name="Before the start").get_by_role("button", name="Hold to start")
    hold.hover()
    planned.mouse.down()
    call = server.wait_for_call("POST", "mission/start")
    planned.mouse.up()
    assert call.json() == {"name": "docking", "sha256": shipped["sha256"]}


def test_what_is_typed_moves_the_drawing_and_a_wrong_number_is_refused(planned: Page) -> None:
    """Protects exact entry with ranges: a number out of range never reaches the document."""
    planner.click(planned, 26, 0)
    heading = planned.get_by_label("Approach heading", exact=True)
    heading.fill("45")
    planned.get_by_role("button", name="Legs").click()
    row = planned.get_by_role("table", name="Legs").get_by_role("row").nth(2)
    expect(row).to_contain_text("356")  # the last leg leads to the observation point, which went along
    planned.get_by_role("button", name="Details").click()
    planned.get_by_label("Standoff").fill("999")
    expect(planned.get_by_label("Standoff")).to_have_attribute("aria-invalid", "true")
    assert "standoff_m: 1.5" in yaml(planned)


def test_the_text_is_edited_and_the_views_follow(planned: Page) -> None:
    """Protects the text as a view of its own: typed numbers move the plan, a broken text says where."""
    assert "heading_deg: 0" in yaml(planned)
    line = planned.locator(".cm-line", has_text="duration_s")
    line.click()
    planned.keyboard.press("End")
    planned.keyboard.press("Enter")
    planned.keyboard.type("seed: 7: 8")
    expect(planned.get_by_label("Findings")).to_contain_text("can't be read")
    planned.keyboard.press("ControlOrMeta+z")
    expect(planned.get_by_label("Findings")).to_have_count(0)


def test_the_plan_is_edited_by_keyboard_alone(planned: Page) -> None:
    """Protects who works without a pointer: select, move, dive, turn, add, delete, undo."""
    plan = planned.get_by_role("application", name="Plan from above")
    plan.focus()
    for key in ("n", "n", "ArrowRight", "ArrowUp", "PageDown"):
        planned.keyboard.press(key)
    expect(planned.get_by_label("End of the leg north, legs[0].to_ned_m")).to_have_value("10.5")
    expect(planned.get_by_label("End of the leg east, legs[0].to_ned_m")).to_have_value("0.5")
    expect(planned.get_by_label("End of the leg down, legs[0].to_ned_m")).to_have_value("2.1")
    planned.keyboard.press("w")
    expect(planned.get_by_role("heading", name="Waypoint 2")).to_be_visible()
    planned.keyboard.press("Delete")
    planned.keyboard.press("Escape")
    for key in ("p", "p", "]"):  # the current is last, the dock before it
        planned.keyboard.press(key)
    expect(planned.get_by_label("Approach heading", exact=True)).to_have_value("5")
    for _ in range(8):
        planned.keyboard.press("ControlOrMeta+z")
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")


def test_a_draft_outlives_a_reload(planned: Page) -> None:
    """Protects unsaved work, and the choice in the address."""
    planner.drag(planned, (10, 0), (12, 3))
    planned.reload()
    expect(planned.get_by_label("How it is kept")).to_contain_text("Not saved")
    assert "[12, 3, 2.0]" in yaml(planned)


def test_saving_sends_the_bytes_and_says_when_somebody_else_was_faster(
    planned: Page, server: ContractServer
) -> None:
    """Protects from a lost update: the file that was edited is named, another one stays unless asked for."""
    planner.drag(planned, (10, 0), (12, 3))
    server.reply("PUT", "missions/harbour", stored("harbour", TEXT.replace("[10, 0, 2.0]", "[12, 3, 2.0]")))
    theirs = TEXT.replace("duration_s: 90", "duration_s: 95")
    hashed = stored("harbour", TEXT)["sha256"]
    planned.keyboard.press("ControlOrMeta+s")
    call = server.wait_for_call("PUT", "missions/harbour")
    assert (call.query, call.body) == (f"base={hashed}", TEXT.replace("[10, 0, 2.0]", "[12, 3, 2.0]"))
    keep(server, theirs)
    planner.drag(planned, (12, 3), (12, 0))
    planned.get_by_role("navigation").get_by_role("link", name="Missions").click()
    show(planned, "Plan")
    expect(planned.get_by_role("alert")).to_contain_text("changed since you began")


def test_a_hopeless_plan_says_why_and_is_mended_by_one_button(planned: Page, server: ContractServer) -> None:
    """Protects the mend: what hangs on the dock goes along, and the start is blocked until then."""
    server.foresee = lambda asked: (
        planner.forecast(198)
        if "heading_deg: 90" in asked["text"].split("target:")[1]
        else planner.forecast(0, findings=[planner.hopeless(90)])
    )
    planner.drag(planned, (10, 0), (10, 0.5))
    findings = planned.get_by_label("Findings")
    expect(findings).to_contain_text("can't hold station")
    planned.get_by_role("button", name="Start …").first.click()
    sheet = planned.get_by_role("dialog", name="Before the start")
    expect(sheet).to_contain_text("It can't work as it is")
    expect(sheet.get_by_role("button", name="Hold to save and start")).to_be_disabled()
    sheet.get_by_role("button", name="Close").click()
    findings.get_by_role("button", name="Approach with 90°").click()
    expect(planned.get_by_label("Chance")).to_contain_text("Docks in 198 of 200")
    assert "[26, -1.5, 2.3]" in yaml(planned)


def test_a_low_chance_names_what_would_help(planned: Page, server: ContractServer) -> None:
    """Protects: a plan that can work and seldom docks is no dead end; what costs most is offered first."""
    early, differs = planner.doubtful("seen_early"), planner.doubtful("current_may_differ")
    differs["mends"] = [
        {"label": "Approach into the current", "path": "target.approach", "value": "into_current"}
    ]
    server.foresee = lambda asked: (
        planner.forecast(200)
        if "into_current" in asked["text"]
        else planner.forecast(146, findings=[early, differs])
    )
    planner.drag(planned, (10, 0), (10, 0.5))
    next_step = planned.get_by_role("status", name="Next step")
    expect(next_step).to_contain_text("Docks in 146 of 200. What would help:")
    next_step.get_by_role("button", name="Approach into the current").click()
    expect(next_step).to_contain_text("This will dock.")
    assert "approach: into_current" in yaml(planned)


def test_what_cannot_work_starts_by_a_second_gesture_that_says_what_was_found(
    planned: Page, server: ContractServer
) -> None:
    """Protects a deliberate try: blocked until what was found is ticked off, and the server is told so."""
    server.foresee = lambda _: planner.forecast(0, findings=[planner.hopeless(90)])
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    planned.reload()
    expect(planned.get_by_label("Findings")).to_contain_text("can't hold station")
    planned.get_by_role("button", name="Start …").first.click()
    sheet = planned.get_by_role("dialog", name="Before the start")
    hold = sheet.get_by_role("button", name="Hold to start")
    expect(hold).to_be_disabled()
    again = sheet.get_by_role("checkbox", name="Start all the same")
    expect(again).to_have_accessible_name(re.compile("can't hold station in this current"))
    again.check()
    expect(hold).to_contain_text("all the same")
    hold.hover()
    planned.mouse.down()
    call = server.wait_for_call("POST", "mission/start")
    planned.mouse.up()
    digest = stored("harbour", TEXT)["sha256"]
    assert call.json() == {"name": "harbour", "sha256": digest, "despite_findings": True}


def test_start_wants_to_be_held_and_flies_the_very_text_that_is_shown(
    planned: Page, server: ContractServer
) -> None:
    """Protects the start: saved first, by the hash of what is shown, and no chooser beside it for another."""
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    expect(planned.get_by_label("Mission control").get_by_role("combobox")).to_have_count(0)
    planner.drag(planned, (10, 0), (12, 3))
    made = TEXT.replace("[10, 0, 2.0]", "[12, 3, 2.0]")
    server.reply("PUT", "missions/harbour", stored("harbour", made))
    expect(planned.get_by_label("State of the forecast")).to_have_text("up to date")
    planned.get_by_role("button", name="Start …").first.click()
    sheet = planned.get_by_role("dialog", name="Before the start")
    expect(sheet).to_contain_text("docks in 198 of 200")
    hold = sheet.get_by_role("button", name="Hold to save and start")
    hold.click()
    assert server.calls_of("POST", "mission/start") == []
    server.reply("GET", "missions", [stored("harbour", made)])
    hold.hover()
    planned.mouse.down()
    call = server.wait_for_call("POST", "mission/start")
    planned.mouse.up()
    assert call.json() == {"name": "harbour", "sha256": stored("harbour", made)["sha256"]}
    expect(planned.get_by_role("main", name="Live")).to_be_visible()


def test_an_open_plan_has_no_serious_fault_for_who_reads_by_ear_or_keyboard(planned: Page) -> None:
    """Protects every part of the planner, opened: axe-core finds nothing serious or moderate."""
    found = {"mission": faults(planned)}
    planner.click(planned, 26, 0)
    expect(planned.get_by_role("heading", name="Dock", exact=True)).to_be_visible()
    for tab in ("Details", "Legs", "YAML", "What if", "Keys"):
        planned.get_by_role("button", name=tab, exact=True).click()
        found[tab] = faults(planned)
    planned.get_by_role("button", name="Start …").first.click()
    expect(planned.get_by_role("dialog", name="Before the start")).to_be_visible()
    found["sheet"] = faults(planned)
    assert not {part: bad for part, bad in found.items() if bad}


def test_a_worst_flight_is_one_click_away(planned: Page) -> None:
    """Protects the way from a chance to the flight that spoils it, by its seed."""
    worst = planned.get_by_role("button", name="waved off").first
    expect(worst).to_contain_text("seed 1199")
    worst.click()
    expect(worst).to_have_attribute("aria-pressed", "true")


def test_an_earlier_version_is_shown_with_its_difference_and_taken_as_a_step_to_undo(
    planned: Page, server: ContractServer
) -> None:
    """Protects the way back over saves: what differs is read before it is taken."""
    old = TEXT.replace("duration_s: 90", "duration_s: 120")
    version = {"id": "v1", "saved": "2026-01-01T00:00:00Z", "size": 300, "sha256": "0" * 64}
    server.reply("GET", "missions/harbour/history", [version])
    server.reply("GET", "missions/harbour/history/v1", {"id": "v1", "sha256": "0" * 64, "yaml": old})
    planned.get_by_role("button", name="More").click()
    planned.get_by_role("button", name="Earlier versions …").click()
    sheet = planned.get_by_role("dialog", name="Earlier versions")
    sheet.get_by_role("button", name="2026-01-01").click()
    difference = sheet.get_by_label("Difference")
    expect(difference.locator("[data-kind=gone]")).to_contain_text("duration_s: 90")
    expect(difference.locator("[data-kind=new]")).to_contain_text("duration_s: 120")
    sheet.get_by_role("button", name="Take this version").click()
    assert "duration_s: 120" in yaml(planned)
    planned.get_by_role("button", name="Undo").click()
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")


def test_a_variant_is_flown_beside_the_plan(planned: Page, server: ContractServer) -> None:
    """Protects what-if: its changes go beside the text, never into it, and both stand side by side."""
    asked: list[dict[str, Any]] = []

    def foresee(request: dict[str, Any]) -> list[dict[str, Any]]:
        asked.append(request)
        return planner.forecast(150 if request.get("overrides", {}).get("parameters") else 198)

    server.foresee = foresee
    planned.get_by_role("button", name="What if").click()
    planned.get_by_label("What if: speed of the current").fill("0.1")
    planned.get_by_label("What if: parameter").fill("supervisor.range_fr_lower_m")
    planned.get_by_label("What if: supervisor.range_fr_lower_m").fill("9")
    row = planned.get_by_role("table", name="Plan and what if").get_by_role("row").nth(2)
    expect(row.get_by_role("cell")).to_have_text(["99.0", "75.0", "\N{MINUS SIGN}24.0"])
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")
    assert asked[-1]["text"] == TEXT
    assert asked[-1]["overrides"] == {
        "parameters": {"supervisor.range_fr_lower_m": 9},
        "current": [0.1, 0, 0],
        "vehicle": None,
    }


def test_a_deleted_mission_comes_back(planned: Page, server: ContractServer) -> None:
    """Protects from a slip: delete is undone from the server's bin."""
    binned = {"id": "b1", "name": "harbour", "deleted": "2026-01-01T00:00:00Z", "size": 9}
    server.reply("DELETE", "missions/harbour", binned)
    server.reply("POST", "mission-bin/b1/restore", stored("harbour", TEXT))
    planned.get_by_role("button", name="More").click()
    planned.get_by_role("button", name="Delete", exact=True).click()
    planned.get_by_role("status").filter(has_text="harbour deleted.").get_by_role(
        "button", name="Undo"
    ).click()
    server.wait_for_call("POST", "mission-bin/b1/restore")
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")


def test_the_planner_loads_when_it_is_opened_and_not_before(page: Page, server: ContractServer) -> None:
    """Protects the first load; the planner's code is at most 250 kB gzipped."""
    planner.default_replies(server)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(server.url)
    expect(page.locator("figure.plot").first).to_be_visible()
    before = set(asked)
    assert not any("planner" in url for url in before)
    show(page, "Plan")
    expect(page.get_by_role("button", name="New mission")).to_be_visible()
    loaded = [url.rsplit("/", 1)[1] for url in asked if url not in before and "/assets/" in url]
    files = [server.console / "assets" / name for name in loaded]
    sizes = [min(p.stat().st_size for p in (f, f.with_name(f"{f.name}.gz")) if p.is_file()) for f in files]
    assert loaded and sum(sizes) <= 250_000


def test_a_failed_actuator_is_tried_beside_the_plan_and_taken_into_it(
    planned: Page, server: ContractServer
) -> None:
    """Protects what-if of a failure: the file stays until it is made the plan, and undo leads back."""
    asked: list[dict[str, Any]] = []

    def foresee(request: dict[str, Any]) -> list[dict[str, Any]]:
        asked.append(request)
        return planner.forecast(20 if "faults:" in request["text"] else 198)

    server.foresee = foresee
    planned.get_by_role("button", name="What if").click()
    planned.get_by_label("What if: actuator that fails").select_option("n_p")
    planned.get_by_label("What if: when it fails").fill("40")
    row = planned.get_by_role("table", name="Plan and what if").get_by_role("row").nth(2)
    expect(row.get_by_role("cell")).to_have_text(["99.0", "10.0", "\N{MINUS SIGN}89.0"])
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")
    assert "- {actuator: n_p, at_s: 40, effectiveness: 0}" in asked[-1]["text"]
    planned.get_by_role("button", name="Make it the plan").click()
    expect(planned.get_by_label("Chance")).to_contain_text("Docks in 20 of 200")
    expect(planned.get_by_role("button", name="Fault of n_p from 40.0 s, 0 % left")).to_be_visible()
    planned.get_by_role("button", name="Undo").click()
    expect(planned.get_by_label("How it is kept")).to_contain_text("Saved")
