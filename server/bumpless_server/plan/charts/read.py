"""A chart's bytes, whatever kind they are."""

import re

import numpy as np

from bumpless.chart import NotAGrid
from bumpless.chart.esri import read_esri
from bumpless.config.text import BOM, NotText, decoded, foreign_kind
from bumpless_server.plan.charts.content import Content, NotAChart, Said, corners_of
from bumpless_server.plan.charts.earth import WGS84, Place, known_system, turned
from bumpless_server.plan.charts.geotiff import read_geotiff
from bumpless_server.plan.charts.picture import BROKEN, as_png, opened
from bumpless_server.plan.charts.shapes import read_geojson, read_kml
from bumpless_server.plan.exchange.hostile import unpacked
from bumpless_server.plan.exchange.route import NotImportable

ESRI = "an ESRI ASCII grid"
_PICTURES = {b"\x89PNG": "PNG", b"\xff\xd8\xff": "JPEG", b"RIFF": "WEBP"}
_ESRI = re.compile(r"\s*(ncols|nrows)\s+\d", re.IGNORECASE)


def read_chart(data: bytes, said: Said = Said()) -> Content:  # noqa: B008 - it is frozen
    """What a chart's file holds, by what its bytes are. Raises NotAChart with the reason."""
    try:
        found = _read(data, said)
    except NotAChart:
        raise
    except (NotImportable, NotAGrid) as error:
        raise NotAChart(str(error)) from None
    except BROKEN as error:  # what readers of pictures make of broken tags is beyond telling apart
        raise NotAChart(f"can't be read: {error or type(error).__name__}") from None
    if found.kind == "features" and not found.features:
        raise NotAChart("holds no shape that could be drawn")
    return found


def _read(data: bytes, said: Said) -> Content:
    start = data[:4096].removeprefix(BOM.encode())
    if not data.strip():
        raise NotAChart("is empty")
    if start[:4] in (b"II*\x00", b"MM\x00*", b"II+\x00", b"MM\x00+"):
        return read_geotiff(data, said)
    for magic, kind in _PICTURES.items():
        if start.startswith(magic):
            return _picture(data, kind, said)
    if start.startswith(b"PK\x03\x04"):
        return read_kml(unpacked(data, ".kml")[1])
    if start.lstrip().startswith(b"<") and b"kml" in start.lower():
        return read_kml(data)
    if start.lstrip()[:1] in (b"{", b"["):
        return read_geojson(_text(data), said.local)
    if _ESRI.match(start.decode("latin-1")):
        return _esri(_text(data), said)
    kind = foreign_kind(data)
    if kind is not None:
        raise NotAChart(f"is {kind}, which is no chart")
    raise NotAChart("is of no kind that is known: GeoJSON, KML, GeoTIFF, ESRI ASCII grid, PNG, JPEG, WebP")


def _esri(text: str, said: Said) -> Content:
    turn = said.epsg is not None and said.epsg != WGS84 and not said.local
    grid = read_esri(text, not said.local and not turn, said.down)
    notes = [] if said.down is not None else ["its numbers were taken for depths or heights by their sign"]
    if turn:
        matrix = np.array([[grid.step_east, 0.0, grid.west], [0.0, -grid.step_north, grid.north]])
        grid, note = turned(grid.depth_m, Place(matrix, known_system(said.epsg or WGS84)))
        notes.append(note)
    return Content("depths", ESRI, grid.geographic, tuple(notes), grid=grid)


def _picture(data: bytes, kind: str, said: Said) -> Content:
    from PIL import ImageOps

    if not said.corners:
        raise NotAChart(f"is a {kind} picture: give its four corners")
    corners = corners_of(said)
    png, note = as_png(ImageOps.exif_transpose(opened(data, kind)))
    notes = (note,) if note else ()
    return Content("picture", f"a {kind} picture", not said.local, notes, picture=png, corners=corners)


def _text(data: bytes) -> str:
    try:
        return decoded(data, "").removeprefix(BOM)
    except NotText as error:
        raise NotAChart(error.problem.rule) from None
