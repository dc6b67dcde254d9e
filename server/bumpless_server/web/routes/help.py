"""The docs as the console's Help at /help/: the built site, or a friendly word when there is none."""

from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import HTMLResponse, RedirectResponse, Response
from fastapi.staticfiles import StaticFiles
from starlette.types import Scope

FOLDER = Path(__file__).parents[2] / "help"
POLICY = "policy.txt"  # beside the pages: what their theme's inline script needs, see docs/build.py
NOT_BUILT = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Bumpless Help</title>
<body style="font:16px/1.5 system-ui;max-width:40rem;margin:15vh auto;padding:0 1rem">
<h1>Help</h1><p>The help pages have not been built on this machine.</p>
<p>From a checkout: <code>make docs</code> builds them. Their text is in the folder <code>docs/</code>.</p>
<p><a href="/">Back to the console</a></p></body></html>"""


class HelpPages(StaticFiles):
    """The site's files under its own policy. Sphinx adds ?v=HASH to what may be kept for ever."""

    def __init__(self, folder: Path) -> None:
        super().__init__(directory=folder, html=True)
        self._policy = (folder / POLICY).read_text(encoding="utf-8")

    async def get_response(self, path: str, scope: Scope) -> Response:
        """One file, with policy and caching."""
        response = await super().get_response(path, scope)
        response.headers["content-security-policy"] = self._policy
        kept = response.status_code == 200 and scope["query_string"].startswith(b"v=")
        response.headers["cache-control"] = "public, max-age=31536000, immutable" if kept else "no-cache"
        return response


def mount(app: FastAPI, folder: Path = FOLDER) -> None:
    """Serve the help at /help/."""

    @app.get("/help", include_in_schema=False)
    def slash() -> RedirectResponse:
        return RedirectResponse("/help/", 308)

    if (folder / POLICY).is_file():
        app.mount("/help", HelpPages(folder), name="help")
        return

    @app.get("/help/", include_in_schema=False)
    def not_built() -> HTMLResponse:
        return HTMLResponse(NOT_BUILT)
