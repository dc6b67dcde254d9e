"""The bytes of a file as text, or why they are none; what a file is that is no file of ours."""

import json
import re

from bumpless.config.plain import is_table
from bumpless.config.problems import Problem

BOM = "\ufeff"
_UTF16 = (b"\xff\xfe", b"\xfe\xff")

# How files begin that people take for a mission or a vehicle; the first that matches names them.
_KINDS = (
    (rb"PK\x03\x04", "a ZIP archive, as Neptus .nmis and .kmz files are"),
    (rb"\x89MCAP", "an MCAP log"),
    (rb"#ROSBAG", "a ROS bag"),
    (rb"%PDF", "a PDF document"),
    (rb"\x89PNG|\xff\xd8\xff", "a picture"),
    (rb"II\*\x00|MM\x00\*", "a TIFF image, as GeoTIFF files are"),
    (rb"\x1f\x8b", "a gzip archive"),
    (rb"\s*QGC\s+WPL", "a list of waypoints (WPL) of MAVLink ground stations"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)*<(\w+:)?kml\b", "a KML file"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)*<gpx\b", "a GPX track"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)*<(robot|sdf)\b", "a URDF or SDF model of a robot"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)*<mission-def\b", "a Neptus mission"),
    (rb"\s*(<!doctype html|<html)", "a web page"),
    (rb"\s*<\?xml", "an XML file"),
    (rb"(.*\n)?\s*Behavior\s*=\s*BHV_", "a MOOS-IvP behaviour file"),
    (rb"ncols\s+\d+\s+nrows\s", "an ESRI ASCII grid"),
)


class NotText(ValueError):
    """Bytes that are no UTF-8; `problem` says which."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        super().__init__(str(problem))


def foreign_kind(data: bytes | str) -> str | None:
    """What the file is, when it is of a known kind that is none of ours: "a QGroundControl plan"."""
    start = data[:4096] if isinstance(data, bytes) else data[:4096].encode("utf-8", "replace")
    start = start.removeprefix(BOM.encode())
    for pattern, kind in _KINDS:
        if re.match(pattern, start, re.IGNORECASE | re.DOTALL):
            return kind
    if start.lstrip()[:1] in (b"{", b"["):
        return _json_kind(data)
    return None


def _json_kind(data: bytes | str) -> str | None:
    try:
        tree = json.loads(data if isinstance(data, str) else data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        return None
    if not is_table(tree):
        return None
    if tree.get("fileType") == "Plan" or "groundStation" in tree:
        return "a QGroundControl plan"
    if tree.get("type") in ("FeatureCollection", "Feature", "GeometryCollection"):
        return "a GeoJSON file"
    return "a QGroundControl mission of the old form" if "plannedHomePosition" in tree else None


def decoded(data: bytes | str, source: str) -> str:
    """The text, exact to the byte (line ends and byte order mark kept): `text.encode()` gives `data` back.

    Raises NotText with file, line, column and byte offset of the first byte that is no UTF-8.
    """
    if isinstance(data, str):
        broken = re.search("[\ud800-\udfff]", data)
        if broken is None:
            return data
        rule = "holds half of a character (a surrogate), which no text may"
        raise NotText(Problem(source, *_place(data[: broken.start()]), "", None, rule))
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        before = data[: error.start].decode("utf-8")
        reason = f"is not UTF-8 text: byte 0x{data[error.start]:02x} at offset {error.start}"
    if data.startswith(_UTF16):
        reason += "; it looks like UTF-16, save it as UTF-8"
    elif _is_latin(data):
        reason += "; it looks like Latin-1, save it as UTF-8"
    raise NotText(Problem(source, *_place(before), "", None, reason))


def _is_latin(data: bytes) -> bool:
    """Whether the bytes beyond ASCII stand alone, as letters of Western Europe do."""
    return bool(re.fullmatch(rb"(?:[\x09\x0a\x0d\x20-\x7e]|[\xa0-\xff](?![\x80-\xbf]))*", data))


def _place(before: str) -> tuple[int, int]:
    """Line and column, from 1, of what follows; a line ends with LF, CR LF or CR."""
    lines = re.split(r"\r\n|\r|\n", before.removeprefix(BOM))
    return len(lines), len(lines[-1]) + 1
