"""The scene behind the server's real guard, on a real port, fed with contract messages."""

import contextlib
import socket
import threading
from collections.abc import AsyncIterator, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import uvicorn
from fastapi import FastAPI
from fastapi.responses import HTMLResponse
from google.protobuf.message import Message

from bumpless_server.access.accounts import Accounts
from bumpless_server.access.lease import Lease
from bumpless_server.access.sessions import Sessions
from bumpless_server.live.sample import Sample
from bumpless_server.live.state import State
from bumpless_server.scene.scene import Scene
from bumpless_server.settings import load_settings
from bumpless_server.web.auth import Auth, session_cookie
from bumpless_server.web.guard import Guard
from bumpless_server.web.guesses import Guesses


@dataclass
class Served:
    """A scene that runs."""

    scene: Scene
    state: State
    origin: str

    def tell(self, topic: str, message: Message) -> None:
        """A message as the bus would bring it."""
        self.state.feed(Sample(f"tlm/{topic}", message.DESCRIPTOR.full_name, message.SerializeToString()))


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config) -> None:
        super().__init__(config)
        self.ready = threading.Event()

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self.ready.set()


@contextlib.contextmanager
def serve(**options: Any) -> Iterator[Served]:
    """Scene, guard and an empty console page at /, until the block ends."""
    state = State("ts100")
    scene = Scene(state, session_cookie, **options)

    @contextlib.asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        await scene.start()
        yield
        await scene.stop()

    app = FastAPI(lifespan=lifespan)
    app.include_router(scene.router)
    app.add_api_route("/", lambda: HTMLResponse("<title>console</title>"), response_class=HTMLResponse)
    accounts = Accounts(Path("nowhere"))
    auth = Auth(load_settings(), b"test", accounts, Sessions(Path("nowhere"), accounts, 1.0))
    lease = Lease(lambda _: None, lambda *_: None)
    guarded = Guard(app, auth, Guesses(lambda *_: None), lease)
    config = uvicorn.Config(
        guarded, port=0, log_level="warning", ws_per_message_deflate=False, timeout_graceful_shutdown=2
    )
    server = _Server(config)
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        thread = threading.Thread(target=server.run, args=([listening],), name="scene-test-server")
        thread.start()
        try:
            if not server.ready.wait(60):
                raise RuntimeError("the scene did not start")
            yield Served(scene, state, f"http://127.0.0.1:{listening.getsockname()[1]}")
        finally:
            server.should_exit = True
            thread.join(20)
