"""Attitudes, cameras and envelope hulls: the geometry an operator reads off the picture."""

import numpy as np
import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.physics.frames import body_to_ned
from bumpless_server.scene import pose
from bumpless_server.scene.cameras import placed
from bumpless_server.scene.envelopes import AXIS_M, OVERSHOOT, clipped, full_scale
from bumpless_server.scene.hull_mesh import FACES, VERTICES, HullMesh, hull_mesh
from bumpless_server.scene.places import Places
from bumpless_server.scene.plan import LONGEST, path_points
from bumpless_server.scene.water import plane_depth


def _turned(q: pose.Quaternion, v: np.ndarray) -> np.ndarray:
    w, axis = q[0], np.array(q[1:])
    return v + 2.0 * np.cross(axis, np.cross(axis, v) + w * v)


def test_attitude_agrees_with_the_twins_rotation() -> None:
    """The drawn attitude is the one the twin's frames define."""
    attitude = pb.Attitude(roll_deg=12.0, pitch_deg=-20.0, yaw_deg=140.0)
    angles = np.radians([12.0, -20.0, 140.0])
    for v in np.eye(3):
        out = np.zeros(3)
        body_to_ned(*angles, v, out)
        np.testing.assert_allclose(_turned(pose.of_attitude(attitude), v), out, atol=1e-12)


def test_nothing_undrawable_reaches_the_scene() -> None:
    """NaN of a target that was never seen becomes the origin."""
    assert pose.vector(pb.Vector3(x=float("nan"), y=float("inf"), z=2.0)).tolist() == [0.0, 0.0, 2.0]


def _volume(mesh: HullMesh) -> float:
    a, b, c = (mesh.vertices[mesh.faces[:, k]].astype(float) for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)


def test_hull_mesh_is_the_hull() -> None:
    """A cube with points inside keeps its corners and its volume, wound outwards, in arrays of one shape."""
    corners = np.array([[x, y, z] for x in (-2, 2) for y in (-2, 2) for z in (-2, 2)], float)
    mesh = hull_mesh(np.concatenate([corners, 0.4 * corners, np.zeros((1, 3))]))
    assert mesh.vertices.shape == (VERTICES, 3) and mesh.faces.shape == (FACES, 3)
    assert mesh.extent == pytest.approx(2.0)
    assert _volume(mesh) == pytest.approx(64.0, rel=1e-5)


def test_a_hull_with_too_many_corners_still_fits() -> None:
    """More corners than the mesh has room for: nearly the same volume in the same shape."""
    points = np.random.default_rng(1).normal(size=(3000, 3))
    mesh = hull_mesh(points / np.linalg.norm(points, axis=1, keepdims=True))
    assert _volume(mesh) == pytest.approx(4.0 / 3.0 * np.pi, rel=0.05)


@pytest.mark.parametrize("spread", [(0.5, 0.0, 0.0), (0.5, 0.3, 0.0), (0.0, 0.0, 0.0)])
def test_flat_sets_stay_visible(spread: tuple[float, float, float]) -> None:
    """At rest only roll is left of the moments: a line, a plate or a point still gets some body."""
    points = np.random.default_rng(2).uniform(-1.0, 1.0, (50, 3)) * spread
    mesh = hull_mesh(points)
    assert np.isfinite(mesh.vertices).all()
    assert _volume(mesh) > 0.0
    np.testing.assert_allclose(np.ptp(mesh.vertices, axis=0), np.ptp(points, axis=0), atol=0.02)


def test_scale_moves_in_round_steps_and_holds() -> None:
    """Full scale is 1, 2 or 5 times a power of ten, holds the set, and does not hunt."""
    for extent in (0.03, 0.4, 0.99, 4.7, 11.5, 84.0):
        scale = full_scale(extent, 0.0)
        assert scale >= min(extent, scale)
        assert extent <= scale
        mantissa = scale / 10.0 ** np.floor(np.log10(scale) + 1e-9)
        assert min(abs(mantissa - m) for m in (1.0, 2.0, 5.0)) < 1e-9
    assert full_scale(4.0, 10.0) == 10.0
    assert full_scale(2.0, 10.0) < 10.0


def test_an_arrow_beyond_the_scale_is_cut_in_its_own_direction() -> None:
    """Demand far outside what can be drawn keeps its direction."""
    tip = clipped(np.array([300.0, 0.0, -400.0]), 10.0)
    assert np.linalg.norm(tip) == pytest.approx(OVERSHOOT * AXIS_M)
    np.testing.assert_allclose(tip / np.linalg.norm(tip), [0.6, 0.0, -0.8])
    assert clipped(np.zeros(3), 10.0).tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("view", ["follow", "overview", "top", "target"])
def test_cameras_look_down_on_what_they_name(view: str) -> None:
    """Every preset stands above what it looks at, at a finite distance, also before anything is known."""
    known = Places(
        np.array([10.0, 5.0, 3.0]),
        0.4,
        np.array([[0, 0, 3.0], [30, 0, 4.0]]),
        np.array([30.0, 1.0, 4.0]),
        0.1,
    )
    for places in (Places(), known):
        position, aim = placed(view, places)
        assert np.isfinite(position).all()
        assert position[2] < aim[2]
        assert 2.0 < np.linalg.norm(position - aim) < 500.0


def test_top_view_has_north_up() -> None:
    """Seen from above the camera leans south, so north is at the top of the screen."""
    position, aim = placed("top", Places())
    assert position[0] < aim[0] and position[1] == aim[1]


def test_path_is_thinned_with_its_ends_kept() -> None:
    """A path of thousands of points costs no more than the longest drawn one."""
    points = [pb.Vector3(x=float(k), z=2.0) for k in range(5000)]
    drawn = path_points(pb.Plan(path_ned_m=points))
    assert len(drawn) == LONGEST
    assert drawn[0, 0] == 0.0 and drawn[-1, 0] == 4999.0


def test_reference_plane_is_under_everything() -> None:
    """It never cuts through the vehicle, and unknown depths do not move it."""
    assert plane_depth(2.2, 4.0) == 6.0
    assert plane_depth(0.0, float("nan")) == 2.0
