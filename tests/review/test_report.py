"""A report to send: one file that fetches nothing, small, with the run's own figures and words."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from bumpless.review.compared_report import comparison_report
from bumpless.review.report import report_of
from bumpless.review.scene3d import script

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, bumpless.Run]:
    """A flight and its log."""
    flown = bumpless.fly(MISSION)
    return flown.save(tmp_path_factory.mktemp("log") / "a.mcap"), flown


@pytest.fixture(scope="module")
def text(run: tuple[Path, bumpless.Run]) -> str:
    return report_of(run[0])


def scripts(text: str) -> list[str]:
    """Every script of a page but its data."""
    return re.findall(r'<script(?! type="application/json")[^>]*>(.*?)</script>', text, re.S)


def data_of(text: str) -> dict[str, Any]:
    """What the view in 3-D shows."""
    found = re.search(r'id="replay3d-data">(.*?)</script>', text, re.S)
    assert found
    return json.loads(found[1])


def test_it_is_one_small_file_that_fetches_nothing(text: str) -> None:
    """Protects who opens it at sea: no address but names of namespaces, no script but ours, under 3 MB."""
    assert len(text.encode()) < 3_000_000
    fetched = re.findall(r"""(?:src|href)\s*=\s*["'](?!#)([^"']*)|@import|url\((?!#)""", text)
    assert fetched == [] and scripts(text) == [script()]


def test_it_says_how_the_run_ended_and_by_which_figures(text: str, run: tuple[Path, bumpless.Run]) -> None:
    """Protects the reader: the verdict is the outcome's sentence, the figures are those of the metrics."""
    flown = run[1]
    assert flown.outcome.sentence.split(":")[0] in text
    assert f"{flown.metrics.d_u_rh:.4f}" in text and f"{flown.metrics.shaft_energy_j:.1f}" in text
    assert flown.info.mission_sha256 in text and flown.info.vehicle_sha256 in text
    assert "Proposition 1: 0 violations" in text
    assert text.count("<svg") == 5
    shown = data_of(text)
    assert shown["flights"][0]["position"][0] == pytest.approx(flown.columns.eta[0, :3], abs=1e-3)


def test_every_switch_is_explained(text: str, run: tuple[Path, bumpless.Run]) -> None:
    """Protects the ledger: why, and what would have prevented it, in the vehicle's own words."""
    told = [m for _, m in run[1].messages() if isinstance(m, pb.Event) and m.code == "mode_switch"]
    assert told
    for event in told:
        assert event.details["unless"] in text


def test_a_logs_words_are_no_markup(tmp_path: Path, run: tuple[Path, bumpless.Run]) -> None:
    """Protects from a mission whose name is a script."""
    mission = tmp_path / "evil.yaml"
    mission.write_text(MISSION.read_text().replace("title:", "title: <script>alert(1)</script> #", 1))
    text = report_of(bumpless.fly(mission).save(tmp_path / "evil.mcap"))
    assert scripts(text) == [script()] and "<script>alert" not in text


def test_it_prints_on_a4(text: str, browser: Browser, tmp_path: Path) -> None:
    """Protects the print: nothing is wider than the page."""
    page = browser.new_page(viewport={"width": 794, "height": 1123})
    page.emulate_media(media="print")
    page.set_content(text)
    assert page.evaluate("document.documentElement.scrollWidth") <= 794
    wide = page.evaluate(
        "[...document.querySelectorAll('svg, table')]"
        ".filter(e => e.getBoundingClientRect().right > 795).length"
    )
    assert wide == 0
    page.close()


def test_the_replay_inside_runs_offline(text: str, browser: Browser, tmp_path: Path) -> None:
    """Protects the 3-D replay: our script runs by the page's policy, draws each moment; no other runs."""
    path = tmp_path / "report.html"
    path.write_text(text.replace("</body>", "<script>document.title = 'strange'</script></body>"))
    page = browser.new_page(viewport={"width": 900, "height": 900})
    page.goto(path.as_uri())
    drawn = "document.getElementById('replay3d').toDataURL()"
    first = page.evaluate(drawn)
    page.get_by_label("Mission time").fill("40")
    assert page.evaluate(drawn) != first
    page.get_by_role("button", name="Top").click()
    page.get_by_role("button", name="Play").click()
    assert page.get_by_role("button", name="Pause").is_visible()
    assert "strange" not in page.title()
    page.close()


def test_a_comparison_is_one_file_too(run: tuple[Path, bumpless.Run], tmp_path: Path) -> None:
    """Protects what a crew sends: verdict, both flights in 3-D from one moment, figures, what differs."""
    other = bumpless.fly(MISSION, seed=5, parameters={"hover": {"lambda": 0.5}}).save(tmp_path / "b.mcap")
    text = comparison_report([run[0], other], "hover")
    assert len(text.encode()) < 3_000_000 and scripts(text) == [script()]
    assert re.search(r"A docked; B docked, better by \d+ figures and worse by \d+", text)
    assert "hover.lambda" in text and "the first switch to hover" in text
    flights = data_of(text)["flights"]
    assert [flight["name"] for flight in flights] == ["A", "B"]
    switches = [s.time_s for s in run[1].metrics.switches if s.to_mode == 3]
    assert flights[0]["zero"] == pytest.approx(switches[0], abs=0.01)
    with pytest.raises(ValueError, match="aligned on"):
        comparison_report([run[0], other], "noon")
