"""Charts over HTTP: kept in the data folder, shown in a mission's frame, heeded by check and start."""

import hashlib
from collections.abc import Callable, Iterator

import pytest

from bumpless.config.mission import missions_folder
from bumpless_server.settings import Settings
from tests.server.plan.charts.files import ASC, GEOJSON, SLOPE, png, tiff
from tests.server.serving import Running, serving

DOCKING = (missions_folder() / "docking.yaml").read_bytes()
HERE = {"latitude_deg": 47.5, "longitude_deg": 8.5}


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False)) as server:
        yield server


def _put(server: Running, name: str, data: bytes, file_name: str, **more: str) -> dict:
    reply = server.http.put(f"/api/charts/{name}", params={"file_name": file_name, **more}, content=data)
    reply.raise_for_status()
    return reply.json()


def test_a_chart_is_kept_byte_for_byte_and_shown_in_metres(alone: Running) -> None:
    """Protects: what was stored can be had again, and is drawn where it lies."""
    told = _put(alone, "pier", GEOJSON, "pier.geojson")
    assert told["kind"] == "features" and told["sha256"] == hashlib.sha256(GEOJSON).hexdigest()
    assert alone.http.get("/api/charts/pier/file").content == GEOJSON
    shown = alone.http.get("/api/charts/pier/shown", params=HERE).json()
    north, east = shown["features"][0]["parts"][0][1]
    assert abs(north) < 0.1 and east == pytest.approx(75.4, abs=0.2)
    turned = alone.http.get("/api/charts/pier/shown", params={**HERE, "heading_deg": 90}).json()
    assert turned["features"][0]["parts"][0][1][0] == pytest.approx(east, abs=0.2)
    nowhere = alone.http.get("/api/charts/pier/shown")
    assert nowhere.status_code == 422 and "origin" in nowhere.json()["detail"]


def test_pictures_and_depths_come_with_their_corners(alone: Running) -> None:
    """Protects: a picture and a grid are laid out in one order, top left first."""
    corners = "10,0;10,20;0,20;0,0"
    _put(alone, "photo", png(), "photo.png", corners=corners, local="true")
    shown = alone.http.get("/api/charts/photo/shown").json()
    assert shown["corners"] == [[10, 0], [10, 20], [0, 20], [0, 0]]
    assert alone.http.get(shown["picture"]).content.startswith(b"\x89PNG")
    _put(alone, "lake", tiff(SLOPE), "lake.tif")
    depths = alone.http.get("/api/charts/lake/shown", params=HERE).json()["depths"]
    assert (depths["rows"], depths["columns"]) == (60, 80) and depths["depth_m"][0] == 5.0
    assert (depths["least_m"], depths["deepest_m"]) == (5.0, 20.0)


def test_charts_belong_to_the_site_or_to_missions(alone: Running) -> None:
    """Protects: a mission's own overlay does not clutter the others."""
    _put(alone, "site", GEOJSON, "site.geojson")
    _put(alone, "mine", GEOJSON, "mine.geojson")
    owned = alone.http.put(
        "/api/charts/mine/owners", json={"missions": ["docking"], "title": "My pier"}
    ).json()
    assert owned["missions"] == ["docking"] and owned["title"] == "My pier"
    names = [c["name"] for c in alone.http.get("/api/charts", params={"mission": "other"}).json()]
    assert names == ["site"]
    again = _put(alone, "mine", GEOJSON, "mine.geojson")
    assert again["missions"] == ["docking"]  # a new file of an old chart stays where it belongs
    alone.http.post("/api/missions/docking/duplicate", json={"to": "ours"}).raise_for_status()
    alone.http.put("/api/charts/mine/owners", json={"missions": ["docking", "ours"]}).raise_for_status()
    alone.http.post("/api/missions/ours/rename", json={"to": "theirs"}).raise_for_status()
    (mine,) = [c for c in alone.http.get("/api/charts").json() if c["name"] == "mine"]
    assert mine["missions"] == ["docking", "theirs"]  # it goes along with its mission's name
    assert alone.http.delete("/api/charts/mine").status_code == 204
    assert alone.http.get("/api/charts/mine/file").status_code == 404


def test_what_is_no_chart_is_refused_and_leaves_nothing(alone: Running) -> None:
    """Protects: a hostile file costs a sentence, not the list."""
    for data, name in ((b"PK\x03\x04", "a.kmz"), (b"MM\x00*" + b"\xff" * 50, "b.tif"), (b"", "c")):
        reply = alone.http.put("/api/charts/bad", params={"file_name": name}, content=data)
        assert reply.status_code == 422 and name in reply.json()["detail"]
    beside = alone.http.put("/api/charts/..%2Fx", params={"file_name": "x"}, content=GEOJSON)
    assert beside.status_code in (404, 405, 422)
    assert alone.http.get("/api/charts").json() == []
    (alone.console.data.charts / "torn.chart").write_bytes(b"PK\x03\x04")
    assert alone.http.get("/api/charts").json() == []
    assert any(name == "torn.chart" for _, name, _ in alone.console.left_out())


def test_the_check_and_the_start_heed_the_sea_floor(alone: Running) -> None:
    """Protects: a mission over a shoal is refused with place and mend; in deep water it is none the worse."""
    text = DOCKING + b"sea_floor: {clearance_m: 5, grid: basin}\n"
    alone.http.put("/api/missions/deep", content=text).raise_for_status()
    missing = alone.http.get("/api/missions/deep/findings").json()
    assert [f["code"] for f in missing["findings"] if f["severity"] == "hard"] == ["sea_floor_unknown"]
    _put(alone, "basin", ASC, "basin.asc", local="true")
    found = alone.http.get("/api/missions/deep/findings").json()
    near = [f for f in found["findings"] if f["code"] == "too_near_the_floor"]
    assert near and near[0]["mends"] and near[0]["line"] > 0
    start = alone.http.post("/api/mission/start", json={"name": "deep"})
    assert start.status_code == 422 and "sea floor" in start.json()["detail"]
    _put(alone, "basin", ASC.replace(b"4", b"9"), "basin.asc", local="true")
    assert alone.http.get("/api/missions/deep/findings").json()["ok"]


def test_no_tiles_come_from_anywhere_unless_a_setting_says_so(
    alone: Running, make_settings: Callable[..., Settings]
) -> None:
    """Protects: a plan tells nobody on the network where it is."""
    assert alone.http.get("/api/charts/tiles").json() == {"address": "", "attribution": ""}
    wanted = "http://tiles.local/{z}/{x}/{y}.png"
    assert make_settings(tiles=wanted).tiles == wanted
    with pytest.raises(ValueError, match="tiles"):
        make_settings(tiles="javascript:alert(1)")
