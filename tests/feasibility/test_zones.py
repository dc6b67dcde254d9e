"""Legs keep out of zones and inside the boundary, or a finding says where not and what would."""

from dataclasses import replace

import pytest

from bumpless.config.mission import Mission, MissionError, missions_folder, parse_mission
from bumpless.feasibility import Finding, check_mission
from bumpless.feasibility.outline import inside, nearest, stretches
from bumpless.feasibility.zones import check_zones

DOCKING = (missions_folder() / "docking.yaml").read_text()
SQUARE = [(4.0, -3.0), (8.0, -3.0), (8.0, 3.0), (4.0, 3.0)]
HOOK = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 8.0), (8.0, 8.0), (8.0, 2.0), (0.0, 2.0)]


def _zone(corners: list[tuple[float, float]], more: str = "") -> str:
    rows = "".join(f"      - {{north_m: {n}, east_m: {e}}}\n" for n, e in corners)
    return f"keep_out:\n  - name: pier\n{more}    corners:\n{rows}"


def _found(text: str) -> tuple[Mission, list[Finding]]:
    mission = parse_mission(text)
    return mission, list(check_zones(mission))


def test_a_leg_through_a_zone_is_told_with_the_smallest_way_round() -> None:
    """Protects: a mission through a pier does not start, and the change that is offered clears it."""
    mission, found = _found(DOCKING + _zone(SQUARE))
    assert [f.code for f in found] == ["keep_out_crossed"] and found[0].blocks
    assert found[0].field == "legs[0].to_ned_m" and "4.0 m through pier" in found[0].text
    mend = found[0].mends[0]
    assert mend.path == "legs[0].to_ned_m" and isinstance(mend.value, tuple)
    legs = (replace(mission.legs[0], to_ned_m=mend.value), *mission.legs[1:])
    assert list(check_zones(replace(mission, legs=legs))) == []
    assert found[0] in check_mission(mission)


def test_a_zone_above_or_below_the_legs_is_none_of_theirs() -> None:
    """Protects: a zone with depths closes no water beyond them."""
    for above, below, hit in ((0, 1.9, 0), (2.4, 50, 0), (0, 2.0, 1), (2.0, 9, 1)):
        more = f"    from_depth_m: {above}\n    to_depth_m: {below}\n"
        assert len(_found(DOCKING + _zone(SQUARE, more))[1]) == hit


def test_what_leads_outside_the_boundary_is_told() -> None:
    """Protects: a keep-in boundary holds for every leg and the start, also where it bends inwards."""
    rows = "".join(
        f"    - {{north_m: {n}, east_m: {e}}}\n" for n, e in [(-5, -5), (12, -5), (12, 5), (-5, 5)]
    )
    _, found = _found(DOCKING + f"keep_in:\n  corners:\n{rows}")
    assert {f.code for f in found} == {"keep_in_left"} and [f.field for f in found] == ["legs[1].to_ned_m"]
    assert "12.5 m outside" in found[0].text
    value = found[0].mends[0].value
    assert isinstance(value, tuple) and inside((value[0], value[1]), [(-5, -5), (12, -5), (12, 5), (-5, 5)])


def test_a_mission_without_zones_has_no_findings_of_them() -> None:
    """Protects: nothing is found where nothing was asked."""
    assert _found(DOCKING)[1] == []


def test_an_outline_is_no_box() -> None:
    """Protects: a bay in an outline is outside of it; a way may enter and leave it several times."""
    assert inside((9.0, 5.0), HOOK) and not inside((4.0, 5.0), HOOK)
    assert stretches((4.0, -1.0), (4.0, 11.0), HOOK) == [
        pytest.approx((1 / 12, 3 / 12)),
        pytest.approx((9 / 12, 11 / 12)),
    ]
    assert stretches((4.0, 4.0), (4.0, 5.0), HOOK) == []
    assert nearest((4.0, 5.0), HOOK) in ((4.0, 2.0), (4.0, 8.0), (8.0, 5.0))


def test_a_zone_of_no_height_is_refused() -> None:
    """Protects: depths that were swapped are told where they stand."""
    with pytest.raises(MissionError, match=r"keep_out\[0\].to_depth_m"):
        parse_mission(DOCKING + _zone(SQUARE, "    from_depth_m: 5\n    to_depth_m: 2\n"))
    with pytest.raises(MissionError, match="between 3 and"):
        parse_mission(DOCKING + _zone(SQUARE[:2]))
