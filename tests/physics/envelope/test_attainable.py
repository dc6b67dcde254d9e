"""Attainable sets by support functions: exact where exactness can be checked, constant in shape, monotone."""

from typing import Any

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from bumpless.config.vehicle import load_vehicle, vehicle_names
from bumpless.physics.actuators import FIN, THRUSTER
from bumpless.physics.envelope import attainable_sets, sampled_sets, select, wrench_curves
from bumpless.physics.envelope_hull import Hull, direction_sphere, hull_of_points
from bumpless.physics.model import build_model

MODELS = {name: build_model(load_vehicle(name)) for name in vehicle_names()}
TS100 = MODELS["ts100"]


def inside(hull: Any, points: np.ndarray, slack: float) -> bool:
    """Whether all points lie in a SciPy hull, within slack."""
    return bool((points @ hull.equations[:, :3].T + hull.equations[:, 3] <= slack).all())


def test_volume_converges_from_below() -> None:
    """Every vertex is attainable, so more directions can only fill the set up."""
    for part in ("force", "moment"):
        volumes = [getattr(attainable_sets(TS100, 0.2, n), part).volume for n in (30, 120, 500, 4000)]
        reference = volumes[-1]
        assert all(v <= reference * (1 + 1e-9) for v in volumes)
        gaps = [reference - v for v in volumes[:-1]]
        assert gaps[0] > gaps[1] > gaps[2]
        assert gaps[2] < 0.005 * reference


@pytest.mark.parametrize("name", sorted(MODELS))
def test_no_command_leaves_the_set(name: str) -> None:
    """Random commands within bounds give forces and moments inside the hulls."""
    model = MODELS[name]
    n = int(model["n_u"])
    draw = np.random.default_rng(3).random((4000, n))
    commands = model["command_min"][:n] + (model["command_max"] - model["command_min"])[:n] * draw
    w = wrench_curves(model, 0.4, commands, np.arange(n)).sum(axis=0)
    envelope = attainable_sets(model, 0.4, 2000)
    for hull, points in ((envelope.force, w[:, :3]), (envelope.moment, w[:, 3:])):
        if hull.dimension == 3:
            width = np.ptp(hull.vertices, axis=0).max()
            assert inside(ConvexHull(hull.vertices), points, 0.01 * width)


def test_vertices_and_faces_keep_their_shape_at_every_speed() -> None:
    """A scene moves the vertices in place: their number and the triangles never change, and point outward."""
    first = attainable_sets(TS100, 0.0)
    assert first.force.vertices.shape == (500, 3)
    assert first.force.faces.shape == (996, 3)
    for speed in (-0.5, 0.2, 0.7):
        other = attainable_sets(TS100, speed)
        assert other.moment.vertices.shape == (500, 3)
        assert np.array_equal(other.force.faces, first.force.faces)
    directions, faces = direction_sphere(500)
    a, b, c = (directions[faces[:, k]] for k in range(3))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), a + b + c) > 0).all()


def test_at_rest_fins_do_nothing_and_the_sets_are_flat() -> None:
    """Without flow only thrusters act: forces in the X-Z plane, no fin moment."""
    fins = attainable_sets(TS100, 0.0, actuators=select(TS100, kind=FIN))
    assert fins.force.dimension == fins.moment.dimension == 0
    assert fins.force.volume == fins.force.area == 0.0
    everything = attainable_sets(TS100, 0.0)
    assert everything.force.dimension == 2
    assert everything.force.volume == 0.0


def test_thrusters_alone_span_the_rectangle_of_their_thrusts() -> None:
    """Planar area 2 T_p x 4 T_v, counted once; the box of four corners, exactly."""
    thrusters = attainable_sets(TS100, 0.0, actuators=select(TS100, kind=THRUSTER))
    thrust = TS100["T_nn"] * TS100["command_max"] ** 2
    assert thrusters.force.area == pytest.approx(2 * thrust[4] * 4 * thrust[5], rel=1e-9)


def test_one_thruster_is_a_segment() -> None:
    """Area and volume of a segment are 0, not an error."""
    one = attainable_sets(TS100, 0.2, actuators=[4])
    assert one.force.dimension == 1
    assert one.force.area == one.force.volume == 0.0
    assert np.ptp(one.force.vertices[:, 0]) == pytest.approx(
        2 * TS100["T_nn"][4] * TS100["command_max"][4] ** 2
    )


def test_parts_add_up_to_the_whole() -> None:
    """Support functions add: h of all actuators = h of the fins + h of the thrusters along each axis."""
    whole = attainable_sets(TS100, 0.3, 4000)
    parts = [attainable_sets(TS100, 0.3, 4000, select(TS100, kind=k)) for k in (FIN, THRUSTER)]
    for part in ("force", "moment"):
        reach = getattr(whole, part).vertices.max(axis=0)
        summed = sum(getattr(p, part).vertices.max(axis=0) for p in parts)
        assert reach == pytest.approx(summed, rel=0.01, abs=1e-6)


def test_grid_hull_equals_the_hull_of_all_combinations() -> None:
    """Keeping corners between actuators changes nothing: 20^4 rudder combinations, brute force."""
    levels = np.linspace(TS100["command_min"][:7], TS100["command_max"][:7], 20)
    total = np.zeros((1, 6))
    for curve in wrench_curves(TS100, 0.2, levels, np.arange(4)):
        total = (total[:, None] + curve[None]).reshape(-1, 6)
    brute = ConvexHull(total[:, 3:])
    quick = sampled_sets(TS100, 0.2, n_random=200)["rudder"].moment
    assert quick.volume == pytest.approx(brute.volume, rel=1e-9)
    assert quick.area == pytest.approx(brute.area, rel=1e-9)


def test_hull_of_a_cube() -> None:
    """Volume, surface and outward triangles of a body known by heart; inner points are dropped."""
    corners = np.array([[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], float)
    hull = hull_of_points(np.vstack([corners, [[1, 1, 1], [0.5, 1, 1]]]))
    assert len(hull.vertices) == 8
    assert hull.volume == pytest.approx(8.0)
    assert hull.area == pytest.approx(24.0)
    a, b, c = (hull.vertices[hull.faces[:, k]] for k in range(3))
    assert np.einsum("ij,ij->", np.cross(b - a, c - a), a) / 6 == pytest.approx(8.0)


def test_flat_polygon_counts_once() -> None:
    """A tilted square of side 1 has area 1 and no volume."""
    t = np.array([[1, 1, 0], [0, 0, 1.0]]) / np.array([[2**0.5], [1.0]])
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5]]) @ t
    hull = Hull(square, np.zeros((0, 3), np.int64))
    assert (hull.dimension, hull.volume) == (2, 0.0)
    assert hull.area == pytest.approx(1.0)
