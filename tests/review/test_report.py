"""A report to send: one file that fetches nothing, small, with the run's own figures and words."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser

import bumpless
from bumpless.review.report import report_of

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, bumpless.Run]:
    """A flight and its log."""
    flown = bumpless.fly(MISSION)
    return flown.save(tmp_path_factory.mktemp("log") / "a.mcap"), flown


@pytest.fixture(scope="module")
def text(run: tuple[Path, bumpless.Run]) -> str:
    return report_of(run[0])


def test_it_is_one_small_file_that_fetches_nothing(text: str) -> None:
    """Protects who opens it at sea: no address but names of namespaces, no script, under 3 MB."""
    assert len(text.encode()) < 3_000_000
    fetched = re.findall(r"""(?:src|href)\s*=\s*["'](?!#)([^"']*)|@import|url\((?!#)""", text)
    assert fetched == [] and "<script" not in text


def test_it_says_how_the_run_ended_and_by_which_figures(text: str, run: tuple[Path, bumpless.Run]) -> None:
    """Protects the reader: the verdict is the outcome's sentence, the figures are those of the metrics."""
    flown = run[1]
    assert flown.outcome.sentence.split(":")[0] in text
    assert f"{flown.metrics.d_u_rh:.4f}" in text and f"{flown.metrics.shaft_energy_j:.1f}" in text
    assert flown.info.mission_sha256 in text and flown.info.vehicle_sha256 in text
    assert "Proposition 1: 0 violations" in text
    assert text.count("<svg") == 5


def test_every_switch_is_explained(text: str, run: tuple[Path, bumpless.Run]) -> None:
    """Protects the ledger: why, and what would have prevented it, in the vehicle's own words."""
    told = [m for topic, m in run[1].messages() if topic == "event" and m.code == "mode_switch"]
    assert told
    for event in told:
        assert event.details["unless"] in text


def test_a_logs_words_are_no_markup(tmp_path: Path, run: tuple[Path, bumpless.Run]) -> None:
    """Protects from a mission whose name is a script."""
    mission = tmp_path / "evil.yaml"
    mission.write_text(MISSION.read_text().replace("title:", "title: <script>alert(1)</script> #", 1))
    assert "<script" not in report_of(bumpless.fly(mission).save(tmp_path / "evil.mcap"))


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
