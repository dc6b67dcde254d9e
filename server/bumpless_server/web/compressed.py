"""Static files in the smallest form that the browser takes, when the build has put one beside them."""

import mimetypes
import os
from pathlib import Path
from typing import Any

from starlette.datastructures import Headers
from starlette.responses import FileResponse, Response
from starlette.staticfiles import NotModifiedResponse, StaticFiles
from starlette.types import Scope

ENCODINGS = (("br", ".br"), ("gzip", ".gz"))  # the smallest first


def accepted(header: str) -> set[str]:
    """The encodings that an Accept-Encoding header takes; `;q=0` refuses one.

    Source: RFC 9110, section 12.5.3.
    """
    taken = set()
    for part in header.lower().split(","):
        name, _, quality = part.partition(";")
        weight = quality.replace(" ", "").removeprefix("q=").rstrip("0").rstrip(".")
        if name.strip() and (not quality or weight not in ("", "0")):
            taken.add(name.strip())
    return taken


class Compressed(StaticFiles):
    """StaticFiles that prefers `name.br`, then `name.gz`. Each form has an ETag of its own."""

    def file_response(
        self, full_path: Any, stat_result: os.stat_result, scope: Scope, status_code: int = 200
    ) -> Response:
        """The file, compressed when it may be, or 304 when the browser has that very form."""
        headers = Headers(scope=scope)
        path, encoding = _form(Path(full_path), accepted(headers.get("accept-encoding", "")))
        response = FileResponse(
            path,
            status_code=status_code,
            stat_result=os.stat(path) if encoding else stat_result,
            media_type=mimetypes.guess_type(full_path)[0] or "application/octet-stream",
        )
        if encoding:
            response.headers["content-encoding"] = encoding
        if encoding or _form(Path(full_path), {name for name, _ in ENCODINGS})[1]:
            response.headers["vary"] = "Accept-Encoding"
        if self.is_not_modified(response.headers, headers):
            return NotModifiedResponse(response.headers)
        return response


def _form(path: Path, taken: set[str]) -> tuple[Path, str]:
    """The file to send and its encoding, "" for the file itself."""
    for name, ending in ENCODINGS:
        beside = path.with_name(path.name + ending)
        if name in taken and beside.is_file():
            return beside, name
    return path, ""
