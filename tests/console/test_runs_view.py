"""Runs: flights and their files, the list and its views, the metrics, a deletion that is meant."""

import json
import re
from typing import Any

from playwright.sync_api import Page, expect

from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import OLD_RUN_ID, RUN_ID, run, whole


def test_a_finished_run_shows_its_metrics_and_can_be_downloaded(console: Page) -> None:
    """Protects every figure of the metrics table and the file behind the button."""
    show(console, "Runs")
    metrics = console.get_by_label("Metrics", exact=True)
    expect(metrics).to_contain_text("RMS e_τ0.1234")
    expect(metrics).to_contain_text("r_sat21.7 %")
    expect(metrics).to_contain_text("d_u F→R0.0456 of bound")
    expect(metrics).to_contain_text("d_u R→H0.0321 of bound")
    expect(metrics).to_contain_text("Solved99.8 %")
    expect(metrics).to_contain_text("d_u F→R, settling0.0767 of bound")
    expect(metrics).to_contain_text("Shaft energy16.6 J")
    expect(metrics).to_contain_text("Reversals15")
    end = metrics.get_by_role("table", name="At the end")
    expect(end.get_by_role("row").nth(1)).to_contain_text("true0.2130.210−0.0409.410.022")
    expect(end).to_contain_text("closest0.532m to the marker, 89.9 s after the start")
    tracking = metrics.get_by_role("table", name="Error about the reference")
    expect(tracking.get_by_role("row").nth(1)).to_contain_text("0.187 / 0.310")
    expect(metrics.get_by_role("table", name="Switches").get_by_role("row").nth(1)).to_contain_text("0.0767")
    expect(metrics.get_by_role("table", name="By mode").get_by_role("row")).to_have_count(9)
    expect(metrics.get_by_role("table", name="Switches").get_by_role("row").nth(1)).to_contain_text("24.05")
    expect(metrics.get_by_role("table", name="Allocator's run time")).to_contain_text("112")
    expect(metrics).to_contain_text("Proposition 1 0 violations")
    with console.expect_download() as download:
        console.get_by_role("link", name="Download MCAP").click()
    assert download.value.suggested_filename == f"{OLD_RUN_ID}.mcap"
    assert download.value.path().read_bytes() == b"\x89MCAP0\r\n"


def test_every_ending_has_its_own_word_and_shape(console: Page, server: ContractServer) -> None:
    """Protects: no flight is called complete; what ended well, badly or not at all is told without colour."""
    endings = ["docked", "held", "waved_off", "time_over", "aborted", "collided", "interrupted"]
    rows = [run(f"2026010{k}T000000Z-a-0000", "a", "complete", "", word) for k, word in enumerate(endings)]
    server.reply("GET", "runs", [*rows, run("20250101T000000Z-old-0000", "old", "complete", "done")])
    show(console, "Runs")
    table = console.get_by_role("region", name="Runs")
    chips = table.locator("tbody .chip")
    expect(chips).to_have_count(8)
    words = [word.replace("_", " ") for word in reversed(endings)]
    assert [text.strip() for text in chips.all_inner_texts()] == [*words, "not judged"]
    expect(table).not_to_contain_text("complete")
    shapes = chips.evaluate_all("chips => chips.map(c => c.querySelector('svg').innerHTML)")
    assert len(set(shapes)) == len(shapes)
    expect(chips.first).to_have_attribute("title", "in hover, truly 0.21 m from the observation point.")


def test_a_run_being_recorded_grows_and_cannot_be_deleted(console: Page, server: ContractServer) -> None:
    """Protects the list from being asked for again and again: size and duration come with the stream."""
    server.reply("GET", "runs", [run(RUN_ID, "docking", "recording", "")])
    server.keep_saying([*flight.hello(), *flight.mission_status(35.0), *flight.server_status(recording=True)])
    show(console, "Runs")
    row = console.get_by_label("Runs", exact=True).get_by_role("row").nth(1)
    expect(row).to_contain_text("recording")
    expect(row).to_contain_text("00:35")
    expect(console.get_by_label("docking", exact=True)).to_contain_text("Size2.3 MB")
    expect(console.get_by_role("button", name=f"Delete run {RUN_ID}")).to_be_disabled()
    expect(console.get_by_text("Metrics are computed when the run ends.")).to_be_visible()


def test_a_run_is_deleted_by_holding(console: Page, server: ContractServer) -> None:
    """Protects records from a click."""
    server.reply("DELETE", f"runs/{OLD_RUN_ID}", None)
    show(console, "Runs")
    delete = console.get_by_role("button", name=f"Delete run {OLD_RUN_ID}")
    delete.click()
    assert server.calls_of("DELETE", f"runs/{OLD_RUN_ID}") == []
    server.reply("GET", "runs", [])
    delete.hover()
    console.mouse.down()
    server.wait_for_call("DELETE", f"runs/{OLD_RUN_ID}")
    console.mouse.up()
    expect(console.get_by_text("No runs yet.")).to_be_visible()


def in_pieces() -> list[dict[str, Any]]:
    """A flight in three files: cut off by a crash, gone on, and the hold after it."""
    first = run(OLD_RUN_ID, "docking", "interrupted", "the recording was cut off", "interrupted")
    second = run(f"{OLD_RUN_ID}.2", "docking", "complete", "duration reached", "docked")
    third = run(f"{OLD_RUN_ID}.3", "docking", "complete", "told to stop")
    for number, one in enumerate((first, second, third), 1):
        one |= {"run_id": OLD_RUN_ID, "piece": number, "bytes": number * 1_000_000}
    return [third, second, first]


def told_in_pieces() -> dict[str, Any]:
    """What the server makes of them."""
    names = (OLD_RUN_ID, f"{OLD_RUN_ID}.2", f"{OLD_RUN_ID}.3")
    spans = ((0.0, 20.0), (32.5, 90.0), (91.0, 300.0))
    pieces = [
        {"id": n, "first_s": a, "last_s": b, "pace_s": 0.05} for n, (a, b) in zip(names, spans, strict=True)
    ]
    gaps = [{"first_s": 20.0, "last_s": 32.5}]
    return whole(OLD_RUN_ID) | {"pieces": pieces, "gaps": gaps, "outcome": "docked"}


def test_a_flight_in_pieces_is_one_line_and_its_files_are_still_there(
    console: Page, server: ContractServer
) -> None:
    """Protects people from three half flights, and tools from losing a file; the gap is told."""
    server.reply("GET", "runs", in_pieces())
    server.reply("GET", f"runs/{OLD_RUN_ID}/flight", told_in_pieces())
    show(console, "Runs")
    rows = console.get_by_role("region", name="Runs").locator("tbody tr")
    expect(rows).to_have_count(1)
    expect(rows).to_contain_text("docked")
    expect(rows).to_contain_text("3 pieces")
    about = console.get_by_label("docking", exact=True)
    expect(about).to_contain_text("12.5 s of it were not recorded (T+00:20 to 00:32)")
    files = about.get_by_role("table", name="Files of this flight").get_by_role("row")
    expect(files).to_have_count(3)
    expect(files.nth(2)).to_contain_text("hold")
    expect(about.get_by_role("link", name=f"Download {OLD_RUN_ID}.2 as MCAP")).to_be_visible()
    about.get_by_label("File to export").select_option("2")
    expect(about.get_by_role("link", name="Export")).to_have_attribute(
        "href", re.compile(rf"{OLD_RUN_ID}\.2/export")
    )


def test_a_flight_is_thrown_away_and_taken_back_with_all_its_files(
    console: Page, server: ContractServer
) -> None:
    """Protects a flight from being left half in the bin."""
    names = [OLD_RUN_ID, f"{OLD_RUN_ID}.2", f"{OLD_RUN_ID}.3"]
    server.reply("GET", "runs", in_pieces())
    server.reply("GET", f"runs/{OLD_RUN_ID}/flight", told_in_pieces())
    for name in names:
        server.reply("DELETE", f"runs/{name}", None)
        server.reply("POST", f"bin/{name}/restore", None)
    show(console, "Runs")
    console.get_by_role("button", name=f"Delete run {OLD_RUN_ID}").hover()
    console.mouse.down()
    server.wait_for_call("DELETE", f"runs/{OLD_RUN_ID}")
    console.mouse.up()
    assert [len(server.calls_of("DELETE", f"runs/{name}")) for name in names] == [1, 1, 1]
    expect(console.get_by_text("and 2 more of its pieces are in the bin")).to_be_visible()
    console.get_by_role("button", name="Undo").click()
    for name in names:
        server.wait_for_call("POST", f"bin/{name}/restore")
    expect(console.get_by_role("button", name="Undo")).to_have_count(0)


def test_the_address_keeps_what_the_list_shows(console: Page, server: ContractServer) -> None:
    """Protects a reload and a link that is sent: search, outcome and columns are as they were."""
    show(console, "Runs")
    console.get_by_label("Search in runs").fill("no such flight")
    console.get_by_label("Outcome", exact=True).select_option("docked")
    console.wait_for_url("**/#/runs*outcome=docked*")
    shared = console.url
    console.reload()
    expect(console.get_by_label("Search in runs")).to_have_value("no such flight")
    expect(console.get_by_label("Outcome", exact=True)).to_have_value("docked")
    expect(console.get_by_text("No run is like that.")).to_be_visible()
    show(console, "Live")
    show(console, "Runs")
    console.wait_for_url(shared)
    console.get_by_role("button", name="Show all runs").click()
    console.wait_for_url(lambda url: "find" not in url and "outcome" not in url)
    console.goto(f"{server.url}#/runs?columns=duration,seed&find=&outcome=nonsense")
    expect(console.get_by_role("columnheader", name="Seed")).to_be_visible()
    expect(console.get_by_role("columnheader", name="Recorded")).to_have_count(0)
    expect(console.get_by_label("Outcome", exact=True)).to_have_value("")


def test_a_view_is_kept_for_all_and_forgotten_with_a_way_back(console: Page, server: ContractServer) -> None:
    """Protects what a crew agreed to look at: search, outcome and columns under one name, by keyboard too."""
    view = {
        "words": "sea",
        "outcome": "held",
        "columns": ["recorded", "seed"],
        "author": "Ada",
        "name": "Sea",
    }
    server.reply("PUT", "run-views/Sea", view)
    server.reply("DELETE", "run-views/Sea", None)
    show(console, "Runs")
    table = console.get_by_role("region", name="Runs")
    console.get_by_role("button", name="View: all runs").press("Enter")
    menu = console.get_by_role("group", name="Views of the list")
    expect(menu).to_contain_text("No view yet.")
    menu.get_by_label("Seed").check()
    for column in ("Duration", "Closest", "Steps"):
        menu.get_by_label(column).uncheck()
    heads = ["Mark to compare", "Outcome", "Mission", "Recorded", "Seed", "Download"]
    expect(table.get_by_role("columnheader")).to_have_text(heads)
    console.get_by_label("Search in runs").fill("sea")
    console.get_by_label("Outcome", exact=True).select_option("held")
    expect(console.get_by_role("button", name="View: not saved")).to_be_visible()
    server.reply("GET", "run-views", [view])
    menu.get_by_label("Name of the view").fill("Sea")
    menu.get_by_role("button", name="Save view").click()
    call = server.wait_for_call("PUT", "run-views/Sea")
    assert json.loads(call.body) == {key: view[key] for key in ("words", "outcome", "columns")}
    expect(console.get_by_role("button", name="View: Sea")).to_be_visible()
    menu.get_by_role("button", name="all runs").click()
    expect(console.get_by_label("Search in runs")).to_have_value("")
    menu.get_by_role("button", name="Sea", exact=True).click()
    expect(console.get_by_label("Search in runs")).to_have_value("sea")
    server.reply("GET", "run-views", [])
    menu.get_by_role("button", name="Forget the view Sea").click()
    server.wait_for_call("DELETE", "run-views/Sea")
    expect(menu).to_contain_text("View Sea is forgotten, for all.")
    server.reply("GET", "run-views", [view])
    menu.get_by_role("button", name="Undo").click()
    expect(menu.get_by_role("button", name="Forget the view Sea")).to_be_visible()
    assert len(server.calls_of("PUT", "run-views/Sea")) == 2
    console.keyboard.press("Escape")
    expect(menu).to_have_count(0)
    expect(console.get_by_role("button", name="View: Sea")).to_be_focused()


def test_a_link_to_what_is_gone_says_so(console: Page) -> None:
    """Protects from an old link that showed another run, or another mission, as if it were the one."""
    console.evaluate("location.hash = '#/runs/gone'")
    expect(console.get_by_label("Run", exact=True)).to_contain_text("There is no run gone here")
    console.evaluate("location.hash = '#/missions/gone'")
    expect(console.get_by_role("region", name="Missions")).to_contain_text("There is no mission gone here")
