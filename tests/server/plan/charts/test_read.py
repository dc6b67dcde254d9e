"""Charts are read for what they are, or refused with the reason; nothing that is sent breaks the reader."""

import json

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pyproj import Transformer

from bumpless_server.plan.charts.content import NotAChart, Said
from bumpless_server.plan.charts.read import read_chart
from tests.server.plan.charts.files import ASC, GEOJSON, KML, SLOPE, UTM32, png, tiff

CORNERS = "47.5,8.5;47.5,8.51;47.49,8.51;47.49,8.5"


def test_geojson_gives_its_shapes_with_names_and_colours() -> None:
    """Protects: outlines keep their holes, heights do not get in the way, what has no place is no shape."""
    found = read_chart(GEOJSON)
    assert [(f.kind, f.name, f.colour) for f in found.features] == [
        ("area", "pier", "#ff8800"), ("point", "", ""), ("point", "", ""), ("line", "", ""),
    ]  # fmt: skip
    assert found.geographic and [len(part) for part in found.features[0].parts] == [4, 4]
    assert found.features[3].parts[0][1] == (47.5, 8.51)  # latitude first from here on


def test_a_local_geojson_is_in_metres() -> None:
    """Protects: x is east and y north, also where there is no earth."""
    found = read_chart(b'{"type": "Point", "coordinates": [120, -40]}', Said(local=True))
    assert not found.geographic and found.features[0].parts == (((-40.0, 120.0),),)


def test_kml_gives_its_placemarks_and_says_what_it_leaves() -> None:
    """Protects: the outline comes before its holes, a style's colour counts, a picture's loss is told."""
    found = read_chart(KML)
    assert [(f.kind, f.name, f.colour) for f in found.features] == [
        ("area", "reef", "#ff0000"),
        ("point", "buoy", ""),
    ]
    assert found.features[0].parts[0][1] == (47.0, 9.0) and len(found.features[0].parts) == 2
    assert "GroundOverlay" in found.notes[0]


def test_a_geotiff_of_depths_lies_where_its_tags_say() -> None:
    """Protects: half a pixel and the direction of rows; nothing-values are no depths."""
    values = SLOPE.copy()
    values[3, 4] = -9999.0
    grid = read_chart(tiff(values)).grid
    assert grid is not None and grid.geographic and grid.depth_m.shape == (60, 80)
    assert (grid.north, grid.west) == pytest.approx((47.49995, 8.50005))
    assert np.isnan(grid.depth_m[3, 4]) and grid.depth_m[0, 0] == 5.0


@pytest.mark.parametrize("kind", [np.int16, np.uint16, np.int32, np.float32])
def test_grids_of_other_numbers_are_read_too(kind: type) -> None:
    """Protects: surveys come in whole numbers as well."""
    grid = read_chart(tiff(np.full((4, 5), 12, kind))).grid
    assert grid is not None and grid.depth_m.tolist() == [[12.0] * 5] * 4


def test_a_grid_of_heights_is_turned_and_says_so() -> None:
    """Protects: a chart of heights is no chart of depths; what was assumed is told."""
    found = read_chart(tiff(-SLOPE))
    assert found.grid is not None and found.grid.depth_m.min() == 5.0
    assert any("heights" in note for note in found.notes)
    assert read_chart(tiff(-SLOPE), Said(depths="up")).notes == ()


def test_a_grid_in_utm_is_turned_to_latitude_and_longitude() -> None:
    """Protects: a projected survey lies where it was sounded, to the cell."""
    to_utm = Transformer.from_crs(4326, 32632, always_xy=True)
    east, north = to_utm.transform(8.5, 47.5)
    found = read_chart(tiff(SLOPE, 2.0, (east, north), UTM32))
    assert found.grid is not None and found.grid.geographic and "EPSG:32632" in found.notes[1]
    x, y = east + 2.0 * 40.5, north - 2.0 * 30.5  # the middle of column 40, row 30
    longitude, latitude = to_utm.transform(x, y, direction="INVERSE")
    assert found.grid.at(np.array([latitude]), np.array([longitude]))[0] == pytest.approx(
        SLOPE[30, 40], abs=0.01
    )


def test_an_esri_grid_is_on_the_earth_unless_somebody_says_otherwise() -> None:
    """Protects: metres are not taken for degrees: what can't lie there is refused."""
    local = read_chart(ASC, Said(local=True)).grid
    assert local is not None and local.at(np.array([25.0]), np.array([25.0]))[0] == 4.0
    with pytest.raises(NotAChart, match="latitude"):
        read_chart(ASC.replace(b"yllcorner -50", b"yllcorner 5260000"))
    turned = read_chart(ASC.replace(b"-50", b"500000", 1).replace(b"-50", b"5260000"), Said(epsg=32632)).grid
    assert turned is not None and turned.geographic and turned.west == pytest.approx(9.0, abs=0.01)


def test_pictures_need_corners_unless_they_know_their_own() -> None:
    """Protects: a picture is drawn where it belongs or not at all."""
    found = read_chart(png(), Said(corners=CORNERS))
    assert found.kind == "picture" and found.picture.startswith(b"\x89PNG")
    assert found.corners is not None and found.corners[2] == (47.49, 8.51)
    own = read_chart(tiff(np.zeros((20, 30, 3), np.uint8)))
    assert own.corners is not None and own.corners[0] == pytest.approx((47.5, 8.5))
    assert own.corners[2] == pytest.approx((47.498, 8.503))
    assert "points" in read_chart(png(3000, 10), Said(corners=CORNERS)).notes[0]


@pytest.mark.parametrize(
    ("data", "said", "why"),
    [
        (b"", Said(), "empty"),
        (b"hello", Said(), "no kind"),
        (b"\x89MCAP0\r\n", Said(), "an MCAP log"),
        (b"version: 1\n", Said(), "no kind"),
        (b"QGC WPL 110\n", Said(), "WPL"),
        (b'{"fileType": "Plan", "mission": {}}', Said(), "no GeoJSON"),
        (b'{"type": "FeatureCollection", "features": []}', Said(), "no shape"),
        (b'{"type": "Point", "coordinates": [200, 95]}', Said(), "no latitude"),
        (b'{"type": "Point", "coordinates": ["a", 1]}', Said(), "not a number"),
        (b'{"type": "Polygon", "coordinates": [[1, 2]]}', Said(), "not a list"),
        (b"[" * 100_000, Said(), "JSON"),
        (json.dumps({"type": "MultiPoint", "coordinates": [[1, 2]] * 6000}).encode(), Said(), "more than"),
        (b'<!DOCTYPE kml [<!ENTITY a "a">]><kml>&a;</kml>', Said(), "document type"),
        (b"<html></html>", Said(), "a web page"),
        (b"PK\x03\x04nothing", Said(), "ZIP"),
        (png(), Said(), "four corners"),
        (png(), Said(corners="1,2;3,4"), "four corners"),
        (png(), Said(corners="1,1;2,2;3,3;4,4"), "one line"),
        (png(), Said(corners="nan,1;2,2;3,3;4,4"), "no places"),
        (png()[:60], Said(corners=CORNERS), "can't be read"),
        (png(5000, 5000), Said(corners=CORNERS), "more than"),
        (tiff(SLOPE, system=None), Said(), "does not say where"),
        (tiff(SLOPE, system=(3072, 1)), Said(), "nobody knows"),
        (tiff(SLOPE, system=(3072, 32767)), Said(), "EPSG"),
        (tiff(SLOPE, step=0.0), Said(), "without a size"),
        (tiff(np.full((3, 3), np.nan, np.float32)), Said(), "no depth at all"),
        (tiff(np.full((3, 3), 20_000.0, np.float32)), Said(), "metres"),
        (tiff(SLOPE)[:200], Said(), "can't be read"),
        (ASC.replace(b"9 4 9", b"9 9"), Said(local=True), "its head says"),
    ],
)
def test_what_is_no_chart_is_refused_with_the_reason(data: bytes, said: Said, why: str) -> None:
    """Protects: a person reads what the file is, and nothing of it is kept."""
    with pytest.raises(NotAChart, match=why):
        read_chart(data, said)


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(
    st.sampled_from([tiff(SLOPE), tiff(np.zeros((9, 9, 3), np.uint8)), png(), GEOJSON, KML, ASC]),
    st.lists(st.tuples(st.integers(0, 10_000), st.integers(0, 255)), min_size=1, max_size=12),
    st.booleans(),
)
def test_broken_bytes_are_refused_or_read_but_never_crash(
    data: bytes, changes: list[tuple[int, int]], local: bool
) -> None:
    """Protects: whatever a file holds, the reader ends with a chart or with a reason."""
    broken = bytearray(data)
    for at, byte in changes:
        broken[at % min(len(broken), 700)] = byte
    try:
        read_chart(bytes(broken), Said(corners=CORNERS, local=local))
    except NotAChart as error:
        assert str(error)
