"""The console's page and its files; a friendly word when it has not been built."""

from pathlib import Path
from urllib.parse import urlsplit

from fastapi import FastAPI
from fastapi.responses import FileResponse, HTMLResponse, Response

from bumpless_server.web.compressed import Compressed

LOGIN = "login.html"
POLICY = "default-src 'self'; base-uri 'none'; form-action 'self'; object-src 'none'; frame-ancestors 'self'"
PACKAGE = Path(__file__).parents[2]
NOT_BUILT = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Bumpless</title>
<body style="font:16px/1.5 system-ui;max-width:40rem;margin:15vh auto;padding:0 1rem">
<h1>Bumpless</h1><p>The server runs, but the console's page has not been built.</p>
<p>From a checkout: <code>make run</code> builds it. The interface itself answers at
<a href="/api/status">/api/status</a>.</p></body></html>"""


def static_folder() -> Path | None:
    """The built page: of the source tree when there is one, else of the installed package."""
    folders = (PACKAGE.parents[1] / "console_web" / "dist", PACKAGE / "static")
    return next((folder for folder in folders if (folder / "index.html").is_file()), None)


class Page(Compressed):
    """Static files that a browser asks for anew when their name has no content hash."""

    def __init__(self, directory: Path, html: bool = True, policy: str = POLICY) -> None:
        super().__init__(directory=directory, html=html)
        self._policy = policy

    def file_response(self, full_path, *args, **kwargs) -> Response:  # type: ignore[no-untyped-def]
        response = super().file_response(full_path, *args, **kwargs)
        hashed = Path(full_path).parent.name == "assets"
        response.headers["content-security-policy"] = self._policy
        response.headers["cache-control"] = "public, max-age=31536000, immutable" if hashed else "no-cache"
        return response


def policy_of(tiles: str) -> str:
    """What the page may load: its own, and pictures of the one server of the base map's tiles, if any."""
    if not tiles:
        return POLICY
    at = urlsplit(tiles)
    return f"{POLICY}; img-src 'self' {at.scheme}://{at.netloc.split('@')[-1]}"


def mount(app: FastAPI, tiles: str = "") -> None:
    """Serve the page at /. Call last: it takes every path that is left. `tiles`: address of a base map's."""
    folder = static_folder()
    if folder is not None and (folder / LOGIN).is_file():

        @app.get("/login", include_in_schema=False)
        def login() -> FileResponse:
            headers = {"content-security-policy": POLICY, "cache-control": "no-cache"}
            return FileResponse(folder / LOGIN, headers=headers)

    if folder is not None:
        app.mount("/", Page(folder, policy=policy_of(tiles)), name="console")
        return

    @app.get("/", include_in_schema=False)
    def not_built() -> HTMLResponse:
        return HTMLResponse(NOT_BUILT)
