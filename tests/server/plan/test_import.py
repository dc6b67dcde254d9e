"""Files of other programs become missions that can be flown, with a word on all that did not carry over.

The files in `foreign` were written for these tests, in the formats that their programs write.
"""

import io
import math
import time
import zipfile
from pathlib import Path

import pytest

from bumpless.config.mission import Mission, missions_folder, parse_mission
from bumpless_server.plan.exchange.read import Imported, imported
from bumpless_server.plan.exchange.route import NotImportable
from bumpless_server.plan.exchange.write import FORMATS, NotExportable, exported

FOREIGN = Path(__file__).with_name("foreign")
FILES = sorted(path.name for path in FOREIGN.iterdir())
CASES = Path(__file__).parents[2] / "cases"


def _read(name: str) -> tuple[Imported, Mission]:
    found = imported((FOREIGN / name).read_bytes(), name, "ts100")
    return found, parse_mission(found.yaml)


def _left(found: Imported) -> str:
    return "\n".join(f"{item.what}: {item.note}" for item in found.items if not item.carried)


@pytest.mark.parametrize("name", FILES)
def test_every_kind_becomes_a_mission_that_is_valid(name: str) -> None:
    """Protects: what is imported can be flown as it stands, and what was chosen for it is said."""
    found, mission = _read(name)
    assert mission.vehicle == "ts100" and len(mission.legs) >= 1
    assert "target: put 1.5 m beyond" in _left(found)
    assert all(item.what for item in found.items)


def test_a_plan_says_item_by_item_what_became_of_it() -> None:
    """Protects: no item of a plan is dropped without a word, none is counted as flown that is not."""
    found, mission = _read("harbour.plan")
    assert found.kind == "a QGroundControl plan"
    assert [leg.speed_mps for leg in mission.legs] == [0.7, 0.5, 0.5]
    assert [leg.to_ned_m[2] for leg in mission.legs] == [3.0, 4.0, 4.0]
    assert mission.origin is not None and (mission.origin.latitude_deg, mission.origin.longitude_deg) == (
        47.5,
        8.5,
    )
    assert mission.start.position_ned_m == (0.0, 0.0, 3.0)
    assert mission.legs[1].to_ned_m[0] == pytest.approx(22.24, abs=0.01)  # 0.0002 deg of latitude
    left, carried = _left(found), [item for item in found.items if item.carried]
    assert "DO_SET_CAM_TRIGG_DIST" in left and "NAV_RETURN_TO_LAUNCH" in left
    assert "rally point 1" in left
    assert any(item.what == "geofence circle 1" and "keep-in" in item.note for item in carried)
    assert mission.keep_in is not None and len(mission.keep_out) == 1
    assert all(
        math.hypot(c.north_m, c.east_m) == pytest.approx(90.0, abs=0.05) for c in mission.keep_in.corners
    )
    assert mission.keep_out[0].corners[0].north_m == pytest.approx(33.36, abs=0.01)
    assert any("hold of 12 s" in item.note for item in carried)
    assert any("loitering for a time" in item.note for item in carried)


def test_a_survey_comes_as_the_legs_it_was_made_of() -> None:
    """Protects: a pattern whose transects the file holds is not lost; heights in the air are no depths."""
    found, mission = _read("survey.plan")
    assert len(mission.legs) == 2 and all(leg.to_ned_m[2] == 2.0 for leg in mission.legs)
    assert "StructureScan" in _left(found) and "2 places have none" in _left(found)
    assert any("above the water" in item.note for item in found.items)


def test_moos_east_comes_before_north_and_depth_from_its_own_behaviour() -> None:
    """Protects: x,y of MOOS are east,north; a swap would mirror the way."""
    found, mission = _read("lap.bhv")
    assert mission.start.position_ned_m == (-40.0, 60.0, 6.0)
    assert [leg.to_ned_m for leg in mission.legs] == [(-160.0, 60.0, 6.0), (-160.0, 150.0, 6.0)]
    assert all(leg.speed_mps == 1.2 for leg in mission.legs)
    assert "BHV_OpRegion area" in _left(found) and "BHV_Waypoint home: one way" in _left(found)


def test_neptus_follows_its_transitions_and_reads_its_angles() -> None:
    """Protects: manoeuvres come in the plan's order, not the file's; both ways of writing angles are read."""
    found, mission = _read("plan.nmis")
    assert [leg.to_ned_m[2] for leg in mission.legs] == [2.0, 3.0, 4.0]
    assert mission.legs[1].speed_mps == 1.1 and mission.legs[0].speed_mps == 0.7
    assert mission.origin is not None
    assert mission.origin.latitude_deg == pytest.approx(41 + 11 / 60 + 6.8 / 3600)
    assert mission.origin.longitude_deg == pytest.approx(-(8 + 42 / 60 + 21.2 / 3600))
    assert "plan other" in _left(found)
    assert any("RowsManeuver" in item.what and "pattern" in item.note for item in found.items)
    assert any("rpm" in item.note for item in found.items)


def test_packed_missions_are_unpacked() -> None:
    """Protects: .nmisz and .kmz are what people really have."""
    for name, inner in (("harbour.nmisz", "plan.nmis"), ("way.kmz", "way.kml")):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("notes.txt", "x")
            archive.write(FOREIGN / inner, f"files/{inner}")
        got, bare = (
            imported(packed.getvalue(), name, "ts100"),
            imported((FOREIGN / inner).read_bytes(), name, "ts100"),
        )
        assert got == bare


def _bomb() -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("plan.nmis", b"<mission-def>" + b" " * 200_000_000)
    return packed.getvalue()


LAUGHS = (
    b'<?xml version="1.0"?><!DOCTYPE k [<!ENTITY a "ha">'
    + b"".join(b'<!ENTITY %c "%s">' % (98 + i, b"&%c;" % (97 + i) * 10) for i in range(9))
    + b"]><kml>&j;</kml>"
)
OUTSIDE = b'<!DOCTYPE k [<!ENTITY x SYSTEM "file:///etc/passwd">]><kml><Placemark><name>&x;</name></Placemark></kml>'


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("laughs.kml", LAUGHS, "entities"),
        ("outside.kml", OUTSIDE, "entities"),
        ("bomb.nmisz", _bomb(), "larger than"),
        ("cut.nmisz", b"PK\x03\x04 not an archive", "ZIP"),
        ("deep.plan", b'{"mission": ' + b"[" * 100_000, "JSON"),
        ("deep.kml", b"<kml>" + b"<a>" * 5000, "XML"),
        ("empty.plan", b'{"fileType": "Plan", "mission": {"items": [], "version": 2}}', "no place"),
        ("fence.plan", b'{"fileType": "GeoFence", "mission": {}}', "not a plan"),
        ("short.waypoints", b"QGC WPL 110\n0\t1\t0\t16\n", "12"),
        ("nan.waypoints", b"QGC WPL 110\n1\t0\t3\t16\t0\t0\t0\t0\tnan\t8\t-1\t1\n", "finite"),
        ("off.geojson", b'{"type": "Point", "coordinates": [8, 147]}', "no latitude"),
        ("odd.geojson", b'{"type": "Feature", "geometry": null}', "GeoJSON"),
        ("names.csv", b"a,b\n1,2\n", "no columns"),
        ("one.csv", b"north_m,east_m\n1,2\n", "single place"),
        ("far.csv", b"north_m,east_m\n0,0\n900000,0\n", "km away"),
        ("picture.png", b"\x89PNG\r\n\x1a\n", "picture"),
        ("map.tif", b"II*\x00 ", "TIFF"),
        ("page.html", b"<html><body>404</body></html>", "web page"),
        ("latin.csv", b"north_m,east_m,\xe9\n", "UTF-8"),
        ("mission.unknown", b"hello", "no kind"),
        ("empty.kml", b"", "empty"),
    ],
)
def test_what_cannot_be_imported_is_refused_with_a_reason(name: str, data: bytes, words: str) -> None:
    """Protects: hostile, broken and strange files cost little and are named for what they are."""
    begun = time.process_time()
    with pytest.raises(NotImportable, match=words):
        imported(data, name, "ts100")
    assert time.process_time() - begun < 5.0  # of the processor; seconds would be a bomb that went off


def _with_origin() -> Mission:
    text = (missions_folder() / "docking.yaml").read_text()
    return parse_mission(text + "\norigin: {latitude_deg: 63.4, longitude_deg: 10.4, heading_deg: 30}\n")


@pytest.mark.parametrize("to", sorted(FORMATS))
def test_what_is_exported_is_imported_as_the_same_way(to: str) -> None:
    """Protects: positions, depths and speeds survive the way to another program and back."""
    mission = _with_origin()
    found = exported(mission, to)
    back = parse_mission(imported(found.data, f"x{found.ending}", "ts100").yaml)
    if to == "csv":
        assert any(not item.carried for item in found.items)
    assert back.origin is not None and mission.origin is not None
    ways = [[m.origin.to_geographic(*p[:2]) for p in m.path_ned_m] for m in (mission, back)]  # type: ignore[union-attr]
    assert len(ways[0]) == len(ways[1])
    for ours, theirs in zip(*ways, strict=True):
        assert mission.origin.to_local(*theirs) == pytest.approx(mission.origin.to_local(*ours), abs=0.02)
    assert [p[2] for p in back.path_ned_m[1:]] == [p[2] for p in mission.path_ned_m[1:]]
    if to in ("plan", "wpl", "csv"):
        assert [leg.speed_mps for leg in back.legs] == [leg.speed_mps for leg in mission.legs]


def test_an_export_says_what_it_loses_and_what_it_needs() -> None:
    """Protects: nobody believes that another program's file holds the dock; a chart needs an origin."""
    mission = parse_mission((missions_folder() / "docking_current.yaml").read_bytes())
    assert {item.what for item in exported(mission, "csv").items} >= {"target", "environment"}
    for to in ("plan", "wpl", "geojson", "kml"):
        with pytest.raises(NotExportable, match="origin"):
            exported(mission, to)


HOME = "0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.5\t0\t1\n"


@pytest.mark.parametrize(
    ("row", "why"),
    [
        ("1\t0\t0\t5001\t3\t0\t0\t0\t47.5\t8.5\t0\t1\n", "fence points"),
        ("1\t0\t0\t5100\t0\t0\t0\t0\t47.5\t8.5\t0\t1\n", "rally points"),
        ("1\t0\t3\t203\t0\t0\t0\t0\t0\t0\t0\t1\n", "row 1: DO_DIGICAM_CONTROL"),
    ],
)
def test_a_list_without_a_way_is_named_as_what_it_is(row: str, why: str) -> None:
    """Protects: a fence is not called an empty mission; the reason names the steps, not what lies around."""
    with pytest.raises(NotImportable, match=why):
        imported(f"QGC WPL 110\n{HOME}{row}".encode(), "list.waypoints", "ts100")


def test_a_plan_of_hundreds_of_places_comes_whole() -> None:
    """Protects: a survey that was drawn elsewhere loses none of its legs up to 511."""
    rows = "".join(f"{i}\t0\t3\t16\t0\t0\t0\t0\t{47.5 + i * 1e-4:.7f}\t8.5\t-3\t1\n" for i in range(1, 513))
    found = imported(f"QGC WPL 110\n{HOME}{rows}".encode(), "long.waypoints", "ts100")
    assert len(parse_mission(found.yaml).legs) == 511
