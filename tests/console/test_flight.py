"""The console on the real server and the real vehicle node: a mission flown from the browser, end to end."""

from pathlib import Path

from playwright.sync_api import FilePayload, Page, expect

from tests.console.conftest import show
from tests.server.serving import Running

ROOT = Path(__file__).parents[2]
COMPILES_MS = 600_000  # patience with a machine that has never compiled the control cycle
MAGIC = b"\x89MCAP0\r\n"


def test_a_mission_is_uploaded_flown_tuned_aborted_and_kept(page: Page, running: Running) -> None:
    """Protects the agreement of console, server and vehicle on every route of the operator's day."""
    page.goto(f"{running.url}/")
    expect(page.get_by_label("Link: Live")).to_be_visible(timeout=COMPILES_MS)
    text = (ROOT / "missions" / "docking.yaml").read_text()

    show(page, "Missions")
    bad = text.replace("duration_s: 90", "duration_s: soon")
    page.set_input_files("input[type=file]", files=[_file("bad.yaml", bad)])
    expect(page.get_by_role("table", name="Problems")).to_contain_text("duration_s")
    good = text.replace("title: Docking flight", "title: From the browser")
    page.set_input_files("input[type=file]", files=[_file("browser.yaml", good)])
    expect(page.get_by_role("img", name="Plan from above: 3 waypoints, north up")).to_be_visible()
    page.get_by_role("button", name="Start this mission").click()
    expect(page.get_by_label("Mission phase")).to_have_text("Running")

    show(page, "Live")
    expect(page.get_by_label("Mode Forward")).to_have_text("F")
    show(page, "Mode weights")
    page.get_by_label("Hover: N_sw", exact=True).fill("75")
    page.get_by_role("button", name="Apply to vehicle").click()
    expect(page.get_by_label("Draft", exact=True)).to_contain_text("Confirmed by the vehicle")
    page.get_by_label("Forward: λ", exact=True).fill("-1")
    page.get_by_role("button", name="Apply to vehicle").click()
    expect(page.get_by_role("alert").filter(has_text="Refused; nothing was changed.")).to_be_visible()

    page.get_by_role("button", name="Abort mission").hover()
    page.mouse.down()
    expect(page.get_by_label("Mission phase")).to_have_text("Aborted")
    page.mouse.up()

    show(page, "Runs")
    row = page.get_by_label("Runs", exact=True).get_by_role("row").nth(1)
    expect(row).to_contain_text("aborted")
    expect(page.get_by_label("Metrics", exact=True)).to_contain_text("RMS e_τ")
    with page.expect_download() as download:
        page.get_by_role("link", name="Download MCAP").click()
    data = download.value.path().read_bytes()
    assert data.startswith(MAGIC) and data.endswith(MAGIC)


def _file(name: str, text: str) -> FilePayload:
    return {"name": name, "mimeType": "text/yaml", "buffer": text.encode()}
