"""The drawn vehicle is the one in the file: radii, mounting, and which way things move."""

import numpy as np
import pytest

from bumpless.config.vehicle import Fin, MyringHull, Vehicle, load_vehicle
from bumpless_server.scene import mesh
from bumpless_server.scene.hull import hull_radius_at, myring_radius
from bumpless_server.scene.model import parts_of
from bumpless_server.scene.part import joint_angle, spin_step


@pytest.fixture(scope="module")
def ts100() -> Vehicle:
    return load_vehicle("ts100")


def test_hull_radius_at_known_stations(ts100: Vehicle) -> None:
    """Nose tip, end of nose, mid-body and end of tail have the radii the Myring form prescribes."""
    hull = ts100.hull
    assert isinstance(hull, MyringHull)
    nose, middle = hull.nose_length_m, hull.middle_length_m
    stations = [0.0, nose / 2, nose, nose + middle / 2, nose + middle]
    ellipse = 0.5 * hull.diameter_m * (1 - 0.25) ** (1 / hull.nose_exponent)
    expected = [0.0, ellipse, 0.1, 0.1, 0.1]
    np.testing.assert_allclose(myring_radius(hull, stations), expected, atol=1e-12)
    tip = myring_radius(hull, [nose + middle + hull.tail_length_m])
    np.testing.assert_allclose(tip, 0.0, atol=1e-12)


def test_hull_mesh_spans_the_vehicle(ts100: Vehicle) -> None:
    """The mesh runs from nose to tail in body axes and is as thick as the file says."""
    assert isinstance(ts100.hull, MyringHull)
    hull = next(p for p in parts_of(ts100) if p.role == "hull")
    low, high = hull.mesh[0].min(axis=0), hull.mesh[0].max(axis=0)
    assert high[0] == pytest.approx(ts100.hull.nose_to_origin_m)
    assert high[0] - low[0] == pytest.approx(ts100.hull.length_m, rel=1e-5)
    assert high[1] - low[1] == pytest.approx(ts100.hull.diameter_m, rel=1e-3)


def test_every_actuator_is_drawn_and_moves(ts100: Vehicle) -> None:
    """Four rudders and three screws, each tied to its place in the file's order."""
    moving = [p for p in parts_of(ts100) if p.axis is not None]
    assert [p.command for p in moving] == list(range(7))
    assert [p.role for p in moving] == ["fin"] * 4 + ["propeller"] * 3


def test_positive_deflection_turns_leading_edge_towards_lift(ts100: Vehicle) -> None:
    """In forward flow a fin lifts to the side its leading edge turns to: the same sign as the plant's."""
    for part in parts_of(ts100):
        if part.role == "fin":
            assert part.axis is not None
            rotation = mesh.turn(part.axis, joint_angle(10.0))
            leading = rotation @ [1.0, 0.0, 0.0]
            lift = np.asarray(ts100.actuators[part.command].direction)
            assert leading @ lift == pytest.approx(np.sin(np.radians(10.0)))


def test_fin_stands_on_its_stock(ts100: Vehicle) -> None:
    """Lift acts at the arm of the file: the blade reaches equally far inside and outside of it."""
    for part in parts_of(ts100):
        fin = ts100.actuators[part.command]
        if part.role == "fin" and isinstance(fin, Fin):
            radial = np.array([0.0, fin.position_m[1], fin.position_m[2]]) / fin.arm_m
            reach = (part.mesh[0] + np.asarray(part.position)) @ radial
            assert reach.max() == pytest.approx(fin.arm_m + fin.span_m / 2, rel=1e-5)


def test_screws_turn_with_their_shaft(ts100: Vehicle) -> None:
    """Direction follows the sign of the speed and the hand of the screw; a stopped shaft stands still."""
    assert spin_step(120.0, 0.05) > 0.0 > spin_step(-120.0, 0.05)
    assert spin_step(0.0, 0.05) == 0.0
    axes = {p.name: p.axis or (0.0, 0.0, 0.0) for p in parts_of(ts100) if p.role == "propeller"}
    assert axes["n_v1"][2] == pytest.approx(1.0)
    assert axes["n_v2"][2] == pytest.approx(-1.0)


def test_faces_point_outwards(ts100: Vehicle) -> None:
    """Volumes by the divergence theorem are positive, so light falls on the right side."""
    for part in parts_of(ts100):
        if part.role == "hull":
            v, f = part.mesh
            a, b, c = v[f[:, 0]].astype(float), v[f[:, 1]].astype(float), v[f[:, 2]].astype(float)
            volume = float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)
            assert volume == pytest.approx(ts100.mass.displaced_volume_m3, rel=0.05)


class _BoxHull:
    kind = "tabulated"
    size_m = (0.46, 0.34, 0.25)
    length_m, diameter_m = 0.46, 0.25


class _BoxVehicle:
    hull = _BoxHull()
    actuators = ()


def test_other_vehicles_get_a_frame_of_their_size() -> None:
    """A vehicle without a Myring hull is an open frame that fills its bounding box."""
    parts = parts_of(_BoxVehicle())
    low = np.min([p.mesh[0].min(axis=0) for p in parts], axis=0)
    high = np.max([p.mesh[0].max(axis=0) for p in parts], axis=0)
    np.testing.assert_allclose(high - low, _BoxHull.size_m, rtol=0.05)
    assert hull_radius_at(_BoxHull, 0.0) == pytest.approx(0.17)
