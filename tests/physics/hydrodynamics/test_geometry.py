"""Coefficients from geometry: against shapes whose answers are known in closed form, and against energy."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.vehicle import Vehicle, load_vehicle, vehicle_names
from bumpless.config.vehicle.parts import MyringHull
from bumpless.physics.hydrodynamics import hull_coefficients
from bumpless.physics.hydrodynamics.added_mass import added_mass, spheroid_axial_factor
from bumpless.physics.hydrodynamics.drag import axial_drag_coefficient, cross_flow_drag
from bumpless.physics.hydrodynamics.myring import HullStrips, myring_radius

VEHICLES = {name: load_vehicle(name) for name in vehicle_names()}
ELLIPSOID = MyringHull(
    kind="myring",
    diameter_m=0.2,
    nose_length_m=1.0,
    nose_offset_m=0.0,
    middle_length_m=1.0,
    tail_length_m=0.01,
    tail_offset_m=0.0099,
    nose_exponent=2.0,
    tail_half_angle_deg=1.0,
    nose_to_origin_m=1.0,
    skin_friction_coefficient=0.003,
    cross_flow_drag_coefficient=1.1,
    body_lift_slope_per_rad=1.2,
    body_lift_x_m=-0.3,
)  # half an ellipsoid of 1 m ahead of O_b and a cylinder of 1 m behind it


def hull_of(name: str) -> MyringHull:
    hull = VEHICLES[name].hull
    assert isinstance(hull, MyringHull)
    return hull


def test_volume_of_ellipsoid_and_cylinder_is_exact() -> None:
    """Strip integrals against the closed form; the open tail counts 0.1 mm."""
    strips = HullStrips(ELLIPSOID)
    expected = 2 / 3 * math.pi * 0.1**2 + math.pi * 0.1**2
    assert strips.volume == pytest.approx(expected, rel=2e-4)
    assert strips.planform_area == pytest.approx(math.pi * 0.1 / 2 + 0.2, rel=2e-4)


def test_radius_is_continuous_and_ends_where_the_hull_ends() -> None:
    """Nose, middle and tail join; nothing stands outside the length."""
    hull = hull_of("ts100")
    x = np.linspace(-1.2, 1.1, 20001)
    radius = myring_radius(hull, x)
    inside = (x < hull.nose_to_origin_m - 0.01) & (x > hull.nose_to_origin_m - hull.length_m + 1e-3)
    assert np.abs(np.diff(radius[inside])).max() < 1e-3
    assert radius[x > hull.nose_to_origin_m].max() == 0.0
    assert radius.max() == pytest.approx(hull.diameter_m / 2)


def test_ts100_file_states_what_its_form_gives() -> None:
    """O_b at the centre of volume, displacement near the form's, inertia of a uniform filling."""
    vehicle, strips = VEHICLES["ts100"], HullStrips(hull_of("ts100"))
    assert strips.center == pytest.approx(0.0, abs=1e-3)
    assert strips.volume == pytest.approx(vehicle.mass.displaced_volume_m3, rel=0.01)
    assert vehicle.mass.moments_of_inertia_kgm2[:2] == pytest.approx(strips.uniform_inertia(1000.0), rel=0.01)
    assert strips.hull.length_m == pytest.approx(2.2)


def test_spheroid_factor_has_lambs_limits() -> None:
    """A sphere carries half its displaced mass; a needle none; REMUS' fineness between, as tabulated."""
    assert spheroid_axial_factor(1.0) == 0.5
    assert spheroid_axial_factor(1.0001) == pytest.approx(0.5, abs=1e-3)
    assert spheroid_axial_factor(7.0) == pytest.approx(0.0356, abs=5e-4)
    assert spheroid_axial_factor(100.0) < 1e-3


def test_slender_body_without_fins_carries_its_displaced_mass_sideways() -> None:
    """Strip theory: rho times volume in sway and heave, nothing in roll."""
    strips = HullStrips(ELLIPSOID)
    M_A = added_mass(strips, (), 1000.0)
    assert M_A[1, 1] == M_A[2, 2] == pytest.approx(1000.0 * strips.volume)
    assert M_A[1, 5] == pytest.approx(1000.0 * strips.volume * strips.center)
    assert M_A[3, 3] == 0.0


def test_cross_flow_drag_equals_the_drag_of_each_station_in_turn() -> None:
    """Pure heave and pure pitch against a direct sum of -k |w_x| w_x and its moment, w_x = w - x q."""
    strips = HullStrips(hull_of("ts100"))
    D = cross_flow_drag(strips, 1000.0)
    k = 0.5 * 1000.0 * 1.1 * 2 * strips.radius
    for w, q in ((0.3, 0.0), (-0.3, 0.0), (0.0, 0.2), (0.0, -0.2)):
        local = w - strips.x * q
        force = -k * np.abs(local) * local
        nu = np.array([0, 0, w, 0, q, 0])
        tau = -D @ (np.abs(nu) * nu)
        assert tau[2] == pytest.approx(strips.integral(force), rel=1e-9, abs=1e-12)
        assert tau[4] == pytest.approx(strips.integral(-strips.x * force), rel=1e-9, abs=1e-12)


def test_longer_hull_of_equal_width_drags_more_in_all() -> None:
    """Skin friction dominates a slender hull: force grows with length, the form factor falls."""
    short, long = HullStrips(hull_of("ts100")), HullStrips(replace(hull_of("ts100"), middle_length_m=2.4))
    assert axial_drag_coefficient(long) > axial_drag_coefficient(short)


@pytest.mark.parametrize("name", sorted(VEHICLES))
@given(nu=st.lists(st.floats(-1.5, 1.5), min_size=6, max_size=6))
def test_damping_never_adds_energy(name: str, nu: list[float]) -> None:
    """nu . tau_damping <= 0 for every velocity: drag, body lift and linear damping together."""
    c = hull_coefficients(VEHICLES[name])
    v = np.array(nu)
    speed = np.where(np.arange(6) < 3, abs(v[0]), v[0])
    tau = -(c.D_linear @ v + c.D_quadratic @ (np.abs(v) * v) + speed * (c.D_lift @ v))
    assert v @ tau <= 1e-12


@pytest.mark.parametrize("name", sorted(VEHICLES))
def test_matrices_have_the_published_sparsity(name: str) -> None:
    """D has entries 11, 22, 26, 33, 35, 44, 53, 55, 62, 66 and no other (Gao et al. 2026, eq. (5))."""
    allowed = {(0, 0), (1, 1), (1, 5), (2, 2), (2, 4), (3, 3), (4, 2), (4, 4), (5, 1), (5, 5)}
    c = hull_coefficients(VEHICLES[name])
    for D in (c.D_linear, c.D_quadratic, c.D_lift):
        assert {(int(i), int(j)) for i, j in zip(*np.nonzero(D), strict=True)} <= allowed


def test_body_lift_turns_the_bow_back_in_forward_and_reverse_flow() -> None:
    """Lift acts behind O_b seen from where the flow comes: its moment opposes drift ahead and astern."""
    vehicle: Vehicle = VEHICLES["ts100"]
    D = hull_coefficients(vehicle).D_lift
    v = 0.1
    for u in (0.5, -0.5):
        force, moment = -D[1, 1] * abs(u) * v, -D[5, 1] * u * v
        assert force < 0
        assert moment * u > 0  # drift to starboard ahead: bow to starboard; astern: stern to starboard
