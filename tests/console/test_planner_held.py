"""Which headings hold station, in words beside the ring that is drawn round the dock."""

from playwright.sync_api import Page, expect

from bumpless.config.mission import parse_mission
from bumpless.feasibility import ACCEPT, station_of
from bumpless.feasibility.holding import spans
from bumpless_server.foresight import held
from tests.console import planner
from tests.console.contract_server import ContractServer
from tests.console.test_planner import TEXT, keep, planned

__all__ = ["planned"]  # the fixture


def test_which_headings_hold_station_is_said_in_words_beside_the_ring(
    planned: Page, server: ContractServer
) -> None:
    """Protects: no sway means few headings; which, and why not the plan's own, is read without a colour."""
    text = TEXT + "environment: {current_ned_mps: [0, 0.1, 0]}\n"
    against = parse_mission(text, "harbour.yaml")
    station = station_of(against)
    assert station is not None
    told = held.told(station, against.environment.current_ned_mps).model_dump()
    server.foresee = lambda _: planner.forecast(3, station=told)
    keep(server, text)
    planned.goto(f"{server.url}#/plan")
    planned.goto(f"{server.url}#/plan/harbour")
    planned.reload()
    legend = planned.get_by_label("Headings that hold station")
    good = spans(station.heading_deg, station.zone == ACCEPT)
    expect(legend.locator("summary")).to_have_text(f"Holds station {good}")
    expect(legend).to_contain_text("Planned: 0.10 m/s from 270°")
    expect(legend).to_contain_text(f"holds{good}")
    expect(legend).to_contain_text("can't holdthe others")
    expect(legend).to_contain_text("Its own heading can't hold: it has no sideways thrust")
    planned.set_viewport_size({"width": 1024, "height": 768})
    planned.reload()
    expect(legend.locator("summary")).to_have_text(f"Holds station {good}")
    expect(legend.get_by_text("can't hold").first).to_be_hidden()
