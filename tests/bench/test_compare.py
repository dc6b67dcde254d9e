"""When `make bench ARGS=--check` fails, and that the published table is the measured one."""

import dataclasses
import json

import pytest

from tests.bench.compare import regressions
from tests.bench.figure import figure
from tests.bench.render import FIGURES, PAGE, page_of

RATIO = figure("r", "ratio", [290.0, 310.0, 330.0], "×", at_least=300, ratio=True)
SHARE = figure("s", "share", [2.0], "%", below=3)
TIME = figure("t", "time", [1.0], "s", below=3.0)


def committed(*rows):
    return {"figures": [row.as_json() for row in rows]}


def test_the_same_figures_are_no_regression():
    """Protects: the check passes where nothing changed, goals missed before included."""
    missed = figure("m", "missed", [15.0], "%", below=3)
    assert missed.met is False
    assert regressions([RATIO, SHARE, TIME, missed], committed(RATIO, SHARE, TIME, missed)) == []


@pytest.mark.parametrize("values", [[170.0, 250.0, 370.0], [400.0] * 3])
def test_noise_is_no_regression(values):
    """Protects: a busy minute lowers medians of ratios; the better quartile hardly moves."""
    noisy = figure("r", "ratio", values, "×", at_least=300, ratio=True)
    assert regressions([noisy], committed(RATIO)) == []


def test_a_slower_ratio_is_a_regression():
    """Protects: code that has become slower against its peer is seen, also where its goal is far away."""
    slow = figure("r", "ratio", [550.0, 560.0, 570.0], "×", at_least=300, ratio=True)
    fast = figure("r", "ratio", [990.0, 1000.0, 1010.0], "×", at_least=300, ratio=True)
    assert regressions([slow], committed(fast)) == ["ratio: 560 ×, was 1000"]
    assert regressions([fast], committed(slow)) == []


def test_a_growing_ratio_that_should_be_small_is_a_regression():
    """Protects: the direction of rows with an upper goal."""
    before, now = (figure("l", "loop", [v], "×", at_most=2.5, ratio=True) for v in (1.1, 1.7))
    assert regressions([now], committed(before)) == ["loop: 1.7 ×, was 1.1"]


def test_a_lost_goal_is_a_regression_within_the_tolerance_too():
    """Protects: no published goal is lost in small steps."""
    below = figure("r", "ratio", [280.0, 285.0, 290.0], "×", at_least=300, ratio=True)
    assert regressions([below], committed(RATIO)) == ["ratio: 285 ×, no longer ≥ 300"]


def test_a_share_may_hardly_change():
    """Protects: suboptimality is measured on the same problems each time, so it has no noise to hide in."""
    assert regressions([dataclasses.replace(SHARE, value=2.05)], committed(SHARE)) == []
    assert len(regressions([dataclasses.replace(SHARE, value=2.2)], committed(SHARE))) == 1


def test_times_are_never_compared():
    """Protects: another machine, or a busy one, does not fail the check."""
    assert regressions([dataclasses.replace(TIME, value=9.0)], committed(TIME)) == []


def test_the_page_shows_the_committed_figures():
    """Protects: docs/performance.md says what tests/bench/figures.json says."""
    page = PAGE.read_text(encoding="utf-8")
    assert page_of(page, json.loads(FIGURES.read_text(encoding="utf-8"))) == page
