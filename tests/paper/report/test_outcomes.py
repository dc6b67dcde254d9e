"""The table that leads the page: counted flights with their interval, and no row that hides."""

from typing import Any

from bumpless_paper.report.outcomes import UNMEASURED, outcomes_html, rows_of
from bumpless_paper.report.results import fair_text, outcomes_text
from bumpless_paper.report.summary import summary_html
from bumpless_paper.study import outcomes
from bumpless_paper.study.docks.response import Stay, Step
from bumpless_paper.study.outcomes import Flown

Q = {"median": 0.1, "q90": 0.2, "worst": 0.3}


def parts() -> dict[str, Any]:
    """Numbers of the parts that the table reads."""
    flights = [Flown("docked", "held within the limits", 0.04, 0.06, 0.02)] * 19
    flights.append(Flown("collided", "in the dock in reverse", float("nan"), float("nan"), 0.5))
    groups = {
        name: outcomes.counted(flights) | {"about": group.about} for name, group in outcomes.GROUPS.items()
    }
    found = {
        "depth_step": [Step(9.0, 0.01), Step(16.0, 0.02)],
        "heading_step": [Step(8.0, 0.0)],
        "start_dip": [0.01],
        "stay": [
            Stay(True, True, 1.0, 0.5),
            Stay(True, False, 0.4, 0.7),
            Stay(False, False, float("nan"), float("nan")),
        ],
        "light": [True, True],
        "heavy": [True, False],
        "shifted": [True, True, False],
    }
    numbers = {"first": 6_000_000, "groups": groups, "responses": outcomes.responses(found)}
    wide = {
        name: {"median": {"e_tau_map": 0.07, "e_tau_told": 0.3, "e_tau_true": true}}
        for name, true in (("S4", 0.45), ("S2", 0.43))
    }
    honest = {"plants": 20, "as_file": {"S4": 0.13, "S2": 0.16}, "rows": wide, "learned": wide}
    return {"outcome": {"numbers": numbers}, "honest": {"numbers": honest}}


def test_shares_are_told_as_counts_with_their_interval() -> None:
    """Protects: 19 of 20 is not "95 %" without saying how sure that is; every group's collisions count."""
    rows = {row.figure: row for row in rows_of(parts())}
    collided = rows["hull in the dock, uncommanded"]
    assert (collided.measured, collided.target) == ("7 of 140", "0 of 1,000")
    docked = rows["docked, approach into the current"]
    assert (docked.measured, docked.interval) == ("19 of 20", "76.4 % – 99.1 %")
    held = rows["hover held for 10 min in every accepted current"]
    assert held.measured == "1 of 2" and held.of.startswith("of 3 draws")  # what isn't accepted isn't counted
    wander = rows["heading wander about the approach in such a hover"]
    assert wander.measured.startswith("0.6° RMS")  # those that were lost count too
    assert rows["1 N too light or too heavy"].measured == "2 of 2 too light, 1 of 2 too heavy"
    assert rows["1 % of the mass moved by 5 cm"].measured == "2 of 3"
    assert rows["RMS e_τ by the true wrench, S4"].measured == "0.13; S2 0.16 (medians)"
    unknown = rows["the same where lift and thrust differ from the file"]
    assert unknown.measured == "S4 0.07 / 0.3 / 0.45; S2 0.07 / 0.3 / 0.43"
    assert rows["the same, thrust and lift learned from the log of one flight before"].of == unknown.of


def test_steps_count_the_flights_that_docked() -> None:
    """Protects: gentle is a share of dockings, none of which may hide behind a flight that never switched."""
    rows = {row.figure: row for row in rows_of(parts())}
    assert rows["largest step F→R, to the ramp's end + 15 s"].measured.startswith("≤ 0.05 on 100 %")
    assert rows["largest step R→H, to the ramp's end + 15 s"].measured.startswith("≤ 0.05 on 0 %")
    assert "worst 16 s, 2.0 %" in rows["depth 0.5 m step in F"].measured


def test_what_was_not_measured_says_so_and_leads_the_page_anyway() -> None:
    """Protects: a missing figure is not a row left out."""
    rows = rows_of({})
    assert {row.measured for row in rows} == {UNMEASURED}
    assert [row.figure for row in rows] == [row.figure for row in rows_of(parts())]
    assert outcomes_html(rows).count(UNMEASURED) == len(rows)
    assert summary_html({}).startswith("<h2>Does it dock?</h2>")


def test_the_results_page_has_every_row() -> None:
    """Protects: docs/results.md tells what the page tells, bad rows too."""
    text = outcomes_text(parts())
    for row in rows_of(parts()):
        assert f"| {row.figure} | {row.before} | {row.target} | {row.measured} |" in text


def test_allocators_stand_side_by_side() -> None:
    """Protects: no row of the table is left out of the page, and shares carry their interval."""
    one = {
        "title": "MD-CA, ramp (S4)", "docked": 0.95, "docked_interval": (0.76, 0.99),
        "endings": {"docked": 19, "collided": 1}, "gentle": {"fr": 0.9, "rh": 0.8},
        "median": dict.fromkeys(
            ("late_step_fr", "late_step_rh", "wrench_error_rms", "reverse_depth_m_rms", "energy_j",
             "fin_travel_deg"), 0.125),
    }  # fmt: skip
    rows = {"mdca_ramp": one, "wls": one | {"title": "WLS, no ramp (S2)"}}
    text = fair_text({"fair": {"numbers": {"flights": 20, "rows": rows}}})
    assert "| MD-CA, ramp (S4) | 95 % (76 % – 99 %) | 1 |" in text and "| WLS, no ramp (S2) |" in text
