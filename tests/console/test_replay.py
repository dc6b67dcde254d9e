"""A recorded run seen again in the Live view, on the real server: it seeks, plays, and never looks live."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.settings import Settings
from tests.pieces import in_pieces
from tests.ports import free_port
from tests.server.serving import Running, serving

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"
RUN = "20260101T000000Z-docking-ab12"
CUT, AGAIN, HELD = 20.0, 34.0, 30.0  # what a crash took, and the hold after the mission, s


@pytest.fixture(scope="module")
def flown() -> bumpless.Run:
    """A flight as a simulation."""
    return bumpless.fly(MISSION)


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory, flown: bumpless.Run) -> Iterator[Running]:
    """A server without a vehicle that has recorded this flight, and once more in pieces."""
    data = tmp_path_factory.mktemp("data")
    (data / "runs").mkdir()
    flown.save(data / "runs" / f"{RUN}.mcap")
    in_pieces(flown, data / "runs", CUT, AGAIN, HELD)
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=data, zenoh_listen=bus, scene="off", manage_node=False)) as server:
        assert server.console.keeper.indexed.wait(60)
        yield server


@pytest.fixture
def replayed(page: Page, running: Running) -> Page:
    """The page at 31.2 s of the run."""
    page.goto(f"{running.url}/#/runs/{RUN}?t=31.2")
    expect(page.get_by_role("region", name="Replay")).to_be_visible()
    expect(page.get_by_test_id("plot-depth")).to_contain_text(".")
    return page


def at(flown: bumpless.Run, time_s: float) -> dict:
    """What was told in the cycle of that time."""
    table = flown.table()
    row = int(abs(table["time_s"] - time_s).argmin())
    return {name: column[row] for name, column in table.items()}


def test_an_address_leads_to_its_moment(replayed: Page, flown: bumpless.Run) -> None:
    """Protects links that people send each other: mode, depth and time are those of that moment."""
    told = at(flown, 31.2)
    state = replayed.get_by_label("State", exact=True)
    expect(state).to_contain_text(f"Depth{told['navigation.depth_m']:.2f}")
    expect(replayed.locator(".mode-badge")).to_have_text(str(told["supervisor.mode"])[0])
    expect(replayed.get_by_role("region", name="Replay")).to_contain_text("T+00:31.2")
    assert replayed.title() == f"Replay of {RUN} · Bumpless"


def test_a_replay_never_looks_live(replayed: Page) -> None:
    """Protects from commanding by a recording: the bar says what it is, the link chip what is live."""
    expect(replayed.get_by_role("region", name="Replay")).to_contain_text("recorded; nothing here is live")
    expect(replayed.get_by_label("Link: No vehicle yet")).to_be_visible()
    expect(replayed.get_by_role("heading", level=1)).to_have_text("Replay")
    expect(replayed.get_by_label("3-D scene", exact=True)).to_be_hidden()
    expect(replayed.get_by_label("Track", exact=True)).to_be_visible()
    replayed.get_by_role("link", name="Back to live").click()
    expect(replayed.get_by_role("region", name="Replay")).to_have_count(0)
    expect(replayed.get_by_text("Actuators appear with the first telemetry.")).to_be_visible()


def test_keyboard_steps_and_seeks(replayed: Page, flown: bumpless.Run) -> None:
    """Protects replay by keyboard alone: seconds, tens, cycles, ends, and the address that follows."""
    bar = replayed.get_by_role("region", name="Replay")
    for key, shown in (
        ("ArrowRight", "T+00:32.2"),
        ("Shift+ArrowRight", "T+00:42.2"),
        ("ArrowLeft", "T+00:41.2"),
        (".", "T+00:41.2"),
        ("Home", "T+00:00.0"),
    ):
        replayed.keyboard.press(key)
        expect(bar).to_contain_text(shown)
    expect(replayed).to_have_url(re.compile(r"t=0\.00$"))
    replayed.keyboard.press("End")
    last = float(flown.table()["time_s"][-1])
    expect(bar.get_by_label("Mission time")).to_have_value(f"{last:g}")
    expect(replayed.get_by_role("log")).to_contain_text("Mission")


def test_it_plays_at_the_chosen_speed_and_stops_at_the_end(replayed: Page) -> None:
    """Protects the player: it goes on by itself, faster when asked, and halts."""
    bar = replayed.get_by_role("region", name="Replay")
    bar.get_by_label("Speed").select_option("16")
    replayed.keyboard.press(" ")
    expect(bar.get_by_role("button", name="Pause the replay")).to_be_visible()
    expect(replayed.locator(".mode-badge")).to_have_text("H")
    expect(bar.get_by_role("button", name="Play")).to_be_visible()


def test_events_are_those_up_to_the_moment(replayed: Page, flown: bumpless.Run) -> None:
    """Protects from knowing what has not happened yet."""

    switches = [
        event for _, event in flown.messages() if isinstance(event, pb.Event) and event.code == "mode_switch"
    ]
    rows = (
        replayed.get_by_role("log")
        .get_by_role("listitem")
        .filter(has_text=re.compile(" to (reverse|hover|forward)"))
    )
    passed = [event for event in switches if event.stamp.mission_time_s <= 31.2]
    expect(rows).to_have_count(len(passed))
    replayed.keyboard.press("End")
    expect(rows).to_have_count(len(switches))
    assert len(passed) < len(switches)


def test_a_run_that_is_not_there_says_so(page: Page, running: Running) -> None:
    """Protects from an empty picture."""
    page.goto(f"{running.url}/#/runs/nothing?t=1")
    expect(page.get_by_role("region", name="Replay")).to_contain_text("there is no run 'nothing'")


def test_a_flight_in_pieces_is_replayed_over_its_gap(
    page: Page, running: Running, flown: bumpless.Run
) -> None:
    """Protects from a picture that somebody made up: in a gap the last word stands, old, and it says so."""
    page.goto(f"{running.url}/#/runs/{flown.info.run_id}?t=26")
    bar = page.get_by_role("region", name="Replay")
    expect(bar).to_contain_text(re.compile("Not recorded from T.00:(19|20) to 00:34"))
    expect(page.get_by_test_id("age-tlm/navigation").first).to_contain_text(re.compile(r"stale 6\."))
    expect(page.locator(".mode-badge")).to_have_text(str(at(flown, CUT - 0.1)["supervisor.mode"])[0])
    bar.get_by_role("button", name="Skip").click()
    expect(bar).to_contain_text("T+00:34")
    expect(bar).not_to_contain_text("Not recorded")
    expect(page.get_by_test_id("age-tlm/navigation")).to_have_count(0)
    page.keyboard.press("End")
    expect(bar).to_contain_text("/ 01:59")
    bar.get_by_role("link", name="Run", exact=True).click()
    expect(page.get_by_text(re.compile(r"14\.\d s of it were not recorded"))).to_be_visible()
