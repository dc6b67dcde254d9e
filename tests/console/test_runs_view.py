"""Runs: the list, the file while and after it is written, the metrics, a deletion that is meant."""

from playwright.sync_api import Page, expect

from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import OLD_RUN_ID, RUN_ID, run


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
    expect(row).to_contain_text("2.3 MB")
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
