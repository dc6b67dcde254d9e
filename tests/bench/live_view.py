"""What the Live view costs a browser without a graphics card: `python -m tests.bench.live_view`.

    python -m tests.bench.live_view [--seconds 30] [--minutes 30] [--faster 10]

A flight is told at 20 Hz to the Engineer arrangement with four plots; the processor time of the renderer is
taken beside the clock. Then the heap, garbage collected, before and after so many minutes of flight, told
faster than they would fly: every cycle, event and plot row is there, the clock alone is shorter.
"""

import argparse
import shutil
import time
from collections.abc import Callable

import psutil
from playwright.sync_api import Page, expect, sync_playwright

from bumpless.contract import bumpless_pb2 as pb
from tests.bench.figure import Figure, figure, short
from tests.conftest import CHROMIUM_NAMES
from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.replies import default_replies

FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
HZ = round(1 / flight.PERIOD_S)
WARM_S = 660.0  # of flight: the plots' ten minutes are full
FOUR_PLOTS = '{"group":"Own","own":["depth","speed","yaw","range"],"layouts":{}}'


def told(server: ContractServer, cycle: int) -> None:
    """One cycle as a vehicle tells it; status twice a second, an event each ten seconds."""
    now_s = cycle * flight.PERIOD_S
    said = [*flight.cycle(now_s)]
    if cycle % (HZ // 2) == 0:
        said += [*flight.mission_status(now_s), *flight.server_status(recording=True)]
    if cycle % (10 * HZ) == 0:
        said += flight.event(now_s, pb.SEVERITY_INFO, "leg", f"Leg at {now_s:.0f} s.")
    server.say(said)


def feed(server: ContractServer, first: int, count: int, faster: float = 1.0) -> int:
    """Tell `count` cycles on time; the number after them."""
    begun = time.perf_counter()
    for k in range(count):
        told(server, first + k)
        time.sleep(max(0.0, begun + (k + 1) * flight.PERIOD_S / faster - time.perf_counter()))
    return first + count


def renderer(page: Page) -> psutil.Process:
    """The process that draws this page: the busiest renderer of this browser."""
    page.evaluate("() => { const end = performance.now() + 300; while (performance.now() < end); }")
    own = [
        child
        for child in psutil.Process().children(recursive=True)
        if "--type=renderer" in " ".join(child.cmdline())
    ]
    return max(own, key=lambda one: sum(one.cpu_times()[:2]))


def spent(process: psutil.Process) -> float:
    """Processor time so far, s."""
    return sum(process.cpu_times()[:2])


def heap(page: Page) -> float:
    """What is in use after collecting garbage, MB: the least of some looks."""
    tools = page.context.new_cdp_session(page)
    used = []
    for _ in range(8):
        tools.send("HeapProfiler.collectGarbage")
        used.append(tools.send("Runtime.getHeapUsage")["usedSize"])
        page.wait_for_timeout(250)
    tools.detach()
    return min(used) / 1e6


def measured(page: Page, server: ContractServer, options: argparse.Namespace) -> list[Figure]:
    """Share of a core, and growth of the heap."""
    cycle = feed(server, 0, 10 * HZ)
    drawing = renderer(page)

    def share(seconds: float, first: int) -> tuple[float, int]:
        before, begun = spent(drawing), time.perf_counter()
        after = feed(server, first, round(seconds * HZ))
        return (spent(drawing) - before) / (time.perf_counter() - begun), after

    seen, cycle = share(options.seconds, cycle)
    page.get_by_role("navigation").get_by_role("link", name="Runs").click()
    hidden, cycle = share(options.seconds / 2, cycle)
    page.get_by_role("navigation").get_by_role("link", name="Live", exact=True).click()
    cycle = feed(server, cycle, round(WARM_S * HZ) - cycle, options.faster)
    before = heap(page)
    feed(server, cycle, round(60 * options.minutes * HZ), options.faster)
    after = heap(page)
    print(f"heap {before:.2f} MB, then {after:.2f} MB")
    return [
        figure("live_view_share", "renderer with four plots", [100 * seen], "% of a core", at_most=15),
        figure("live_view_share_hidden", "renderer with another view", [100 * hidden], "% of a core"),
        figure(
            "live_view_heap",
            f"growth of the heap in {options.minutes:g} min",
            [100 * (after / before - 1)],
            "%",
            at_most=5,
        ),
    ]


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--minutes", type=float, default=30.0)
    parser.add_argument("--faster", type=float, default=10.0)
    options = parser.parse_args()
    server = ContractServer()
    default_replies(server)
    server.say(flight.hello())
    find: Callable[[str], str | None] = shutil.which
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=next(filter(None, map(find, CHROMIUM_NAMES))), args=FLAGS
        )
        context = browser.new_context(viewport={"width": 1440, "height": 900})
        context.add_init_script(f"localStorage.setItem('bumpless.plots', '{FOUR_PLOTS}')")
        page = context.new_page()
        page.goto(server.url)
        expect(page.locator("figure.plot")).to_have_count(4, timeout=60_000)
        for one in measured(page, server, options):
            print(f"{one.title}: {short(one.value)} {one.unit} {one.goal}")
        browser.close()
    server.stop()


if __name__ == "__main__":
    main()
