"""`make pictures`: each screen of the console as the docs show it, of a real flight by a real node.

    python -m tests.console.pictures [FOLDER]

Serves a console of its own on free ports, flies the docking mission in a browser and writes PNG files, 1440
by 900, dark, and the live view in light as well. Takes as long as the flight, and needs a Chromium.
"""

import io
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, Page, expect, sync_playwright

import bumpless
from bumpless_server.settings import Settings
from tests.conftest import CHROMIUM_FLAGS, CHROMIUM_NAMES
from tests.ports import free_port
from tests.server.serving import Running, serving

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "pictures"
SIZE = (1440, 900)
COMPILES_MS = 600_000
FLIES_MS = 180_000
DAY_NS = 86_400_000_000_000
SETTLES_MS = 1500  # drawings that come after the words: a picture may wait
TRIES = 4  # of a picture in which something was late
YESTERDAY = "docking_current"  # flown before, to be compared with


def save(page: Page, path: Path) -> None:
    """What the page shows now, as a PNG: true colours, packed as well as it goes."""
    picture = Image.open(io.BytesIO(shot(page)))
    picture.convert("RGB").save(path, optimize=True)
    print(f"{path.name}: {path.stat().st_size // 1000} kB", flush=True)


def shot(page: Page) -> bytes:
    """A picture in which nothing is late: a busy machine keeps values back while it is taken."""
    for _ in range(TRIES):
        taken = page.screenshot(animations="disabled", timeout=FLIES_MS)
        if page.get_by_label("Link: Telemetry late").count() + page.locator(".age-chip").count() == 0:
            return taken
        page.wait_for_timeout(SETTLES_MS)
    return taken


def open_page(browser: Browser, url: str, theme: str) -> Page:
    """The console in a fresh window."""
    window = browser.new_context(viewport={"width": SIZE[0], "height": SIZE[1]})
    window.add_init_script(f"localStorage.setItem('bumpless.theme', '{theme}')")
    page = window.new_page()
    page.set_default_timeout(FLIES_MS)
    page.goto(url, wait_until="domcontentloaded")
    return page


def show(page: Page, view: str) -> None:
    """Go to a view by its tab."""
    page.get_by_role("navigation").get_by_role("link", name=view).click()


def take(browser: Browser, running: Running, folder: Path) -> None:
    """Fly, and take the pictures on the way."""
    page = open_page(browser, f"{running.url}/#missions", "dark")
    expect(page.get_by_label("Link: Live")).to_be_visible(timeout=COMPILES_MS)
    page.goto(f"{running.url}/#/plan/docking_current")
    expect(page.get_by_label("State of the forecast")).to_have_text("up to date", timeout=COMPILES_MS)
    save(page, folder / "plan.png")
    show(page, "Missions")
    page.get_by_role("button", name="Docking flight").click()
    start = page.get_by_role("button", name="Start this mission")
    expect(start).to_be_enabled(timeout=FLIES_MS)
    save(page, folder / "missions.png")
    start.click()
    show(page, "Mode weights")
    page.get_by_label("Hover: N_sw", exact=True).fill("75")
    save(page, folder / "weights.png")
    show(page, "Live")
    light = open_page(browser, running.url, "light")
    expect(page.get_by_label("Mode Reverse")).to_have_text("R", timeout=FLIES_MS)
    save(page, folder / "live.png")
    save(light, folder / "live_light.png")
    expect(page.get_by_label("Mission phase")).to_have_text("Docked", timeout=FLIES_MS)
    show(page, "Runs")
    expect(page.get_by_label("Metrics", exact=True)).to_contain_text("RMS e_τ", timeout=FLIES_MS)
    save(page, folder / "runs.png")
    page.get_by_role("link", name="Replay", exact=True).click()
    replay = page.get_by_role("region", name="Replay")
    expect(replay).to_contain_text("/ 01:")  # the run is read
    replay.get_by_label("Mission time").fill("40")
    expect(replay).to_contain_text("T+00:40.0")
    page.wait_for_timeout(SETTLES_MS)
    save(page, folder / "replay.png")
    show(page, "Runs")
    for mark in page.get_by_role("checkbox", name="to compare").all():
        mark.check()
    page.get_by_role("button", name="Compare").click()
    expect(page.get_by_role("table", name="Figures")).to_contain_text("Residual RMS")
    page.get_by_label("Seconds from the moment the runs are aligned on").fill("45")
    expect(page.get_by_text("45.0 s")).to_be_visible()
    page.wait_for_timeout(SETTLES_MS)
    save(page, folder / "compare.png")
    show(page, "System")
    expect(page.get_by_role("main")).to_contain_text("Session that speaks")
    save(page, folder / "system.png")
    page.goto(f"{running.url}/help/")
    save(page, folder / "help.png")


def main(arguments: list[str]) -> int:
    """Write all pictures into FOLDER."""
    folder = Path(arguments[0]) if arguments else FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    names = (os.environ.get("BUMPLESS_CHROMIUM", ""), *CHROMIUM_NAMES)
    chromium = next((path for name in names if name and (path := shutil.which(name))), None)
    if chromium is None:
        print("no Chromium found: name one in BUMPLESS_CHROMIUM", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as data, sync_playwright() as playwright:
        (Path(data) / "runs").mkdir()
        yesterday = bumpless.fly(YESTERDAY, started_ns=time.time_ns() - DAY_NS)
        yesterday.save(Path(data) / "runs" / f"{yesterday.info.id}.mcap")
        bus = (f"tcp/127.0.0.1:{free_port()}",)
        with serving(Settings(data_dir=Path(data), zenoh_listen=bus, scene="light")) as running:
            browser = playwright.chromium.launch(executable_path=chromium, args=CHROMIUM_FLAGS)
            take(browser, running, folder)
            browser.close()
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
