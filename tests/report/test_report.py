"""The report: plots, tables, page and README say what the numbers say, and the page needs nothing else."""

import csv
import io
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from twin.report import Comparison, Figure, Grid, Panel, Part, Series, Solid, page_of
from twin.report.csv_text import csv_of
from twin.report.parts import PARTS, run_part, wanted_parts
from twin.report.parts.tank import about_mean, segments, steps
from twin.report.plot import POINTS, panel_svg, thinned
from twin.report.readme import BEGIN, END, results_text, with_results
from twin.report.solid import solid_svg
from twin.report.ticks import number, percent, ticks

ROOT = Path(__file__).parents[2]


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
    table = run_part("remus").tables[0]
    assert isinstance(table, Grid)
    assert all(abs(row[3] - 1.0) <= 0.05 or row[4] for row in table.rows)


class Flight:
    """What the tank's figures read of a run: 20 Hz rows of one fin and one thruster."""

    class vehicle:
        control_period_s = 0.05
        actuators = [type("A", (), {"kind": "fin"})(), type("A", (), {"kind": "thruster"})()]

    def __init__(self) -> None:
        from twin.records import LOG

        self.log = np.zeros(800, LOG)
        self.log["time"] = 0.05 * np.arange(800)
        self.log["mode"] = np.repeat([0, 1], 400)
        self.log["u"][:, 1] = np.where(self.log["time"] < 20.0, 2.0, 1.0)  # rev/s
        self.log["u"][:, 0] = np.radians(5.0) * (self.log["time"] >= 35.0)


def test_steps_of_table_a5_are_taken_at_1_hz_near_the_switch() -> None:
    """Protects: windows and units: 60 rpm at the switch count, the fin's 5 deg at 35 s do not."""
    flight = Flight()
    propeller, fins, _ = steps(flight, 0, 1)  # type: ignore[arg-type]
    assert propeller == pytest.approx(60.0)
    assert fins == 0.0
    assert {mode: len(rows) for mode, rows in segments(flight.log).items()} == {0: 400, 1: 400}
    assert about_mean(np.array([1.0, 3.0])) == pytest.approx(1.0)


def test_the_readme_holds_the_results_of_the_numbers_behind_it() -> None:
    """Protects: nobody edits a result by hand; `make results` makes both."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    document = json.loads((ROOT / "results" / "reproduce.json").read_text(encoding="utf-8"))
    assert with_results(readme, document) == readme
    assert results_text(document) in readme
    assert readme.count(BEGIN) == readme.count(END) == 1
