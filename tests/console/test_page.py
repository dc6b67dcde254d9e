"""The page itself: first paint, themes, names for a screen reader, contrast, what it loads."""

import re
from collections.abc import Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Page, expect

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.modes import MODES
from bumpless_server.web import views
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import RUN_ID

VIEWS = tuple(view.name for view in views.VIEWS)
AA = 4.5
TEXT = ("--ink", "--ink-2", "--accent", "--good", "--warning", "--alarm")
ON = {
    "--panel": TEXT,
    "--page": ("--ink", "--ink-2", "--alarm"),
    "--raised": ("--ink", "--ink-2"),
    "--well": ("--ink", "--ink-2"),
    "--accent-soft": ("--ink", "--accent"),
    "--good-soft": ("--good",),
    "--warning-soft": ("--ink", "--warning"),
    "--alarm-soft": ("--ink", "--alarm"),
    "--accent": ("--on-accent",),
    "--warning": ("--on-warning",),
    "--danger": ("--on-danger",),
    "--banner-alarm": ("--on-banner",),
    "--banner-warning": ("--on-banner",),
    **{f"--mode-{look.key}": ("--on-mode",) for look in MODES},
}


@pytest.fixture
def bare() -> Iterator[ContractServer]:
    """A server without vehicle, missions or runs."""
    server = ContractServer()
    for path in ("missions", "runs", "presets"):
        server.reply("GET", path, [])
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_WAITING))
    yield server
    server.stop()


def test_without_a_vehicle_each_view_says_what_to_do(page: Page, bare: ContractServer) -> None:
    """Protects a newcomer's first sight of the console."""
    page.goto(bare.url)
    expect(page.get_by_label("Link: No vehicle yet")).to_be_visible()
    expect(page.get_by_text("Actuators appear with the first telemetry.")).to_be_visible()
    show(page, "Missions")
    expect(page.get_by_text("No missions yet. Drop a mission file above, or choose one.")).to_be_visible()
    show(page, "Mode weights")
    expect(page.get_by_text("The vehicle has not said what it flies with.")).to_be_visible()
    show(page, "Runs")
    expect(page.get_by_text("No runs yet. Start a mission")).to_be_visible()


def test_the_theme_follows_the_system_until_chosen_and_is_kept(
    browser: Browser, server: ContractServer
) -> None:
    """Protects the operator's choice over a reload, and a page that is open when the evening comes."""
    page = browser.new_page(color_scheme="dark")
    page.goto(server.url)
    root = page.locator("html")
    expect(root).to_have_attribute("data-theme", "dark")
    page.emulate_media(color_scheme="light")
    expect(root).to_have_attribute("data-theme", "light")
    page.get_by_role("button", name="Switch to the dark theme").click()
    page.reload()
    expect(root).to_have_attribute("data-theme", "dark")
    page.close()


def test_every_control_has_a_name_and_can_be_reached(console: Page) -> None:
    """Protects keyboard and screen reader in all views."""
    for view in VIEWS:
        show(console, view)
        expect(console.get_by_role("main")).to_be_visible()
        nameless = console.evaluate(
            "[...document.querySelectorAll('button, input, select, a')].filter(e => !(e.ariaLabel"
            " || e.textContent.trim() || e.labels?.length)).map(e => e.outerHTML)"
        )
        assert nameless == []
        expect(console.get_by_role("heading", level=1)).to_have_count(1)
        expect(console.get_by_role("heading", level=1)).to_have_text(re.compile(view))


def test_the_keyboard_begins_with_a_way_past_the_top_line(page: Page, server: ContractServer) -> None:
    """Protects who works without a pointer from walking the navigation on every view."""
    page.goto(server.url)
    expect(page.get_by_label("Link: Live")).to_be_visible()
    page.keyboard.press("Tab")
    expect(page.get_by_role("button", name="Skip to the view")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_role("main")).to_be_focused()


def test_the_manual_is_one_step_away(console: Page) -> None:
    """Protects the way from the screen to the docs that the server carries."""
    manual = console.get_by_role("navigation").get_by_role("link", name="Help")
    assert manual.get_attribute("href") == views.HELP


def test_a_view_that_cannot_be_loaded_says_so_and_is_tried_again(page: Page, server: ContractServer) -> None:
    """Protects an operator who opens a view for the first time while the server is away."""
    page.goto(server.url)
    expect(page.get_by_label("Link: Live")).to_be_visible()
    page.route("**/assets/runs_view*.js", lambda route: route.abort())
    show(page, "Runs")
    expect(page.get_by_text("This view could not be loaded")).to_be_visible()
    page.unroute_all()
    page.get_by_role("button", name="Try again").click()
    expect(page.get_by_label("Runs", exact=True).get_by_role("row").first).to_be_visible()


def test_the_first_load_is_small(page: Page, server: ContractServer) -> None:
    """Protects a thin link: all before the scene, as the server sends it, is at most 150 kB gzipped."""
    asked: list[str] = []
    page.on("request", lambda request: asked.append(urlsplit(request.url).path))
    page.goto(server.url)
    expect(page.get_by_label("Link: Live")).to_be_visible()
    expect(page.locator("figure.plot").first).to_be_visible()
    folder = server.console
    files = {folder / path.strip("/") for path in asked if (folder / path.strip("/")).is_file()}
    sizes = [min(p.stat().st_size for p in (f, f.with_name(f.name + ".gz")) if p.is_file()) for f in files]
    assert len(sizes) > 3 and sum(sizes) <= 150_000


def test_the_page_loads_from_its_own_origin_alone(page: Page, server: ContractServer) -> None:
    """Protects use at sea, without the internet."""
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(server.url)
    expect(page.get_by_label("Link: Live")).to_be_visible()
    assert {urlsplit(url).port for url in asked} == {server.port}


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_text_meets_the_contrast_of_wcag_aa(console: Page, theme: str) -> None:
    """Protects legibility of every pair of text and ground that the style sheets use."""
    console.evaluate("theme => { document.documentElement.dataset.theme = theme }", theme)
    names = sorted({*ON, *(name for texts in ON.values() for name in texts)})
    colours = console.evaluate(
        "names => { const s = getComputedStyle(document.documentElement);"
        " return Object.fromEntries(names.map(n => [n, s.getPropertyValue(n).trim()])) }",
        names,
    )
    for ground, texts in ON.items():
        for text in texts:
            ratio = contrast(colours[text], colours[ground])
            assert ratio >= AA, f"{theme}: {text} on {ground} is {ratio:.2f}"


def contrast(one: str, other: str) -> float:
    """Contrast ratio of two colours "#rrggbb". Source: WCAG 2.2, relative luminance."""

    def luminance(colour: str) -> float:
        assert re.fullmatch(r"#[0-9a-f]{6}|#fff", colour), colour
        digits = colour[1:] if len(colour) == 7 else "ffffff"
        parts = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def test_the_run_that_is_over_says_how_it_ended(console: Page, server: ContractServer) -> None:
    """Protects: "completed" alone says nothing; the judgement of this very run takes its place."""
    server.keep_saying(flight.hello(pb.MISSION_PHASE_COMPLETED))
    phase = console.get_by_label("Mission phase")
    expect(phase).to_have_text("Over")
    text = "Held: in hover, truly 0.21 m from the observation point."
    server.say(
        flight.event(90.0, pb.SEVERITY_INFO, "outcome", "Docked: long ago.", ending="docked", run="another")
    )
    server.say(flight.event(90.5, pb.SEVERITY_INFO, "outcome", text, ending="held", run=RUN_ID))
    expect(phase).to_contain_text("Held")
    said = console.get_by_label("Mission control")
    expect(said).to_contain_text("In hover, truly 0.21 m from the observation point.")
    expect(said).not_to_contain_text("Held:")  # the chip beside it says the word
    expect(phase).to_have_attribute("title", "In hover, truly 0.21 m from the observation point.")
