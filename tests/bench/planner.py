"""How fast the planner is in the browser, without a graphics card: `python -m tests.bench.planner`.

    python -m tests.bench.planner [--legs 500] [--frames 120] [--edits 30]

A plan of many legs is dragged in the plan from above, in the depth profile and in space, one pointer event a
frame, all panels open; and the browser's own share of the time from an edit to its track is measured with a
server that answers at once, its answer the one of a real flight.
"""

import argparse
import math
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import pairwise

import psutil
from playwright.sync_api import Browser, Page, expect, sync_playwright

from bumpless.config.mission import missions_folder
from tests.bench.figure import Figure, figure, short
from tests.conftest import CHROMIUM_NAMES
from tests.console import flight, planner
from tests.console.contract_server import ContractServer
from tests.console.replies import default_replies
from tests.console.test_planner_drawing import seen

DOCKING = (
    (missions_folder() / "docking.yaml").read_text(encoding="utf-8").replace("name: docking", "name: survey")
)
DOCKING_AT = (10.0, 0.0)  # a waypoint of it
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
# Drag from a place, one event a frame, to and fro; the times of the frames, ms.
DRAG = """([name, x, y, frames]) => new Promise((done) => {
  const canvas = document.querySelector(`[role=application][aria-label="${name}"] canvas`);
  const send = (kind, dx, dy) => canvas.dispatchEvent(new PointerEvent(kind, {
    bubbles: true, pointerId: 1, pointerType: 'mouse', clientX: x + dx, clientY: y + dy,
    button: 0, buttons: kind === 'pointerup' ? 0 : 1 }));
  canvas.setPointerCapture = () => undefined;
  send('pointerdown', 0, 0);
  const times = [];
  const step = (now) => {
    times.push(now);
    if (times.length > frames) { send('pointerup', 0, 0); done(times); return; }
    send('pointermove', 6 + 5 * Math.sin(times.length / 6), 6 + 30 * Math.sin(times.length / 9));
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})"""

# Note when the track of the newest question has come and is drawn.
WATCH = """() => {
  const Own = window.WebSocket;
  window.WebSocket = class extends Own {
    constructor(url) {
      super(url);
      if (String(url).includes('/ws/foresight')) this.addEventListener('message', (event) => {
        if (!/"kind": ?"nominal"/.test(event.data) || JSON.parse(event.data).id !== window.asked) return;
        requestAnimationFrame(() => setTimeout(() => window.drawn?.(performance.now())));
      });
    }
    send(data) {
      if (this.url.includes('/ws/foresight')) window.asked = JSON.parse(data).id;
      super.send(data);
    }
  };
}"""
# From each edit by a key to the frame in which its track is drawn, ms.
EDIT = """(edits) => new Promise(async (done) => {
  const plan = document.querySelector('[role=application][aria-label="Plan from above"]');
  plan.focus();
  const found = [];
  for (let k = 0; k < edits; k++) {
    const begun = performance.now();
    const drawn = new Promise((resolve) => { window.drawn = resolve; });
    const key = k % 2 ? 'ArrowLeft' : 'ArrowRight';
    plan.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
    found.push(await drawn - begun);
    await new Promise((resolve) => setTimeout(resolve, 150));
  }
  done(found);
})"""


def zigzag(legs: int) -> str:
    """A mission of so many legs, in rows as a survey has them."""
    rows = max(1, round(math.sqrt(legs)))
    places = [
        (6.0 * (k % rows if k // rows % 2 == 0 else rows - 1 - k % rows), 6.0 * (k // rows))
        for k in range(legs)
    ]
    text = "version: 1\nname: survey\nvehicle: ts100\nduration_s: 9000\nstart:\n"
    text += "  position_ned_m: [-8, 0, 2.0]\n  heading_deg: 0\nlegs:\n"
    for k, (north, east) in enumerate(places):
        text += f"  - {{to_ned_m: [{north:g}, {east:g}, {2 + 0.5 * math.sin(k / 9):.2f}], speed_mps: 0.7}}\n"
    north, east = places[-1]
    text += f"target:\n  position_ned_m: [{north + 12:g}, {east:g}, 2]\n  heading_deg: 0\n  standoff_m: 1.5\n"
    return text


@contextmanager
def opened(browser: Browser, server: ContractServer, text: str, space: bool = False) -> Iterator[Page]:
    """The planner with a mission, its forecast there."""
    server.reply("GET", "missions", [planner.stored("survey", text)])
    server.reply("GET", "missions/survey", planner.stored("survey", text))
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    context.add_init_script(f"({WATCH})()")
    if space:
        context.add_init_script("localStorage.setItem('bumpless.plan.space', 'yes')")
    page = context.new_page()
    page.goto(f"{server.url}#/plan/survey")
    expect(page.get_by_label("State of the forecast")).to_have_text("up to date", timeout=60_000)
    try:
        yield page
    finally:
        context.close()


def waypoint(text: str, leg: int) -> tuple[float, float, float]:
    """Where a leg ends, NED, m."""
    north, east, down = re.findall(r"to_ned_m: \[(.*?)\]", text)[leg].split(",")
    return float(north), float(east), float(down)


def in_profile(page: Page, text: str, leg: int) -> tuple[float, float]:
    """Where a leg's end is drawn in the profile, px."""
    canvas = page.get_by_role("application", name="Depth profile").locator("canvas")
    x, y, sx, sy = map(float, (canvas.get_attribute("data-frame") or "").split())
    box = canvas.bounding_box()
    assert box is not None
    way, (n, e) = 0.0, (-8.0, 0.0)
    for k in range(leg + 1):
        north, east, _ = waypoint(text, k)
        way, n, e = way + math.hypot(north - n, east - e), north, east
    down = waypoint(text, leg)[2]
    return box["x"] + box["width"] / 2 + (way - x) * sx, box["y"] + box["height"] / 2 - (-down - y) * sy


def burnt() -> float:
    """Seconds of processor time that the browser has used, all its processes together."""
    times = 0.0
    for process in psutil.Process().children(recursive=True):
        with suppress(psutil.NoSuchProcess):
            used = process.cpu_times()
            times += used.user + used.system
    return times


def rate(page: Page, name: str, at: tuple[float, float], frames: int) -> tuple[list[float], float]:
    """Frames per second of a drag, by parts of 20, and ms of processor time that a frame takes."""
    before = burnt()
    times: list[float] = page.evaluate(DRAG, [name, *at, frames])
    cost = 1000.0 * (burnt() - before) / frames
    steps = [b - a for a, b in pairwise(times)]
    parts = [steps[k : k + 20] for k in range(0, len(steps) - 19, 20)]
    return [1000.0 * len(part) / sum(part) for part in parts], cost


def figures(legs: int, frames: int, edits: int) -> list[Figure]:
    """Rows of the table."""
    server = ContractServer()
    default_replies(server)
    planner.default_replies(server)
    server.keep_saying(flight.hello())
    answers = planner.forecast(198)
    # While something is dragged a real server tells of a flight now and then, never of a whole fan.
    server.foresee = lambda asked: answers if asked["text"] in (text, DOCKING) else answers[:2]
    text, rows = zigzag(legs), list[Figure]()
    leg = legs // 2
    north, east, down = waypoint(text, leg)

    def drag(page: Page, view: str, name: str, at: tuple[float, float], tab: str) -> None:
        """One row: frames per second of a drag."""
        rates, cost = rate(page, name, at, frames)
        title = f"drag in a plan of {legs} legs: {view}, {tab} open, {cost:.0f} ms of CPU a frame"
        rows.append(figure(f"planner_{view}_{tab.lower()}_fps", title, rates, "frames/s", at_least=30))
        print(told(rows[-1]), flush=True)

    executable = next(path for path in map(shutil.which, CHROMIUM_NAMES) if path)
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=executable, args=FLAGS)
        for tab in ("Details", "Legs", "YAML"):
            with opened(browser, server, text) as page:
                page.get_by_role("button", name=tab, exact=True).click()
                drag(page, "plan", "Plan from above", planner.at(page, north, east), tab)
                drag(page, "profile", "Depth profile", in_profile(page, text, leg), tab)
        with opened(browser, server, text, space=True) as page:
            drag(page, "space", "Plan in space", seen(page, north, east, down), "Details")
        with opened(browser, server, DOCKING) as page:
            planner.click(page, *DOCKING_AT)
            own = page.evaluate(EDIT, edits)
        browser.close()
    server.stop()
    rows.append(figure("planner_own_ms", "edit to track drawn, the browser's own share", own, "ms"))
    print(told(rows[-1]))
    return rows


def told(one: Figure) -> str:
    """A row as a line."""
    return f"{one.title}: {short(one.value)} {one.unit} ({short(one.low)} … {short(one.high)}), {one.goal}"


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--legs", type=int, default=500)
    parser.add_argument("--frames", type=int, default=120)
    parser.add_argument("--edits", type=int, default=30)
    options = parser.parse_args()
    figures(options.legs, options.frames, options.edits)


if __name__ == "__main__":
    main()
