"""How a run ended, on runs made up cycle by cycle."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from bumpless.contract.enums import FORWARD, HOVER
from bumpless.metrics import Columns, Ending, outcome_of

MakeRun = Callable[..., Columns]
PERIOD_S = 0.05
N = 400  # 20 s
NAN = np.full((N, 6), np.nan)


def in_hover(make_run: MakeRun, **columns: Any) -> Columns:
    """20 s in hover on the observation point, which is 1 m short of a target at (10, 0, 5), heading north."""
    eta = np.tile([9.0, 0.0, 5.0, 0.0, 0.0, 0.0], (N, 1))
    base = {
        "mode": np.full(N, HOVER),
        "eta": eta,
        "eta_hat": eta,
        "observation_point": np.tile([9.0, 0.0, 5.0], (N, 1)),
        "target": np.tile([10.0, 0.0, 5.0, 0.0], (N, 1)),
        "target_true": np.tile([10.0, 0.0, 5.0], (N, 1)),
    }
    return make_run(N, **(base | columns))


def moved(index: int, by: float, rows: slice = slice(None)) -> np.ndarray:
    """`in_hover`'s pose with one component off by so much in these rows."""
    eta = np.tile([9.0, 0.0, 5.0, 0.0, 0.0, 0.0], (N, 1))
    eta[rows, index] += by
    return eta


def test_held_still_at_the_point_is_docked(make_run: MakeRun) -> None:
    """All conditions for the last 10 s, judged by the truth."""
    outcome = outcome_of(in_hover(make_run), "completed", PERIOD_S)
    assert (outcome.ending, outcome.basis, outcome.mode) == (Ending.DOCKED, "true", "H")
    assert outcome.held_s == pytest.approx(20.0)
    assert "Held in hover for 20.0 s" in outcome.reason


@pytest.mark.parametrize(
    "changed",
    [
        {"eta": moved(0, 0.16)},
        {"eta": moved(1, -0.16)},
        {"eta": moved(2, 0.16)},  # too deep, though exactly below the point
        {"eta": moved(5, np.radians(5.1))},
        {"nu": np.tile([0.0, 0.0, 0.051, 0, 0, 0], (N, 1))},
        {"target_true": np.tile([10.0, 0.2, 5.0], (N, 1))},  # docked where the target is not
    ],
)
def test_each_limit_counts(make_run: MakeRun, changed: dict[str, np.ndarray]) -> None:
    """Protects: position with its vertical part, heading and speed; none may be forgotten."""
    outcome = outcome_of(in_hover(make_run, **changed), "completed", PERIOD_S)
    assert (outcome.ending, outcome.held_s) == (Ending.HELD, 0.0)


def test_it_must_last_until_the_end(make_run: MakeRun) -> None:
    """Protects: a stay that was left, or that is shorter than 10 s, is no docking."""
    late = outcome_of(in_hover(make_run, eta=moved(0, 1.0, slice(0, 201))), "completed", PERIOD_S)
    assert (late.ending, late.held_s) == (Ending.HELD, pytest.approx(9.95))
    just = outcome_of(in_hover(make_run, eta=moved(0, 1.0, slice(0, 200))), "completed", PERIOD_S)
    assert just.ending == Ending.DOCKED
    left = outcome_of(in_hover(make_run, eta=moved(0, 1.0, slice(399, 400))), "completed", PERIOD_S)
    assert (left.ending, left.position_error_m) == (Ending.HELD, pytest.approx(1.0))
    cycle = np.arange(N) + (np.arange(N) >= 300)  # a cycle is missing: nobody knows what happened in it
    assert outcome_of(in_hover(make_run, cycle=cycle), "completed", PERIOD_S).ending == Ending.HELD


def test_without_truth_it_is_judged_by_belief_and_says_so(make_run: MakeRun) -> None:
    """A real vehicle's log holds no truth."""
    run = in_hover(make_run, eta=NAN, nu=NAN, target_true=NAN[:, :3])
    outcome = outcome_of(run, "completed", PERIOD_S)
    assert (outcome.ending, outcome.basis) == (Ending.DOCKED, "believed")
    assert "as believed" in outcome.reason


def test_other_ends(make_run: MakeRun) -> None:
    """Time over before hover, an abort, an interruption: each with its reason, and none is docked."""
    over = outcome_of(in_hover(make_run, mode=np.full(N, FORWARD)), "completed", PERIOD_S)
    assert (over.ending, over.mode) == (Ending.TIME_OVER, "F")
    aborted = outcome_of(in_hover(make_run), "aborted", PERIOD_S, "by the operator")
    assert (aborted.ending, aborted.reason) == (Ending.ABORTED, "by the operator")
    cut = outcome_of(in_hover(make_run), "interrupted", PERIOD_S)
    assert cut.record() == {
        "outcome": "interrupted",
        "outcome_reason": "The run was interrupted.",
        "outcome_basis": "true",
    }
    nothing = outcome_of(make_run(0), "aborted", PERIOD_S)
    assert nothing.ending == Ending.ABORTED and nothing.as_dict()["position_error_m"] is None
