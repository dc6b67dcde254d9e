"""The bytes of files: exact, UTF-8, and named when they are something else."""

import hashlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.text import NotText, decoded, foreign_kind
from bumpless.config.vehicle import FOLDER, VehicleError, load_vehicle, parse_vehicle

DOCKING = (Path(__file__).parents[2] / "missions" / "docking.yaml").read_bytes()
FOREIGN = [
    (b'{"fileType": "Plan", "version": 1}', "a QGroundControl plan"),
    (b'\xef\xbb\xbf{\r\n "groundStation": "QGroundControl"}', "a QGroundControl plan"),
    (b'{"type": "FeatureCollection", "features": []}', "a GeoJSON file"),
    (b"QGC WPL 110\r\n0\t1\t0\t16", "a list of waypoints (WPL) of MAVLink ground stations"),
    (b'<?xml version="1.0"?>\n<kml xmlns="http://www.opengis.net/kml/2.2">', "a KML file"),
    (b"<gpx><trk/></gpx>", "a GPX track"),
    (b"PK\x03\x04\x14\x00", "a ZIP archive, as Neptus .nmis and .kmz files are"),
    (b"\x89MCAP0\r\n", "an MCAP log"),
    (b"//----\nBehavior = BHV_Waypoint\n{", "a MOOS-IvP behaviour file"),
    (b"<?xml version='1.0'?><other/>", "an XML file"),
]


@pytest.mark.parametrize(("data", "kind"), FOREIGN)
def test_files_of_known_foreign_kinds_are_named(data: bytes, kind: str) -> None:
    """Protects: a plan of another program is not refused as a typing error."""
    with pytest.raises(MissionError, match="not a Bumpless mission") as caught:
        parse_mission(data, "other")
    assert caught.value.problems[0].rule == f"is {kind}, not a Bumpless mission"
    with pytest.raises(VehicleError, match="not a Bumpless vehicle"):
        parse_vehicle(data, "other")


def test_our_own_files_are_not_foreign() -> None:
    """Protects: JSON is YAML, so a mission may be written as JSON."""
    assert foreign_kind(DOCKING) is None
    assert foreign_kind(b'{"version": 1, "name": "x"}') is None
    assert all(foreign_kind(path.read_bytes()) is None for path in FOLDER.glob("*.toml"))


@pytest.mark.parametrize(
    ("data", "line", "column", "said"),
    [
        (b"# Kurs 45\xb0\nversion: 1\n", 1, 10, "byte 0xb0 at offset 9; it looks like Latin-1"),
        (b"version: 1\r\n# \xe9t\xe9\r\n", 2, 3, "byte 0xe9 at offset 14; it looks like Latin-1"),
        ("version: 1\ntitle: Käse ".encode() + b"\xff\n", 2, 13, "byte 0xff at offset 24"),
        ("version: 1".encode("utf-16"), 1, 1, "byte 0xff at offset 0; it looks like UTF-16"),
        (b"version: 1\ntitle: \xe2\x82", 2, 8, "byte 0xe2 at offset 18"),
    ],
)
def test_bytes_that_are_no_text_are_refused_at_their_place(
    data: bytes, line: int, column: int, said: str
) -> None:
    """Protects: the same refusal for missions and vehicles, with the byte's place."""
    for refused in (lambda: parse_mission(data, "latin.yaml"), lambda: parse_vehicle(data, "latin.yaml")):
        with pytest.raises((MissionError, VehicleError)) as caught:
            refused()
        (problem,) = caught.value.problems
        assert (problem.file, problem.line, problem.column) == ("latin.yaml", line, column)
        assert said in problem.rule


@given(st.binary(max_size=60))
def test_any_bytes_are_kept_or_refused(data: bytes) -> None:
    """Protects: a text gives its bytes back exactly; nothing else than NotText is raised."""
    try:
        assert decoded(data, "x").encode() == data
    except NotText as error:
        before = data[: int(error.problem.rule.rpartition("offset ")[2].split(";")[0])]
        assert (
            error.problem.line
            == 1 + len(before.decode().replace("\r\n", "\n").replace("\r", "\n").split("\n")) - 1
        )


def test_half_a_character_in_a_str_is_refused() -> None:
    """Protects: a text from JSON may hold what no file can."""
    with pytest.raises(MissionError, match="half of a character"):
        parse_mission("version: 1 # \ud800\n")


@pytest.mark.parametrize(
    "change",
    [lambda d: d.replace(b"\n", b"\r\n"), lambda d: b"\xef\xbb\xbf" + d, lambda d: d.replace(b"\n", b"\r")],
)
def test_line_ends_and_byte_order_mark_change_the_hash_but_not_the_mission(change) -> None:
    """Protects: one hash of the file's bytes, and one verdict, in every way that a file can come."""
    data = change(DOCKING)
    mission, plain = parse_mission(data, "m.yaml"), parse_mission(DOCKING, "m.yaml")
    assert mission.sha256 == hashlib.sha256(data).hexdigest() == parse_mission(data.decode(), "m.yaml").sha256
    assert mission.text.encode() == data
    assert (mission.legs, mission.target, mission.start) == (plain.legs, plain.target, plain.start)
    bad = change(DOCKING.replace(b"duration_s: 90", b"duration_s: fast"))
    with pytest.raises(MissionError) as caught:
        parse_mission(bad, "m.yaml")
    assert caught.value.problems[0].line == 1 + DOCKING.split(b"\n").index(b"duration_s: 90")


@pytest.mark.parametrize("change", [lambda d: d.replace(b"\n", b"\r\n"), lambda d: b"\xef\xbb\xbf" + d])
def test_vehicle_files_of_other_editors_load_too(change, tmp_path: Path) -> None:
    """Protects: both files of a vehicle may have Windows line ends or a byte order mark."""
    for name in ("ts100.toml", "ts100.control.toml"):
        (tmp_path / name).write_bytes(change((FOLDER / name).read_bytes()))
    vehicle, plain = load_vehicle(tmp_path / "ts100.toml"), load_vehicle("ts100")
    assert (vehicle.actuators, vehicle.control) == (plain.actuators, plain.control)
    assert parse_vehicle(vehicle.text, vehicle.source) == vehicle
