"""A crew of two on the real server and vehicle, each with a browser: from plan to report, no terminal."""

import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

import bumpless
from bumpless_server.settings import Settings
from tests.console.conftest import show
from tests.ports import free_port
from tests.server.serving import Running, serving

ROOT = Path(__file__).parents[2]
COMPILES_MS = 600_000  # patience with a machine that has never compiled the control cycle
FLIES_MS = 180_000  # and with a busy one that flies something beside the vehicle
YESTERDAY = "20260101T000000Z-approach-ab12"
MISSION = """
version: 1
name: approach
title: Approach with a weak screw
vehicle: ts100
duration_s: 40
seed: 1
start: {position_ned_m: [15, 0, 2.0], heading_deg: 0, speed_mps: 0.6}
legs:
  - {to_ned_m: [24.5, 0, 2.0], speed_mps: 0.6}
target: {position_ned_m: [26, 0, 2.0], heading_deg: 0, standoff_m: 1.5}
"""
STALE = """async () => {
  const told = await (await fetch("api/parameters")).json();
  const headers = { "content-type": "application/json", "if-match": `"${told.revision - 1}"` };
  const body = JSON.stringify(told.active);
  return (await fetch("api/parameters", { method: "PUT", headers, body })).status;
}"""
FAULT = "faults:\n  - {actuator: n_v1, at_s: 4, effectiveness: 0.6}\n"


@pytest.fixture
def running(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Running]:
    """Server and node as `bumpless serve` starts them, without the scene; yesterday's run lies there."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")])))
    runs = tmp_path / "data" / "runs"
    runs.mkdir(parents=True)
    mission = tmp_path / "approach.yaml"
    mission.write_text(MISSION, encoding="utf-8")
    bumpless.fly(mission).save(runs / f"{YESTERDAY}.mcap")
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=tmp_path / "data", zenoh_listen=bus, scene="off")) as server:
        yield server


@pytest.fixture
def other(browser: Browser) -> Iterator[Page]:
    """The second browser."""
    context = browser.new_context(viewport={"width": 1440, "height": 900}, accept_downloads=True)
    yield context.new_page()
    context.close()


def test_a_crew_of_two_plans_flies_explains_compares_and_sends(
    page: Page, other: Page, running: Running
) -> None:
    """Protects a crew's day: whatever one does the other sees, and nothing of it needs a terminal."""
    for one in (page, other):
        one.goto(f"{running.url}/")
        expect(one.get_by_label("Link: Live")).to_be_visible(timeout=COMPILES_MS)
    plan_and_start(page)
    expect(other.get_by_label("Mission phase")).to_have_text("Running")
    draft_ahead_and_apply(page, other)
    explain_the_switch(other)
    expect(page.get_by_label("Mission phase")).to_have_text(re.compile("Held|Docked"), timeout=FLIES_MS)
    name = replay(other)
    compare(other, name)
    send(page, name)
    fly_again(page, name)


def plan_and_start(page: Page) -> None:
    """A mission with a fault in it is put in and started."""
    show(page, "Missions")
    text = (MISSION + FAULT).encode()
    page.set_input_files(
        "input[type=file]", files=[{"name": "approach.yaml", "mimeType": "text/yaml", "buffer": text}]
    )
    expect(page.get_by_role("img", name=re.compile("Plan from above: 2 waypoints"))).to_be_visible()
    page.get_by_role("button", name="Start this mission").click()
    expect(page.get_by_label("Mission phase")).to_have_text("Running")


def draft_ahead_and_apply(page: Page, other: Page) -> None:
    """Both draft; one sees what the draft would do and applies it; what was made before is then refused."""
    for one in (page, other):
        show(one, "Mode weights")
    other.get_by_label("Hover: N_sw", exact=True).fill("90")
    page.get_by_label("Reverse: N_sw", exact=True).fill("80")
    ahead = page.get_by_role("table", name="Figures ahead")
    expect(ahead).to_contain_text("Residual RMS", timeout=FLIES_MS)
    expect(page.get_by_role("status").filter(has_text="over revision")).to_be_visible()
    page.get_by_label("Reason of the change").fill("calmer switch")
    page.get_by_role("button", name="Apply to vehicle").click()
    expect(page.get_by_label("Draft", exact=True)).to_contain_text("Confirmed by the vehicle")
    revisions = page.get_by_role("region", name="Revisions")
    expect(revisions).to_contain_text("calmer switch")
    expect(revisions).to_contain_text("reverse.ramp_cycles")

    stale = other.get_by_role("status").filter(has_text="Applying it would be refused")
    expect(stale).to_be_visible()
    barred = other.get_by_role("button", name="Apply to vehicle")
    expect(barred).to_be_disabled()
    expect(barred).to_have_attribute("title", "Another operator is in control")
    assert page.evaluate(STALE) == 412  # and of who holds it, a change of an old revision is refused as well
    stale.get_by_role("button").click()
    expect(stale).to_have_count(0)
    other.get_by_role("button", name="Revert all").click()


def explain_the_switch(page: Page) -> None:
    """The log says of the switch to reverse what was true and what would have prevented it."""
    show(page, "Live")
    switch = page.get_by_role("log").get_by_role("listitem").filter(has_text="to reverse").first
    expect(switch).to_be_visible(timeout=FLIES_MS)
    switch.locator("summary").click()
    facts = switch.locator("dl")
    expect(facts).to_contain_text("would have been prevented by")
    expect(facts).not_to_contain_text("not told")
    expect(facts).to_contain_text(re.compile(r"range, target\s*\d+\.\d+ m, seen"))
    expect(switch.get_by_role("img", name="Transition factor and weights")).to_be_visible(timeout=FLIES_MS)
    expect(facts).to_contain_text(re.compile(r"step of the commands\s*0\.\d{4} , last run's 0\.\d{4}"))


def replay(page: Page) -> str:
    """The run of today is seen again at its switch, while the bar stays live; its id."""
    show(page, "Runs")
    run = running_id(page)
    page.goto(re.sub(r"#.*", "", page.url) + f"#/runs/{run}?t=6.0")
    expect(page.get_by_role("region", name="Replay")).to_contain_text("T+00:06.0")
    expect(page.get_by_label("Link: Live")).to_be_visible()
    return run


def running_id(page: Page) -> str:
    """The id of today's run, out of the list."""
    title = (
        page.locator(".run-list tbody button.link").filter(has_text="approach").first.get_attribute("title")
    )
    assert title and title != YESTERDAY
    return title.removesuffix(".2")


def compare(page: Page, run: str) -> None:
    """Beside yesterday's: what differs is the fault."""
    show(page, "Runs")
    for name in (YESTERDAY, run):
        page.get_by_label(f"Mark {name} to compare").check()
    page.get_by_role("button", name="Compare 2").click()
    expect(page.get_by_role("table", name="What differs")).to_contain_text("faults[0].actuator")


def send(page: Page, run: str) -> None:
    """The report is one file."""
    page.goto(re.sub(r"#.*", "", page.url) + f"#/runs/{run}")
    href = page.get_by_role("link", name="Report").get_attribute("href")
    report = page.request.get(re.sub(r"#.*", "", page.url) + str(href), timeout=FLIES_MS)
    assert report.ok and "<!doctype html>" in report.text().lower()
    page.get_by_label("Export as").select_option("csv")
    page.get_by_label("Signals of the table").fill("navigation.depth_m")
    with page.expect_download(timeout=FLIES_MS) as download:
        page.get_by_role("link", name="Export", exact=True).click()
    assert download.value.path().read_text().startswith("cycle,time_s,time_ns,navigation.depth_m")


def fly_again(page: Page, run: str) -> None:
    """And what would have been with another weight is flown and compared at once."""
    page.get_by_text("Fly again with other numbers").click()
    form = page.get_by_role("form", name="Fly again")
    form.get_by_label("Parameter 1", exact=True).fill("hover.lambda")
    form.get_by_label("Value of parameter 1", exact=True).fill("0.5")
    form.get_by_role("button", name="Fly and compare").click()
    differs = page.get_by_role("table", name="What differs")
    expect(differs).to_contain_text("hover.lambda", timeout=FLIES_MS)
