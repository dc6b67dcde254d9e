"""The study of S7: counts that agree with its flights, and a chapter and results block made of them."""

import json
import math
from collections.abc import Callable

import pytest

from bumpless.sim.twin import Result
from bumpless_paper.report import page_of
from bumpless_paper.report.parts.diagnosis import part_of
from bumpless_paper.report.results import diagnosis_text
from bumpless_paper.study.detection import Detection
from bumpless_paper.study.diagnosis import run, summary


def found(delay: float, isolated: bool | None = True, error: float = 0.01) -> Detection:
    return Detection(0.01, 0, 45.0, 0.4, delay, isolated, error, 0.3)


def test_a_fault_never_found_counts_as_the_longest_delay() -> None:
    """Protects: quantiles of the delay are not flattered by what was missed."""
    told = summary([found(2.0), found(4.0), found(math.nan, None, math.nan)], [])
    assert told["flights"] == 3 and told["found"] == told["isolated"] == 2
    assert told["delay_s"] == {"median": 4.0, "q90": None}
    assert told["error"]["median"] == pytest.approx(0.01)


def test_an_alarm_on_a_whole_actuator_is_counted_by_the_hour() -> None:
    """Protects: false alarms of flights with and without a fault are added up over all hours without one."""
    false = Detection(0.49, 2, math.nan, 1.0, math.nan, None, math.nan, math.nan)
    told = summary([found(2.0, False)], [false])
    assert (told["false_alarms"], told["found"], told["isolated"]) == (2, 1, 0)
    assert told["false_alarms_per_hour"] == pytest.approx(4.0)


def test_the_study_becomes_a_chapter_and_a_results_block(flight: Callable[[str], Result]) -> None:
    """Protects: every batch of flights lands in its own row, and the page can be made of the answer."""
    answer = run(1, workers=1)
    json.dumps(answer, allow_nan=False)
    assert answer["nominal"]["isolated"] == answer["nominal"]["flights"] == 5
    assert answer["tuned"]["flights"] == answer["unseen"]["flights"] == 1
    assert [row["flights"] for row in answer["where"]] == [1] * 9
    assert all(row["healthy_hours"] == pytest.approx(0.02, rel=0.01) for row in answer["wrong_map"])
    assert answer["nominal_figures"]["rms_e_tau_post_true"]["S7/S5"] < 0.6
    part = part_of(answer, flight("S7"), 1)
    page = page_of([part], {})
    assert "Finding the fault" in page and "n_v1, braking (R)" in page
    assert "5 of 5" in diagnosis_text(part.as_dict())
