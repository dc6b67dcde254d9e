"""Two flights laid over each other, on the real server; and the list of runs that leads there."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

import bumpless
from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.server.serving import Running, serving

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"
ONE, OTHER = "20260101T000000Z-docking-ab12", "20260102T000000Z-docking-cd34"


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """A server without a vehicle that has recorded two flights, the other with another weight."""
    data = tmp_path_factory.mktemp("data")
    (data / "runs").mkdir()
    bumpless.fly(MISSION).save(data / "runs" / f"{ONE}.mcap")
    weights = {"hover": {"lambda": 0.5}}
    bumpless.fly(MISSION, seed=5, parameters=weights).save(data / "runs" / f"{OTHER}.mcap")
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=data, zenoh_listen=bus, scene="off", manage_node=False)) as server:
        assert server.console.keeper.indexed.wait(60)
        yield server


def test_marked_runs_are_compared(page: Page, running: Running) -> None:
    """Protects the way from the list to lines, figures with better and worse, and what differs."""
    page.goto(f"{running.url}/#/runs")
    for run in (ONE, OTHER):
        page.get_by_label(f"Mark {run} to compare").check()
    page.get_by_role("button", name="Compare 2").click()
    expect(page).to_have_url(re.compile("compare="))
    figures = page.get_by_role("table", name="Figures")
    expect(figures.get_by_role("row").filter(has_text="d_u R→H").first).to_be_visible()
    expect(figures.locator("[data-change]").first).to_be_visible()
    differs = page.get_by_role("table", name="What differs")
    expect(differs).to_contain_text("hover.lambda")
    expect(differs).to_contain_text("seed")
    expect(page.locator(".overlay canvas")).to_have_count(6)
    page.get_by_role("group", name="Align on").get_by_role("button", name="To H").click()
    expect(page.get_by_label("Lines", exact=True)).to_contain_text("seconds from the switch to hover")
    page.get_by_role("button", name="Compare with this").click()
    expect(page.locator(".compared-list li").first).to_contain_text(OTHER)


def test_a_run_is_named_tagged_found_thrown_away_and_taken_back(page: Page, running: Running) -> None:
    """Protects the list as a crew's notebook: nothing of it needs a terminal, and a slip can be undone."""
    page.goto(f"{running.url}/#/runs/{ONE}")
    form = page.get_by_role("form", name="Title, tags and note")
    form.get_by_label("Title").fill("First of May")
    form.get_by_label("Tags").fill("calm, trial 3")
    form.get_by_role("button", name="Save").click()
    rows = page.get_by_role("region", name="Runs", exact=True).get_by_role("row")
    expect(rows.filter(has_text="First of May")).to_contain_text("trial 3")
    search = page.get_by_label("Search in runs")
    search.fill("calm may")
    expect(rows).to_have_count(2)
    search.fill("")
    expect(rows).to_have_count(3)
    delete = page.get_by_role("button", name=f"Delete run {ONE}")
    delete.hover()
    page.mouse.down()
    expect(page.get_by_role("status").filter(has_text="is in the bin")).to_be_visible()
    page.mouse.up()
    expect(rows).to_have_count(2)
    page.get_by_role("button", name="Undo").click()
    expect(rows.filter(has_text="First of May")).to_have_count(1)
