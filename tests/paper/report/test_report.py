"""The report: plots, tables, page and docs/results.md say what the numbers say; the page stands alone."""

import csv
import io
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from bumpless.contract.enums import FORWARD, REVERSE
from bumpless_paper.report import Comparison, Figure, Grid, Panel, Part, Series, Solid, page_of
from bumpless_paper.report.csv_text import csv_of
from bumpless_paper.report.labels import coordinate, label
from bumpless_paper.report.parts import PARTS, run_part, wanted_parts
from bumpless_paper.report.parts.extensions import effect
from bumpless_paper.report.parts.tradeoff import best
from bumpless_paper.report.plot import POINTS, panel_svg, thinned
from bumpless_paper.report.results import BEGIN, END, renewed, results_text, with_results
from bumpless_paper.report.shortfalls import CAUSES, shortfalls
from bumpless_paper.report.solid import solid_svg
from bumpless_paper.report.summary import summary_html
from bumpless_paper.report.table_html import table_html
from bumpless_paper.report.ticks import decades, number, percent, ticks
from bumpless_paper.study.goals import GOALS
from bumpless_paper.study.tank import about_mean, segments, steps
from bumpless_paper.study.tradeoff import CURVES

ROOT = Path(__file__).parents[3]


def example() -> Figure:
    x = np.linspace(0.0, 10.0, 5000)
    return Figure("wave", "A <wave>", "", [Panel("time (s)", "depth (m)", [Series("a&b", x, np.sin(x))])])


def test_the_page_is_one_file_and_escapes_what_it_shows() -> None:
    """Protects: no script, no outside address but the links, names that hold markup stay text."""
    table = Comparison("t", "Table", "", ["x"], {"S1": ([1.0], [1.5], [0.1]), "S2": ([None], [2.0], None)})
    html = page_of([Part("p", "Part & parcel", "text", [table], [example()])], {"Bumpless": "1"})
    assert "<script" not in html
    assert not re.search(r'(src|href)="(https?:)?//', html)
    assert "A &lt;wave&gt;" in html
    assert "a&amp;b" in html
    assert "+50.0 %" in html
    assert 'href="wave.csv"' in html


def test_figures_are_well_formed_and_keep_their_extremes() -> None:
    """Protects: every SVG parses; thinning for the page never hides a peak."""
    ElementTree.fromstring(panel_svg(example().panels[0]).split("<div")[0])  # type: ignore[arg-type]
    square = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    ElementTree.fromstring(solid_svg(Solid("body", square, faces, ("X", "Y", "Z"))))
    x, y = np.arange(50_000.0), np.random.default_rng(0).normal(size=50_000)
    y[31_234] = 50.0
    kept = thinned(x, y)
    assert len(kept) <= POINTS + 2
    assert y[kept].max() == 50.0


def test_the_csv_beside_a_figure_has_every_point() -> None:
    """Protects: the CSV is the data, not the thinned curve."""
    rows = list(csv.DictReader(io.StringIO(csv_of(example()))))
    assert len(rows) == 5000
    assert float(rows[-1]["y"]) == pytest.approx(np.sin(10.0))


def test_numbers_are_written_as_people_do() -> None:
    """Protects: ticks are round, missing is a dash, changes carry their sign."""
    assert decades(0.05, 2000.0) == [0.1, 1.0, 10.0, 100.0, 1000.0]
    assert decades(0.3, 4.0) == [0.5, 1.0, 2.0]
    assert ticks(0.0, 1.0, 5) == pytest.approx([0.0, 0.2, 0.4, 0.6, 0.8, 1.0])
    assert number(None) == "–"
    assert number(-0.123456) == "−0.1235"
    assert percent(-0.8117) == "−81.2 %"


def test_parts_are_chosen_by_their_tables() -> None:
    """Protects: --only tableA6 finds the tank; a name nobody knows is refused."""
    assert wanted_parts([]) == list(PARTS)
    assert wanted_parts(["tableA6", "table3"]) == ["table3", "tank"]
    with pytest.raises(KeyError):
        wanted_parts(["table9"])


def test_table_3_is_within_5_percent() -> None:
    """Protects: the headline of the page, all ten printed numbers, and what sampling misses."""
    part = run_part("table3")
    assert part.numbers["largest_deviation"] < 0.05
    assert 0.25 < part.numbers["force_volume_missed"] < 0.5
    assert json.loads(json.dumps(part.as_dict()))["tables"]["table3"]["rows"]["rudder"]["paper"][0] == 0.0693


def test_every_cross_check_passes() -> None:
    """Protects: the plant of every shipped vehicle against laws and independent code."""
    assert run_part("physics").numbers["failed"] == []


def test_remus_rows_carry_their_reason() -> None:
    """Protects: no deviation beyond 5 % without a reason beside it."""
    table, reasons = run_part("remus").tables
    assert isinstance(table, Grid) and isinstance(reasons, Grid)
    letters = {row[0] for row in reasons.rows}
    assert all(abs(row[4] - 1.0) <= 0.05 or row[5] in letters for row in table.rows)
    assert letters == {row[5] for row in table.rows if row[5]}


class Flight:
    """What the tank's figures read of a run: 20 Hz rows of one fin and one thruster."""

    class vehicle:
        control_period_s = 0.05

        @staticmethod
        def slots(kind: str) -> list[int]:
            return [["fin", "thruster"].index(kind)]

    def __init__(self) -> None:
        from bumpless.sim.log import LOG

        self.log = np.zeros(800, LOG)
        self.log["time"] = 0.05 * np.arange(800)
        self.log["mode"] = np.repeat([FORWARD, REVERSE], 400)
        self.log["u"][:, 1] = np.where(self.log["time"] < 20.0, 2.0, 1.0)  # rev/s
        self.log["u"][:, 0] = np.radians(5.0) * (self.log["time"] >= 35.0)


def test_steps_of_table_a5_are_taken_at_1_hz_near_the_switch() -> None:
    """Protects: windows and units: 60 rpm at the switch count, the fin's 5 deg at 35 s do not."""
    flight = Flight()
    propeller, fins, _ = steps(flight, FORWARD, REVERSE)  # type: ignore[arg-type]
    assert propeller == pytest.approx(60.0)
    assert fins == 0.0
    assert {mode: len(rows) for mode, rows in segments(flight.log).items()} == {
        FORWARD: 400,
        REVERSE: 400,
    }
    assert about_mean(np.array([1.0, 3.0])) == pytest.approx(1.0)


def test_some_parts_can_be_renewed_alone() -> None:
    """Protects: `--only` renews its parts and leaves the others, in the order of the page; none is lost."""
    old = {"software_version": "1", "parts": {"tank": {"n": 1}, "table6": {"n": 1}, "gone": {}}}
    new = renewed(old, {"software_version": "2", "parts": {"table3": {"n": 2}, "tank": {"n": 2}}})
    assert new == {
        "software_version": "2",
        "parts": {"table3": {"n": 2}, "table6": {"n": 1}, "tank": {"n": 2}},
    }
    assert list(new["parts"]) == ["table3", "table6", "tank"]


def test_the_results_page_holds_the_numbers_behind_it() -> None:
    """Protects: nobody edits a result by hand; `make results` makes both."""
    page = (ROOT / "docs" / "results.md").read_text(encoding="utf-8")
    document = json.loads((ROOT / "results" / "reproduce.json").read_text(encoding="utf-8"))
    assert with_results(page, document) == page
    assert results_text(document) in page
    assert page.count(BEGIN) == page.count(END) == 1


def test_columns_stand_as_their_cells_do() -> None:
    """Protects: numbers and percentages to the right, words to the left, their headings with them."""
    rows = [["a", 1.5, "−3.1 %", "met"], ["b", None, "> +9999 %", "two\nlines"]]
    html = table_html(Grid("t", "T", "", ["name", "x", "change", "said"], rows))
    assert '<th class="num">x</th><th class="num">change</th><th class="word">said</th>' in html
    assert '<td class="num">−3.1 %</td><td class="word">met</td>' in html
    assert "two<br>lines" in html


def test_a_trade_off_names_the_best_point_of_each_goal() -> None:
    """Protects: the price of a goal is read at the point that is best for it."""
    curve = next(c for c in CURVES if c.id == "price")
    shares = [(0.6, 0.8, 0.9), (0.2, 0.9, 1.0)]
    points = [
        {"value": value, "goals": {n: {"share": s} for n, s in zip(curve.goals, of, strict=True)}}
        for value, of in zip((0.1, 10.0), shares, strict=True)
    ]
    found = best(curve, {"in_use": 10.0, "points": points})
    assert [(top["at"], top["share"]) for top in found] == [(0.1, 0.6), (10.0, 0.9), (10.0, 1.0)]
    assert found[0]["others"] == {"d_u,FR S3->S4": 0.8, "d_u,RH S3->S4": 0.9}


def test_an_extension_is_needed_where_a_goal_falls_without_it() -> None:
    """Protects: the column that says what each extension is for."""
    on = {goal.name: {"share": 0.95} for goal in GOALS}
    off = {goal.name: {"share": 0.95} for goal in GOALS}
    first, second, third = (goal.name for goal in GOALS[:3])
    off[first] = {"share": 0.5}
    on[second], off[second] = {"share": 0.6}, {"share": 0.4}
    off[third] = {"share": 1.0}
    assert effect(on, off) == {"needed for": [first], "helps": [second], "costs": [third]}


def test_every_shortfall_has_its_reason_and_its_numbers() -> None:
    """Protects: the results page says why a goal is missed, with share, place and price from the JSON."""
    name = "S4<=S2 e_tau"
    robust = {
        "numbers": {"missed": [name], "share": {name: 0.28}},
        "tables": {"goals": {"rows": [["S4 ≤ S2 e_τ", "x", "noise 1 against 0"]]}},
    }
    point = {"value": 0.1, "goals": {name: {"ratio": 0.97, "share": 0.55}}}
    trade = {
        "numbers": {
            "plants": 40,
            "titles": {"price": "price"},
            "curves": {"price": {"points": [point]}},
            "best": [{"curve": "price", "goal": name, "share": 0.55, "at": 0.1, "others": {"d_u,FR": 0.8}}],
        }
    }
    stability = {
        "numbers": {
            "docking": {"spectral_radius": {"F": 0.9, "H": 1.0}, "slowest_in": {"H": "plant.eta[1]"}}
        },
        "tables": {"dwell": {"rows": [["docking", 1, 60, 3.0, None, None, 120, "not proven"]]}},
    }
    lines = shortfalls({"robustness": robust, "tradeoff": trade, "stability": stability})
    assert len(lines) == 2
    for told in ("28 %", CAUSES[name][1:], "noise 1 against 0", "55 % of 40 plants at price 0.1", "80 %"):
        assert told in lines[0], told
    assert "does not contract" in lines[1] and "the vehicle's position east" in lines[1]
    assert set(CAUSES) <= {goal.name for goal in GOALS}


def test_figures_are_shown_by_words() -> None:
    """Protects: nobody reads the code's names on the page; words stay as they are."""
    assert label("depth_rms_m") == "depth RMS (m)"
    assert label("d_u_FR_mixed") == "d_u, F→R, ° and rpm"
    assert label("rms_e_tau_all (N, N·m)") == "RMS e_τ, all cycles (N, N·m)"
    assert label("r_sat_all (1)") == "r_sat, all cycles"
    assert label("closest to the point (m)") == "closest to the point (m)"
    assert coordinate("autopilot.pid.integral[5]") == "integral of heading"
    assert coordinate("something else") == "something else"


def test_the_head_of_the_page_sums_up_the_parts_that_were_made() -> None:
    """Protects: the summary says what the numbers say, and a page of one part has one of its own."""
    change = {"S3_to_S4_d_u_FR": {"paper": -0.8117, "ours": -0.944, "range": None}}
    parts = {
        "table6": {"numbers": {"changes": change}},
        "physics": {"numbers": {"passed": 20, "checks": 21}},
    }
    html = summary_html(parts)
    assert "S3→S4 d_u, F→R −94 % (paper −81 %)" in html
    assert "20 of 21" in html
    assert "falls short" not in html
