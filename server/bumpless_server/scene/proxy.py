"""The scene behind our own origin: the page at /scene/ and viser's websocket at /scene.

A tab that names itself, /scene/TAB/ and /scene/TAB, has a camera of its own.

Only a browser that holds our session cookie, on a page of our own origin, gets through.
"""

import asyncio
import contextlib
from collections.abc import Callable
from typing import Annotated, Literal
from urllib.parse import urlsplit

from fastapi import APIRouter, HTTPException, Request, WebSocket
from fastapi.responses import HTMLResponse
from pydantic import BaseModel, StringConstraints
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, WebSocketException

from bumpless_server.scene.cameras import Cameras
from bumpless_server.scene.guard import SECRET_HEADER, SESSION_HEADER
from bumpless_server.scene.page import POLICY, page_html

Tab = Annotated[str, StringConstraints(pattern=r"^[0-9a-z]{0,32}$")]
View = Literal["follow", "overview", "top", "target"]
SessionOf = Callable[[Request | WebSocket], str | None]
NO_SCENE, REFUSED = 1013, 1008  # websocket close codes: try again later, policy violation


class CameraRequest(BaseModel):
    """Which preset the caller's own cameras take."""

    view: View
    tab: Tab = ""


class CameraAnswer(BaseModel):
    """How many of the caller's tabs moved."""

    view: View
    viewers: int


class RulerRequest(BaseModel):
    """Whether the ruler lies out in the caller's own picture."""

    on: bool
    tab: Tab = ""


class RulerAnswer(BaseModel):
    """In how many of the caller's tabs it was laid down or taken away."""

    on: bool
    viewers: int


class Proxy:
    """Routes of the scene. `session_of(request)` gives the caller's valid session or None."""

    def __init__(self, session_of: SessionOf, cameras: Cameras) -> None:
        self.session_of, self.cameras = session_of, cameras
        self.inner: tuple[str, str] | None = None  # viser's address and secret while it runs
        self.router = APIRouter()
        self.router.add_api_route("/scene/", self.page, methods=["GET"], include_in_schema=False)
        self.router.add_api_route("/scene/{tab}/", self.page, methods=["GET"], include_in_schema=False)
        self.router.add_api_websocket_route("/scene", self.socket)
        self.router.add_api_websocket_route("/scene/{tab}", self.socket)
        self.router.add_api_route("/api/scene/camera", self.camera, methods=["POST"])
        self.router.add_api_route("/api/scene/ruler", self.ruler, methods=["POST"])

    async def page(self, request: Request) -> HTMLResponse:
        """viser's client, made ours. 401 without a session."""
        if self.session_of(request) is None:
            raise HTTPException(401, "no session: open the console first")
        headers = {
            "Content-Security-Policy": POLICY,
            "Cache-Control": "no-cache",
            "X-Content-Type-Options": "nosniff",
        }
        return HTMLResponse(await asyncio.to_thread(page_html), headers=headers)

    async def camera(self, request: Request, body: CameraRequest) -> CameraAnswer:
        """Move the caller's own cameras to a preset; says how many browsers moved."""
        session = self._own(request)
        moved = await asyncio.to_thread(self.cameras.set_view, viewer(session, body.tab), body.view)
        return CameraAnswer(view=body.view, viewers=moved)

    async def ruler(self, request: Request, body: RulerRequest) -> RulerAnswer:
        """Lay the ruler down in the caller's own picture, or take it away."""
        session = self._own(request)
        laid = await asyncio.to_thread(self.cameras.set_ruler, viewer(session, body.tab), body.on)
        return RulerAnswer(on=body.on, viewers=laid)

    def _own(self, request: Request) -> str:
        """The caller's session, on a page of ours."""
        session = self.session_of(request)
        if session is None or not same_origin(request):
            raise HTTPException(403, "only the console's own page may change its picture")
        return session

    async def socket(self, outer: WebSocket) -> None:
        """Carry frames both ways between the browser and viser."""
        session = self.session_of(outer)
        if session is None or not same_origin(outer, required=True):
            return await outer.close(REFUSED)
        if self.inner is None:
            return await outer.close(NO_SCENE)
        address, secret = self.inner
        tab = outer.path_params.get("tab", "")[:32]
        protocols = [p for p in outer.scope.get("subprotocols", []) if p.startswith("viser-v")][:1]
        try:
            async with connect(
                address,
                subprotocols=protocols or None,
                additional_headers={SECRET_HEADER: secret, SESSION_HEADER: viewer(session, tab)},
                compression=None,
                max_size=None,
                close_timeout=1,
                proxy=None,
            ) as inner:
                await outer.accept(subprotocol=inner.subprotocol)
                await _relay(outer, inner)
        except (OSError, WebSocketException):
            with contextlib.suppress(RuntimeError):
                await outer.close(NO_SCENE)


def viewer(session: str, tab: str) -> str:
    """Who looks: a browser's session, or one tab of it."""
    return f"{session}/{tab}" if tab.isalnum() and tab.isascii() else session


def same_origin(request: Request | WebSocket, required: bool = False) -> bool:
    """The Origin header names the host that was asked; an absent one passes unless required."""
    origin = request.headers.get("origin")
    if origin is None:
        return not required
    return urlsplit(origin).netloc == request.headers.get("host")


async def _relay(outer: WebSocket, inner: object) -> None:
    async def down() -> None:
        with contextlib.suppress(ConnectionClosed):
            async for message in inner:  # type: ignore[attr-defined]
                await outer.send_bytes(message)
        code = inner.close_code  # type: ignore[attr-defined]
        await outer.close(code if code in (1000, 1001, 1002) else NO_SCENE)

    async def up() -> None:
        while (message := await outer.receive())["type"] != "websocket.disconnect":
            data = message.get("bytes")
            await inner.send(data if data is not None else message["text"])  # type: ignore[attr-defined]

    tasks = [asyncio.create_task(down()), asyncio.create_task(up())]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
