"""GeoTIFF: depths in one band, or a picture, with its place on the earth.

Pixels are read by Pillow, coordinates turned by pyproj. Source: OGC 19-008r4, GeoTIFF 1.1.
"""

from typing import Any

import numpy as np

from bumpless.chart import DepthGrid
from bumpless.chart.esri import as_depths
from bumpless_server.plan.charts.content import Content, Corners, NotAChart, Said, corners_of
from bumpless_server.plan.charts.earth import WGS84, Place, known_system, on_earth, turned
from bumpless_server.plan.charts.picture import as_png, opened

FORMAT = "a GeoTIFF"
_SCALE, _TIE, _MATRIX, _KEYS, _NOTHING = 33550, 33922, 34264, 34735, 42113  # tags
_MODEL, _RASTER, _GEOGRAPHIC, _PROJECTED = 1024, 1025, 2048, 3072  # keys
_AREA, _OWN = 1, 32767
_MANY_BITS = ("F", "I")  # Pillow's modes with more than 8 bits


def read_geotiff(data: bytes, said: Said) -> Content:
    """The chart in a TIFF. Raises NotAChart."""
    image = opened(data, "TIFF")
    notes = list[str]()
    deep = image.mode.split(";")[0] in _MANY_BITS or (image.mode == "L" and said.depths != "")
    place = _place(image, said)
    if not deep:
        return _picture(image, place, said, notes)
    if place is None:
        raise NotAChart("is a TIFF with one band, but does not say where on the earth it lies")
    return _depths(image, place, said, notes)


def _picture(image: Any, place: Place | None, said: Said, notes: list[str]) -> Content:
    width, height = image.size
    if said.corners:
        corners, geographic = corners_of(said), not said.local
    elif place is None:
        raise NotAChart("is a TIFF picture that does not say where it lies: give its corners")
    else:
        columns = np.array([-0.5, width - 0.5, width - 0.5, -0.5])
        rows = np.array([-0.5, -0.5, height - 0.5, height - 0.5])
        x, y = on_earth(*place.xy(columns, rows), place.epsg)
        corners, geographic = _four(y, x), place.epsg is not None
    png, note = as_png(image)
    notes += [note] if note else []
    return Content("picture", FORMAT, geographic, tuple(notes), picture=png, corners=corners)


def _four(first: np.ndarray, second: np.ndarray) -> Corners:
    a, b, c, d = ((float(p), float(q)) for p, q in zip(first, second, strict=True))
    return a, b, c, d


def _depths(image: Any, place: Place, said: Said, notes: list[str]) -> Content:
    values = np.array(image, np.float64)
    nothing = _number(image.tag_v2.get(_NOTHING))
    if nothing is not None:
        values[values == nothing] = np.nan
    values[np.abs(values) > 1e6] = np.nan  # what programs write for "nothing"
    depths = as_depths(values, said.down)
    if said.down is None:
        notes.append(
            "its numbers are taken for "
            + ("depths" if np.array_equal(depths, values.astype(np.float32), equal_nan=True) else "heights")
        )
    m = place.matrix
    straight = m[0, 1] == 0.0 == m[1, 0] and m[0, 0] > 0.0 > m[1, 1]
    if straight and place.epsg in (None, WGS84):
        grid = DepthGrid(depths, m[1, 2], m[0, 2], -m[1, 1], m[0, 0], place.epsg is not None)
    else:
        grid, note = turned(depths, place)
        notes.append(note)
    return Content("depths", FORMAT, grid.geographic, tuple(notes), grid=grid)


def _place(image: Any, said: Said) -> Place | None:
    """Where the pixels lie; None where the file does not say."""
    tags = image.tag_v2
    keys = _keys(tags.get(_KEYS))
    matrix = _matrix(tags)
    if matrix is None:
        return None
    if keys.get(_RASTER, _AREA) == _AREA:  # the tie point is a pixel's corner
        matrix = matrix @ np.array([[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, 0.0, 1.0]])
    if not np.isfinite(matrix).all() or abs(np.linalg.det(matrix[:, :2])) < 1e-30:
        raise NotAChart("has pixels without a size")
    if said.local:
        return Place(matrix, None)
    return Place(matrix, _system(keys) if said.epsg is None else known_system(said.epsg))


def _matrix(tags: Any) -> np.ndarray | None:
    whole, scale, tie = tags.get(_MATRIX), tags.get(_SCALE), tags.get(_TIE)
    try:
        if whole is not None:
            m = np.array(whole, np.float64).reshape(4, 4)
            return m[:2][:, [0, 1, 3]]
        if scale is None or tie is None:
            return None
        (sx, sy), t = np.array(scale[:2], np.float64), np.array(tie[:6], np.float64)
        return np.array([[sx, 0.0, t[3] - sx * t[0]], [0.0, -sy, t[4] + sy * t[1]]])
    except (ValueError, TypeError, IndexError):
        raise NotAChart("has a place on the earth that can't be read") from None


def _keys(directory: Any) -> dict[int, int]:
    """Key -> short value. Source: GeoTIFF 1.1, 7.1.2."""
    words = list(directory) if isinstance(directory, tuple | list) else []
    if not all(isinstance(word, int) for word in words):
        return {}
    return {words[k]: words[k + 3] for k in range(4, len(words) - 3, 4) if words[k + 1] == 0}


def _system(keys: dict[int, int]) -> int:
    """The EPSG code of the system that x and y are in. Raises NotAChart."""
    code = keys.get(_PROJECTED, keys.get(_GEOGRAPHIC))
    if code is None and not keys:
        raise NotAChart("says no coordinate system; where its numbers are metres of missions, say so (local)")
    if code is None or code == _OWN:
        raise NotAChart("has a coordinate system of its own: save it in one with an EPSG code")
    return known_system(code)


def _number(value: Any) -> float | None:
    text = value.decode("latin-1") if isinstance(value, bytes) else str(value) if value is not None else ""
    try:
        return float(text.strip("\x00 "))
    except ValueError:
        return None
