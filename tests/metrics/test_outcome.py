"""How a run ended, on runs made up cycle by cycle."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from bumpless.config.vehicle import Fin, Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import APPROACH, FORWARD, HOVER
from bumpless.metrics import Columns, Ending, outcome_of
from bumpless.metrics.dock import Body, is_inside
from bumpless.physics.hydrodynamics.myring import HullStrips

MakeRun = Callable[..., Columns]
N = 400  # 20 s
NAN = np.full((N, 6), np.nan)


def in_hover(make_run: MakeRun, **columns: Any) -> Columns:
    """20 s in hover on the observation point, 1.5 m short of a target at (10.5, 0, 5), heading north."""
    eta = np.tile([9.0, 0.0, 5.0, 0.0, 0.0, 0.0], (N, 1))
    base = {
        "mode": np.full(N, HOVER),
        "eta": eta,
        "eta_hat": eta,
        "observation_point": np.tile([9.0, 0.0, 5.0], (N, 1)),
        "target": np.tile([10.5, 0.0, 5.0, 0.0], (N, 1)),
        "target_true": np.tile([10.5, 0.0, 5.0], (N, 1)),
    }
    return make_run(N, **(base | columns))


def moved(index: int, by: float, rows: slice = slice(None)) -> np.ndarray:
    """`in_hover`'s pose with one component off by so much in these rows."""
    eta = np.tile([9.0, 0.0, 5.0, 0.0, 0.0, 0.0], (N, 1))
    eta[rows, index] += by
    return eta


def test_held_still_at_the_point_is_docked(make_run: MakeRun, ts100: Vehicle) -> None:
    """All conditions for the last 10 s, judged by the truth."""
    outcome = outcome_of(in_hover(make_run), ts100, "completed")
    assert (outcome.ending, outcome.basis, outcome.mode) == (Ending.DOCKED, "true", "H")
    assert outcome.held_s == pytest.approx(20.0)
    assert outcome.sentence.startswith("Docked: held in hover for 20.0 s, truly 0.00 m")


@pytest.mark.parametrize(
    "changed",
    [
        {"eta": moved(0, 0.16)},
        {"eta": moved(1, -0.16)},
        {"eta": moved(2, 0.16)},  # too deep, though exactly below the point
        {"eta": moved(5, np.radians(5.1))},
        {"nu": np.tile([0.0, 0.0, 0.051, 0, 0, 0], (N, 1))},
        {"target_true": np.tile([10.5, 0.2, 5.0], (N, 1))},  # docked where the target is not
    ],
)
def test_each_limit_counts(make_run: MakeRun, ts100: Vehicle, changed: dict[str, np.ndarray]) -> None:
    """Protects: position with its vertical part, heading and speed; none may be forgotten."""
    outcome = outcome_of(in_hover(make_run, **changed), ts100, "completed")
    assert (outcome.ending, outcome.held_s) == (Ending.HELD, 0.0)


def test_it_must_last_until_the_end(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: a stay that was left, or that is shorter than 10 s, is no docking."""
    late = outcome_of(in_hover(make_run, eta=moved(0, -1.0, slice(0, 201))), ts100, "completed")
    assert (late.ending, late.held_s) == (Ending.HELD, pytest.approx(9.95))
    just = outcome_of(in_hover(make_run, eta=moved(0, -1.0, slice(0, 200))), ts100, "completed")
    assert just.ending == Ending.DOCKED
    left = outcome_of(in_hover(make_run, eta=moved(0, -1.0, slice(399, 400))), ts100, "completed")
    assert left.true_errors is not None and left.true_errors.position_m == pytest.approx(1.0)
    assert left.ending == Ending.HELD
    cycle = np.arange(N) + (np.arange(N) >= 300)  # a cycle is missing: nobody knows what happened in it
    assert outcome_of(in_hover(make_run, cycle=cycle), ts100, "completed").ending == Ending.HELD


def test_without_truth_it_is_judged_by_belief_and_says_so(make_run: MakeRun, ts100: Vehicle) -> None:
    """A real vehicle's log holds no truth."""
    run = in_hover(make_run, eta=NAN, nu=NAN, target_true=NAN[:, :3])
    outcome = outcome_of(run, ts100, "completed")
    assert (outcome.ending, outcome.basis) == (Ending.DOCKED, "believed")
    assert "as believed" in outcome.reason


def test_other_ends(make_run: MakeRun, ts100: Vehicle) -> None:
    """Time over before hover, an abort, an interruption: each with its reason, and none is docked."""
    over = outcome_of(in_hover(make_run, mode=np.full(N, FORWARD)), ts100, "completed")
    assert (over.ending, over.mode) == (Ending.TIME_OVER, "F")
    aborted = outcome_of(in_hover(make_run), ts100, "aborted", "by the operator")
    assert (aborted.ending, aborted.reason) == (Ending.ABORTED, "by the operator")
    cut = outcome_of(in_hover(make_run), ts100, "interrupted")
    assert cut.record() == {
        "outcome": "interrupted",
        "outcome_reason": "The run was interrupted.",
        "outcome_basis": "true",
    }
    nothing = outcome_of(make_run(0), ts100, "aborted")
    assert nothing.ending == Ending.ABORTED and nothing.as_dict()["true_errors"] is None


def on_a_line(make_run: MakeRun, east: float, depth: float = 5.0) -> Columns:
    """North at 0.5 m/s past the marker at (10.5, 0, 5), for 20 s from 5 m before it."""
    eta = np.zeros((N, 6))
    eta[:, 0], eta[:, 1], eta[:, 2] = 5.5 + 0.025 * np.arange(N), east, depth
    nu = np.zeros((N, 6))
    nu[:, 0] = 0.5
    return in_hover(make_run, mode=np.full(N, FORWARD), eta=eta, eta_hat=eta, nu=nu)


@pytest.mark.parametrize(("east", "depth"), [(0.0, 5.0), (0.49, 5.0), (0.0, 5.49), (-0.3, 4.7)])
@pytest.mark.parametrize("how", ["completed", "aborted", "interrupted"])
def test_through_the_docks_plane_is_a_collision_whatever_follows(
    make_run: MakeRun, ts100: Vehicle, east: float, depth: float, how: Any
) -> None:
    """Protects: a hull in the dock is never a flight that merely ran out of time or was stopped."""
    outcome = outcome_of(on_a_line(make_run, east, depth), ts100, how, "by the operator")
    assert outcome.ending == Ending.COLLIDED
    aside = np.hypot(east, depth - 5.0)
    assert f"{aside:.2f} m from its marker, 8.0 s" in outcome.reason  # 3.964 m until the nose is there
    assert outcome.closest_m == pytest.approx(aside)
    assert outcome.closest_s is not None and 7.95 <= outcome.closest_s <= 12.5


def test_beside_the_dock_is_no_collision(make_run: MakeRun, ts100: Vehicle) -> None:
    """The dock has an edge: past it the closest approach is told, and nothing else.

    1 m to the side, and the thrusters, 0.107 m wide, 0.41 m abeam of the hull.
    """
    outcome = outcome_of(on_a_line(make_run, 1.47), ts100, "completed")
    assert (outcome.ending, outcome.closest_m) == (Ending.TIME_OVER, pytest.approx(1.47))
    assert outcome_of(on_a_line(make_run, 1.46), ts100, "completed").ending == "collided"
    wide = Body(width_m=2.1)
    assert outcome_of(on_a_line(make_run, 1.47), ts100, "completed", body=wide).ending == "collided"


def test_the_dock_has_a_length(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: whoever comes in from the side, behind the marker's plane, is in the dock as well."""
    eta = np.zeros((N, 6))
    eta[:, 0], eta[:, 1], eta[:, 2], eta[:, 5] = 12.3, 5.0 - 0.02 * np.arange(N), 5.0, -np.pi / 2
    crossing = in_hover(make_run, mode=np.full(N, FORWARD), eta=eta, eta_hat=eta)
    behind = outcome_of(crossing, ts100, "completed", body=Body(length_m=1.3))
    assert (behind.ending, behind.why) == (Ending.TIME_OVER, "still in forward")
    inside = outcome_of(crossing, ts100, "completed")
    assert (inside.ending, inside.why) == (Ending.COLLIDED, "in the dock in forward")


def test_a_dock_that_stands_fast_is_met_there_too(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: an approach at an angle is judged by the dock as it stands, and across the way in use."""
    turned = {"stage": np.full(N, APPROACH), "approach": np.full(N, np.radians(60.0))}
    side = np.tile([10.0, 1.2, 5.0, 0.0, 0.0, 0.0], (N, 1))
    run = in_hover(make_run, eta=side, eta_hat=side, **turned)
    assert outcome_of(run, ts100, "completed").ending == Ending.COLLIDED  # across the way in use
    back = np.tile([10.8, -2.0, 5.0, 0.0, 0.0, np.pi / 2], (N, 1))
    run = in_hover(make_run, eta=back, eta_hat=back, **turned)
    assert outcome_of(run, ts100, "completed").ending != Ending.COLLIDED
    assert outcome_of(run, ts100, "completed", body=Body(heading=0.0)).ending == Ending.COLLIDED


def test_a_simulation_that_broke_down_is_no_success(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: states that are no numbers end a run as aborted, whatever was held before."""
    broken = moved(0, 0.0)
    broken[-1] = np.nan
    outcome = outcome_of(in_hover(make_run, eta=broken, eta_hat=broken), ts100, "completed")
    assert (outcome.ending, outcome.why) == (Ending.ABORTED, "the simulation broke down")


def test_the_tail_counts_as_much_as_the_nose(make_run: MakeRun, ts100: Vehicle) -> None:
    """Backing into the dock stern first: only the tail, 1.164 m behind the origin, reaches the plane."""
    eta = np.tile([9.4, 0.1, 5.0, 0.0, 0.0, np.pi], (N, 1))
    outcome = outcome_of(in_hover(make_run, eta=eta), ts100, "completed")
    assert outcome.ending == Ending.COLLIDED and "0.10 m from its marker" in outcome.reason


def test_the_hull_across_the_approach_touches_only_where_it_is(make_run: MakeRun, ts100: Vehicle) -> None:
    """Broadside before the plane: near, but not through it."""
    eta = np.tile([10.0, 0.0, 5.0, 0.0, 0.0, np.pi / 2], (N, 1))
    outcome = outcome_of(in_hover(make_run, eta=eta), ts100, "completed")
    assert (outcome.ending, outcome.closest_m) == (Ending.HELD, pytest.approx(0.5))


def test_errors_at_the_end_are_told_as_true_and_as_believed(make_run: MakeRun, ts100: Vehicle) -> None:
    """Protects: the vertical part of the range, and a navigation error, which only the two together show."""
    true = np.tile([9.0, 0.3, 5.4, 0.0, 0.0, 0.1], (N, 1))
    outcome = outcome_of(in_hover(make_run, eta=true), ts100, "completed")
    assert outcome.true_errors is not None and outcome.believed_errors is not None
    assert outcome.true_errors.position_m == pytest.approx(0.5)
    assert outcome.true_errors.horizontal_m == pytest.approx(0.3)
    assert outcome.true_errors.depth_m == pytest.approx(0.4)
    assert outcome.true_errors.heading_deg == pytest.approx(np.degrees(0.1))
    assert outcome.believed_errors.position_m == 0.0
    message = outcome.message()
    assert message.ending == pb.ENDING_HELD and message.mode == pb.MODE_HOVER
    assert message.true_errors.depth_m == outcome.true_errors.depth_m
    blind = outcome_of(in_hover(make_run, eta=NAN, nu=NAN, target_true=NAN[:, :3]), ts100, "completed")
    assert blind.true_errors is None and not blind.message().HasField("true_errors")


@pytest.mark.parametrize(("stage", "ending"), [(0, "held"), (3, "held"), (4, "waved_off"), (5, "waved_off")])
def test_an_approach_given_up_is_waved_off(
    make_run: MakeRun, ts100: Vehicle, stage: int, ending: str
) -> None:
    """Stages of the docking automaton: 4 backs away from the dock, 5 holds clear of it; 0 is none."""
    columns = {name: np.full(N, value) for name, value in (("stage", stage), ("reason", 1), ("tried", 3))}
    outcome = outcome_of(in_hover(make_run, eta=moved(0, -4.0), **columns), ts100, "completed")
    assert (outcome.ending, outcome.tries) == (ending, 3)
    in_place = outcome_of(in_hover(make_run, **{**columns, "stage": np.full(N, 3)}), ts100, "completed")
    assert in_place.ending == Ending.DOCKED


def test_the_approach_heading_in_use_counts(make_run: MakeRun, ts100: Vehicle) -> None:
    """A target may be approached from another side than its own heading: where the automaton says so."""
    turned = {"stage": np.full(N, 3), "approach": np.full(N, np.radians(20.0))}
    outcome = outcome_of(in_hover(make_run, eta=moved(5, np.radians(20.0)), **turned), ts100, "completed")
    assert outcome.ending == Ending.DOCKED


def test_every_ending_is_the_contracts() -> None:
    """Protects: a word that only one of them knows."""
    assert {f"ENDING_{e.name}" for e in Ending} == set(pb.Ending.keys()) - {"ENDING_UNSPECIFIED"}


@pytest.mark.parametrize(("with_it", "ending"), [(True, Ending.DOCKED), (False, Ending.HELD)])
def test_speed_counts_against_a_target_that_moves(
    make_run: MakeRun, ts100: Vehicle, with_it: bool, ending: Ending
) -> None:
    """Protects: a hull that swings with a hung dock is still, one that stands while it swings is not."""
    time = 0.05 * np.arange(N)
    sway, rate = 0.05 * np.sin(1.5 * time), 0.075 * np.cos(1.5 * time)
    target = np.tile([10.5, 0.0, 5.0], (N, 1))
    target[:, 1] += sway
    eta, nu = moved(5, 0.03), np.zeros((N, 6))
    if with_it:
        eta[:, 1] += sway
        nu[:, 0], nu[:, 1] = rate * np.sin(0.03), rate * np.cos(0.03)
    run = in_hover(make_run, eta=eta, nu=nu, target_true=target)
    assert outcome_of(run, ts100, "completed").ending is ending


@pytest.mark.parametrize("body", [Body(2.0, 1.5, 0.0), Body(0.8, 0.5, 0.0), Body(0.3, 0.3, 0.0)])
def test_hull_in_the_dock_is_what_points_all_over_it_say(ts100: Vehicle, body: Body) -> None:
    """Protects: no flank, corner or nose gets 1 cm into a dock unseen, and none is seen that is 2 cm off."""
    skin, rng = skin_of(ts100), np.random.default_rng(1)
    eta = np.zeros((1500, 6))
    eta[:, :3] = rng.uniform(-1.6, 1.6, (len(eta), 3)) * [1.0, 1.0, 0.6]
    eta[:, 3:5], eta[:, 5] = rng.normal(0.0, 0.15, (len(eta), 2)), rng.uniform(-np.pi, np.pi, len(eta))
    found = is_inside(eta, eta[:, :3], 0.0, ts100, body)
    depth = np.array([deepest(Rotation.from_euler("ZYX", e[5:2:-1]).apply(skin) + e[:3], body) for e in eta])
    assert found[depth > 0.01].all() and not found[depth < -0.02].any()
    assert 0 < found.sum() < len(eta)


def deepest(points: np.ndarray, body: Body) -> float:
    """m: of the points, in a box from the plane x = 0 on; negative: how far off, along one axis."""
    half = body.width_m / 2.0
    x, y, z = points.T
    return float(np.minimum.reduce([x, body.length_m - x, half - np.abs(y), half - np.abs(z)]).max())


def skin_of(vehicle: Vehicle) -> np.ndarray:
    """Points on the hull's skin by its own formula, and on balls about its fins and screws."""
    strips = HullStrips(vehicle.hull)  # type: ignore[arg-type]
    x, turn = np.linspace(strips.x[0], strips.x[-1], 201), np.linspace(0.0, 2.0 * np.pi, 30)
    radius = np.interp(x, strips.x, strips.radius)[:, None]
    rings = np.stack([x[:, None] + 0.0 * turn, radius * np.cos(turn), radius * np.sin(turn)], axis=2)
    ball = np.random.default_rng(0).normal(size=(150, 3))
    ball /= np.linalg.norm(ball, axis=1)[:, None]
    parts = [rings.reshape(-1, 3)]
    for part in vehicle.actuators:
        size = part.span_m if isinstance(part, Fin) else part.diameter_m
        parts.append(np.array(part.position_m) + 0.5 * size * ball)
    return np.vstack(parts)
