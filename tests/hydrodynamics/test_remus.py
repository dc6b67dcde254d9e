"""The method stands on Prestero's thesis: his geometry must give his coefficients."""

import json

import pytest

from twin.hydrodynamics.drag import cross_flow_drag
from twin.hydrodynamics.myring import HullStrips
from twin.hydrodynamics.remus_check import PUBLISHED, TOLERANCE, remus_check, table
from twin.vehicle import load_vehicle
from twin.vehicle_parts import MyringHull

ROWS = {row.name: row for row in remus_check()}
ADDED_MASS = ["X_udot", "Y_vdot", "Z_wdot", "M_qdot", "N_rdot"]
CROSS_TERMS = ["X_wq", "X_vr", "Y_wp", "Z_vp", "M_rp", "N_pq"]
DRAG = ["X_uu", "Y_vv", "Z_ww"]


@pytest.mark.parametrize("name", ADDED_MASS + CROSS_TERMS + DRAG)
def test_added_mass_and_drag_agree(name: str) -> None:
    """The terms that strip theory, cross-flow drag and skin friction determine: within 5 %."""
    row = ROWS[name]
    assert row.agrees, f"{name}: ours {row.ours:.4g}, thesis {row.theirs:.4g}"


@pytest.mark.parametrize(
    ("names", "share"),
    [
        (["Y_rdot", "Z_qdot", "M_wdot", "N_vdot", "X_qq", "X_rr", "Y_pq", "Z_rp", "M_vp", "N_wp"], 0.10),
        (["Y_uudr", "Z_uuds", "M_uuds", "N_uudr", "Y_ur", "Z_uq", "M_uq", "N_ur", "M_uw", "N_uv"], 0.13),
        (["Y_uv", "Z_uw"], 0.17),
    ],
)
def test_terms_with_a_known_cause_stay_within_it(names: list[str], share: float) -> None:
    """First moments and lift terms deviate by what their notes explain, and not by more."""
    for name in names:
        assert abs(ROWS[name].ratio - 1.0) <= share, name


def test_every_deviation_has_a_reason_and_nothing_else_has() -> None:
    """A reader of the table never meets an unexplained difference."""
    for row in ROWS.values():
        assert bool(row.note) == (abs(row.ratio - 1.0) > TOLERANCE), row.name
    assert set(ROWS) == set(json.loads(PUBLISHED.read_text(encoding="utf-8"))["coefficients"])
    assert len(table().splitlines()) == len(ROWS) + 1


def test_hull_has_the_published_areas_and_volume() -> None:
    """Frontal 0.0285, planform 0.226, wetted 0.709 m^2, volume 0.0315 m^3."""
    hull = load_vehicle("remus100").hull
    assert isinstance(hull, MyringHull)
    strips = HullStrips(hull)
    assert strips.frontal_area == pytest.approx(0.0285, rel=0.01)
    assert strips.planform_area == pytest.approx(0.226, rel=0.01)
    assert strips.wetted_area == pytest.approx(0.709, rel=0.02)
    assert strips.volume == pytest.approx(0.0315, rel=0.01)


def test_published_rotation_drag_is_beyond_any_geometry() -> None:
    """The note on M_qq and N_rr: side area times the largest arm cubed bounds the integral at 49 N m s^2."""
    hull = load_vehicle("remus100").hull
    assert isinstance(hull, MyringHull)
    strips = HullStrips(hull)
    bound = cross_flow_drag(strips, 1030.0)[1, 1] * max(abs(strips.x)) ** 3
    assert bound < 50.0 < abs(ROWS["N_rr"].theirs) < abs(ROWS["M_qq"].theirs)


def test_planform_center_is_behind_the_origin() -> None:
    """The note on M_ww: the printed profile's side view has its centre 16 mm behind O_b."""
    hull = load_vehicle("remus100").hull
    assert isinstance(hull, MyringHull)
    strips = HullStrips(hull)
    center = strips.integral(2 * strips.radius * strips.x) / strips.planform_area
    assert center == pytest.approx(-0.0156, abs=5e-4)
