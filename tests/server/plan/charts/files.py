"""Charts made for tests, in the formats that programs write."""

import io

import numpy as np
from PIL import Image, TiffImagePlugin

GEOGRAPHIC, UTM32 = (2048, 4326), (3072, 32632)
SLOPE = np.linspace(5.0, 20.0, 60 * 80).reshape(60, 80).astype(np.float32)
ASC = b"ncols 3\nnrows 3\nxllcorner -50\nyllcorner -50\ncellsize 50\n" + b"9 9 9\n9 4 9\n9 9 9\n"
GEOJSON = b"""{"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"name": "pier", "stroke": "#ff8800"},
  "geometry": {"type": "Polygon", "coordinates": [
   [[8.5, 47.5], [8.501, 47.5], [8.501, 47.501], [8.5, 47.5]],
   [[8.5002, 47.5002], [8.5004, 47.5002], [8.5004, 47.5003], [8.5002, 47.5002]]]}},
 {"type": "Feature", "properties": null,
  "geometry": {"type": "MultiPoint", "coordinates": [[8.5, 47.5], [8.6, 47.6]]}},
 {"type": "Feature", "properties": {}, "geometry": null},
 {"type": "LineString", "coordinates": [[8.5, 47.5, -3], [8.51, 47.5, -4]]}]}"""
KML = b"""<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document>
<Style id="red"><LineStyle><color>ff0000ff</color></LineStyle></Style>
<Placemark><name>reef</name><styleUrl>#red</styleUrl><Polygon>
 <innerBoundaryIs><LinearRing><coordinates>8.1,47.1 8.2,47.1 8.2,47.2</coordinates>
 </LinearRing></innerBoundaryIs>
 <outerBoundaryIs><LinearRing><coordinates>8,47,0 9,47,0 9,48,0 8,47,0</coordinates>
 </LinearRing></outerBoundaryIs>
</Polygon></Placemark>
<Placemark><name>buoy</name><Point><coordinates>8.5,47.5</coordinates></Point></Placemark>
<GroundOverlay><name>photo</name></GroundOverlay></Document></kml>"""


def tiff(
    values: np.ndarray,
    step: float = 1e-4,
    place: tuple[float, float] = (8.5, 47.5),
    system: tuple[int, int] | None = GEOGRAPHIC,
) -> bytes:
    """A GeoTIFF whose top left corner lies at `place`."""
    told = TiffImagePlugin.ImageFileDirectory_v2()
    tags = {33550: (step, step, 0.0), 33922: (0.0, 0.0, 0.0, *place, 0.0)} if system else {}
    for tag, numbers in tags.items():
        told.tagtype[tag] = 12
        told[tag] = numbers
    if system:
        told.tagtype[34735] = 3
        told[34735] = (1, 1, 0, 2, 1025, 0, 1, 1, system[0], 0, 1, system[1])
    told[42113] = "-9999"
    out = io.BytesIO()
    Image.fromarray(values).save(out, "TIFF", tiffinfo=told, compression="tiff_lzw")
    return out.getvalue()


def png(width: int = 40, height: int = 30) -> bytes:
    """A picture."""
    out = io.BytesIO()
    Image.new("RGB", (width, height), (20, 90, 160)).save(out, "PNG")
    return out.getvalue()
