"""The table that leads the page: counted flights with their interval, and no row that hides."""

from typing import Any

from bumpless_paper.report.outcomes import UNMEASURED, Flights, outcomes_html, rows_of
from bumpless_paper.report.summary import summary_html


def honest(plants: int = 20) -> dict[str, Any]:
    """Numbers of the part `honest`."""
    four = {"docked": 0.25, "collided": 0.5, "gentle_FR": 0.0, "gentle_RH": 0.75}
    rows = {"S4": four | {"median": {"e_tau_true": 0.45}}, "S2": {"median": {"e_tau_true": 0.43}}}
    return {"honest": {"numbers": {"plants": plants, "rows": rows}}}


def test_shares_are_told_as_counts_with_their_interval() -> None:
    """Protects: 5 of 20 is not "25 %" without saying how sure that is."""
    collided, docked, forward, hover, wrench = rows_of(honest())
    assert (docked.measured, docked.interval) == ("5 of 20", "11.2 % – 46.9 %")
    assert (collided.measured, collided.target) == ("10 of 20", "0 of 1,000")
    assert (forward.measured, hover.measured) == ("≤ 0.05 on 0 %", "≤ 0.05 on 75 %")
    assert wrench.measured == "0.45; S2 0.43 (medians)"


def test_a_campaign_takes_the_place_of_the_few_plants() -> None:
    """Its endings lead; what it does not count is still told from the part."""
    flown = Flights("1,000 drawn missions", 1000, {"docked": 961, "collided": 0})
    collided, docked, *others = rows_of(honest(), flown)
    assert (docked.measured, docked.of) == ("961 of 1000", "1,000 drawn missions")
    assert (collided.measured, collided.interval) == ("0 of 1000", "0.0 % – 0.4 %")
    assert all("20 drawn plants" in row.of for row in others)


def test_what_was_not_measured_says_so_and_leads_the_page_anyway() -> None:
    """Protects: a missing figure is not a row left out."""
    rows = rows_of({})
    assert len(rows) == 5 and {row.measured for row in rows} == {UNMEASURED}
    assert outcomes_html(rows).count(UNMEASURED) == 5
    assert summary_html({}).startswith("<h2>Does it dock?</h2>")
