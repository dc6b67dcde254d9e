"""The summary and its page."""

import re
from pathlib import Path

import pytest

from bumpless.campaign.flight import FlyNumbers
from bumpless.campaign.report import NUMBERS, PAGE, write_report
from bumpless.campaign.store import opened
from bumpless.campaign.summary import share_of, summary_of

# Source: Newcombe 1998, Stat. Med. 17, 857-872, table I, method 3
NEWCOMBE = {
    (81, 263): (0.2553, 0.3662),
    (15, 148): (0.0624, 0.1605),
    (0, 20): (0.0, 0.1611),
    (1, 29): (0.0061, 0.1718),
}


@pytest.mark.parametrize("case", NEWCOMBE)
def test_wilson_interval(case):
    """Protects: intervals are Wilson's, to the published digits."""
    share = share_of(*case)
    assert (share.low, share.high) == pytest.approx(NEWCOMBE[case], abs=5e-5)


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """A folder with a report of 24 flights, their table and summary."""
    from bumpless.campaign.read import parse_campaign
    from tests.campaign.conftest import DRAW, HEAD

    prepared = parse_campaign(HEAD.format(count=24) + DRAW)
    folder = tmp_path_factory.mktemp("flown")
    with opened(folder, prepared, False) as kept:
        kept.add(FlyNumbers(prepared)(range(24)))
        summary = write_report(prepared, kept, "my campaign.yaml")
        return folder, kept.table(), summary


def test_summary_counts_every_flight_once(flown):
    """Protects: outcomes and reasons add up to all flights."""
    _, table, summary = flown
    assert sum(share.count for share in summary.outcomes.values()) == table.num_rows == 24
    assert sum(summary.reasons.values()) == 24
    assert summary == summary_of(table)


def test_the_worst_come_first(flown):
    """Protects: what an engineer replays first: collisions before flights that ran out of time."""
    _, _, summary = flown
    order = [row["outcome"] for row in summary.worst]
    assert order == sorted(order, key=["collided", "aborted", "time_over", "waved_off", "held"].index)
    assert "docked" not in order


def test_the_page_says_what_counts(flown):
    """Protects: share with interval, both pictures, the command to fly a worst flight again, the hashes."""
    folder, _, summary = flown
    page = (folder / PAGE).read_text()
    docked = summary.docked
    assert f"{docked.count} of" in page
    assert f"{100 * docked.low:.1f} to {100 * docked.high:.1f} %" in page
    assert page.count("<svg") == 2
    first = summary.worst[0]["number"]
    assert f"bumpless run &#39;my campaign.yaml&#39; --draw {first} --out flight-{first}.mcap" in page
    assert re.findall(r"[0-9a-f]{64}", page)


def test_the_page_needs_no_network_and_no_script(flown):
    """Protects: the page opens on a ship: nothing is loaded, nothing runs."""
    page = (flown[0] / PAGE).read_text()
    assert "<script" not in page
    assert not re.findall(r"(?:src|href)=\"(?!#|data:)", page)
    assert "@import" not in page


def test_the_same_flights_give_the_same_page(flown, tmp_path: Path):
    """Protects: pages can be compared by their bytes."""
    from bumpless.campaign.page import page_of
    from bumpless.campaign.read import parse_campaign
    from tests.campaign.conftest import DRAW, HEAD

    folder, table, summary = flown
    prepared = parse_campaign(HEAD.format(count=24) + DRAW)
    assert page_of(prepared, table, summary, "my campaign.yaml") == (folder / PAGE).read_text()
    assert "NaN" not in (folder / NUMBERS).read_text()


def test_a_campaign_without_a_current_has_no_map(campaign, tmp_path):
    """Protects: no empty picture, and an incomplete campaign says so."""
    prepared = campaign(5, draw="draw:\n  lag: {uniform: [1, 2]}\n")
    with opened(tmp_path, prepared, False) as kept:
        kept.add(FlyNumbers(prepared)([0, 1]))
        write_report(prepared, kept, "c.yaml")
    page = (tmp_path / PAGE).read_text()
    assert "Success over the current" not in page
    assert "Not complete: 5 flights are declared" in page
