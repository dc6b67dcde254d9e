"""The method stands on Prestero's thesis: his geometry must give his coefficients."""

import json
from dataclasses import replace

import numpy as np
import pytest

from bumpless.config.vehicle import load_vehicle
from bumpless.config.vehicle.parts import Fin, MyringHull
from bumpless.physics.hydrodynamics.drag import cross_flow_drag, fin_cross_flow_drag
from bumpless.physics.hydrodynamics.myring import HullStrips
from bumpless_paper.remus.check import PUBLISHED, TOLERANCE, remus_check, table, thesis_coefficient

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
    """A reader of the table never meets a difference about which nothing is said."""
    for row in ROWS.values():
        assert (row.reason is not None) == (abs(row.ratio - 1.0) > TOLERANCE), row.name
    assert set(ROWS) == set(json.loads(PUBLISHED.read_text(encoding="utf-8"))["coefficients"])
    assert len(table().splitlines()) == len(ROWS) + 1


def test_readings_give_what_is_printed() -> None:
    """A reason that offers another reading of the thesis is computed, and the others are counted as open."""
    off = [row for row in ROWS.values() if not row.agrees]
    open_ = {row.name for row in off if not row.explained}
    assert open_ == {"Y_rr", "Z_qq", "M_ww", "N_vv", "M_qq", "N_rr", "K_pp"}
    assert all(row.reason is not None and not row.reason.reading for row in off if row.name in open_)
    assert len(off) == 30


def test_units_follow_from_names() -> None:
    """N over m/s^2, N over (m/s)^2, N m over rad/s^2, N over m/s rad/s."""
    units = [ROWS[name].unit for name in ("X_udot", "Y_vv", "K_pdot", "X_wq", "M_uuds", "M_uq")]
    assert units == ["kg", "kg/m", "kg·m²", "kg", "kg", "kg·m"]


def test_the_printed_moments_of_area_contradict_each_other() -> None:
    """The note on M_ww and Y_rr: each asks for another place of O_b, 58 and 30 mm farther aft."""
    from scipy.optimize import brentq

    vehicle = load_vehicle("remus100")

    def at(shift: float, name: str) -> float:
        assert isinstance(vehicle.hull, MyringHull)
        hull = replace(vehicle.hull, nose_to_origin_m=vehicle.hull.nose_to_origin_m + shift)
        fins = tuple(replace(a, x_m=a.x_m + shift) if isinstance(a, Fin) else a for a in vehicle.actuators)
        return thesis_coefficient(replace(vehicle, hull=hull, actuators=fins), name)

    for name, expected in (("M_ww", 0.058), ("Y_rr", 0.030)):
        found = brentq(lambda shift, name=name: at(shift, name) - ROWS[name].theirs, 0.0, 0.1)
        assert found == pytest.approx(expected, abs=0.001)


def test_taper_explains_half_of_the_first_moment() -> None:
    """The note on Y_rdot: trapezoidal fins of the printed taper in place of slabs of mean chord."""
    vehicle = load_vehicle("remus100")
    assert isinstance(vehicle.hull, MyringHull)
    strips, fin = HullStrips(vehicle.hull), next(a for a in vehicle.actuators if isinstance(a, Fin))
    root = 2.0 * fin.chord_m / (1.0 + 0.654)
    covered = np.abs(strips.x - fin.x_m) * 2.0 / root  # share of the root's chord at each station
    share = np.clip((1.0 - covered) / (1.0 - 0.654), 0.0, 1.0)
    a = np.where(share > 0.0, fin.arm_m - fin.span_m / 2 + fin.span_m * share, strips.radius)
    a = np.maximum(a, strips.radius)
    section = np.pi * 1030.0 * (a**2 - strips.radius**2 + strips.radius**4 / np.maximum(a, 1e-9) ** 2)
    assert -strips.integral(section * strips.x) == pytest.approx(2.03, abs=0.01)


def test_both_planes_of_fins_give_the_base_of_the_printed_rotation_drag() -> None:
    """The note on M_qq and N_rr: hull plus four fins is 9.43, a tenth and a twentieth of the print."""
    vehicle = load_vehicle("remus100")
    fins = [a for a in vehicle.actuators if isinstance(a, Fin)]
    one_plane = float(fin_cross_flow_drag(fins, 1030.0)[5, 5])
    both = -ROWS["N_rr"].ours + one_plane
    assert both == pytest.approx(9.43, abs=0.01)
    assert 10.0 * both == pytest.approx(-ROWS["N_rr"].theirs, rel=0.01)
    assert 20.0 * both == pytest.approx(-ROWS["M_qq"].theirs, rel=0.01)


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
