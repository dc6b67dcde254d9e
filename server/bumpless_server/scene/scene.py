"""The 3-D scene as the server uses it: a router, start and stop."""

import asyncio
import logging
from collections.abc import Callable
from typing import Any

from fastapi import APIRouter, Request, WebSocket

from bumpless_server.scene.attainable import AttainableSets, Sets, sets_of
from bumpless_server.scene.cameras import Cameras
from bumpless_server.scene.finite import Finite
from bumpless_server.scene.ghosts import Ghosts
from bumpless_server.scene.held_ring import Held
from bumpless_server.scene.proxy import Proxy
from bumpless_server.scene.trail import Track

log = logging.getLogger(__name__)


def parse(text: str) -> Any:
    """The vehicle file a vehicle carries in its description."""
    from bumpless.config.vehicle import parse_vehicle

    return parse_vehicle(text, "description")


class Scene:
    """viser behind our origin, fed from `state`.

    `session_of(request)` gives the session of a request or websocket, or None to refuse it.
    `light` draws fewer polygons, for browsers without a GPU.
    `holds()`: on which headings station is held now.
    """

    def __init__(
        self,
        state: Any,
        session_of: Callable[[Request | WebSocket], str | None],
        light: bool = False,
        make_sets: Callable[[Any], Callable[[float], Sets]] = sets_of,
        ghosts: Ghosts | None = None,
        holds: Callable[[], Held | None] = lambda: None,
    ) -> None:
        self._ghosts, self._holds = ghosts, holds
        self._state, self._light, self._make_sets = Finite(state), light, make_sets
        self.cameras = Cameras()
        self.proxy = Proxy(session_of, self.cameras)
        self.viser: Any = None
        self.live: Any = None
        self._sets: AttainableSets | None = None

    @property
    def router(self) -> APIRouter:
        """Routes /scene/, /scene and /api/scene."""
        return self.proxy.router

    async def start(self) -> None:
        """Start viser and the update loop."""
        await asyncio.to_thread(self._start)

    async def stop(self) -> None:
        """Stop both; leaves no thread."""
        self.proxy.inner = None
        await asyncio.to_thread(self._stop)

    def _start(self) -> None:
        from bumpless_server.scene.cameras import FOV_RAD, placed
        from bumpless_server.scene.guard import SESSION, start_viser
        from bumpless_server.scene.live import Live
        from bumpless_server.scene.picture import Picture
        from bumpless_server.scene.places import Places

        server, secret = start_viser()
        server.gui.configure_theme(dark_mode=False, show_logo=False, show_share_button=False)
        position, aim = placed("follow", Places())
        server.initial_camera.position, server.initial_camera.look_at = position, aim
        server.initial_camera.fov = FOV_RAD
        track, sets = Track(), AttainableSets(self._make_sets)
        live = Live(
            self._state,
            self.cameras,
            track,
            lambda: Picture(self._state, server, track, sets, parse, self._light, self._ghosts, self._holds),
        )

        async def joined(client: Any) -> None:
            self.cameras.join(client, SESSION.get())
            live.wake()

        async def left(client: Any) -> None:
            self.cameras.leave(client)

        server.on_client_connect(joined)
        server.on_client_disconnect(left)
        live.start()
        self.viser, self.live, self._sets = server, live, sets
        self.proxy.inner = (f"ws://127.0.0.1:{server.get_port()}", secret)

    def _stop(self) -> None:
        from bumpless_server.scene.guard import stop_viser

        if self.live is not None:
            self.live.stop()
        if self.viser is not None:
            stop_viser(self.viser)
        if self._sets is not None:
            self._sets.stop()
        self.viser = self.live = self._sets = None
