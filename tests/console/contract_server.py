"""A server that speaks the console's HTTP and WebSocket contract and says only what a test tells it.

The console's own tests need states that a healthy server never shows: a lost link, a vehicle that
refuses, a reply without a confirmation. Frames are pushed one by one, so nothing waits for a clock.
"""

import asyncio
import json
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import uvicorn
from google.protobuf.message import Message
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket, WebSocketDisconnect

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.routes.page import static_folder

POLICY = "default-src 'self'"
NOW_NS = 1_770_000_000_000_000_000
BEAT_S = 0.05
PATIENCE_S = 30.0
SCENE = "<!doctype html><title>scene</title><body style='margin:0;background:#123'></body>"


Messages = Iterable[tuple[str, Message]]
Foresee = Callable[[dict[str, Any]], Iterable[dict[str, Any]]]


@dataclass
class Call:
    """One request that the console made."""

    method: str
    path: str
    query: str
    body: str

    def json(self) -> Any:
        """The body as JSON."""
        return json.loads(self.body)


@dataclass
class ContractServer:
    """Runs in a thread of its own; every public method may be called from the test's thread."""

    replies: dict[tuple[str, str], tuple[int, Any]] = field(default_factory=dict)
    calls: list[Call] = field(default_factory=list)
    port: int = 0

    def __post_init__(self) -> None:
        folder = static_folder()
        assert folder is not None, "the console is not built: make build"
        self.console: Path = folder
        self._steady: list[tuple[str, Message]] = []
        self._last: dict[str, pb.StreamMessage] = {}
        self._sockets: dict[WebSocket, asyncio.Queue[bytes]] = {}
        self._called = threading.Condition()
        self.foresee: Foresee = lambda _: []
        self._held: dict[tuple[str, str], threading.Event] = {}
        self.start()

    @property
    def url(self) -> str:
        """Address of the console."""
        return f"http://127.0.0.1:{self.port}/"

    def start(self) -> None:
        """Listen; after a stop, on the same port again."""
        self._loop = asyncio.new_event_loop()
        ready = threading.Event()
        config = uvicorn.Config(
            self._app(), host="127.0.0.1", port=self.port, log_level="error", lifespan="off"
        )
        config.timeout_graceful_shutdown = 1
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._serve, args=(ready,), daemon=True)
        self._thread.start()
        assert ready.wait(20), "the contract server did not start"

    def _serve(self, ready: threading.Event) -> None:
        asyncio.set_event_loop(self._loop)

        async def main() -> None:
            startup = self._server.startup

            async def noted_startup(sockets: Any = None) -> None:
                await startup(sockets)
                self.port = self._server.servers[0].sockets[0].getsockname()[1]
                self._beat()
                ready.set()

            self._server.startup = noted_startup
            await self._server._serve()

        self._loop.run_until_complete(main())
        self._loop.close()

    def stop(self) -> None:
        """Go away as a killed server does: sockets end, the port refuses."""
        self._loop.call_soon_threadsafe(setattr, self._server, "should_exit", True)
        self._server.force_exit = True
        self._thread.join(20)
        assert not self._thread.is_alive()
        self._sockets.clear()

    def reply(self, method: str, path: str, body: Any, status: int = 200) -> None:
        """What to answer from now on to `method` of `path` (without the leading "/api/")."""
        self.replies[(method, path)] = (status, body)

    def hold(self, method: str, path: str) -> threading.Event:
        """Keep answers to `method` of `path` back until the event is set."""
        return self._held.setdefault((method, path), threading.Event())

    def say(self, messages: Messages, age_s: float = 0.0, past: bool = False) -> None:
        """Push one frame to every browser; `age_s`: how long ago the server received these messages."""
        said = list(messages)
        self._loop.call_soon_threadsafe(self._push, said, age_s, past)

    def keep_saying(self, messages: Messages) -> None:
        """Push these at 20 Hz from now on, as a vehicle does that does not change."""
        self.say(messages)
        self._steady = list(messages)

    def _beat(self) -> None:
        if self._steady:
            self._push(self._steady, 0.0)
        self._loop.call_later(BEAT_S, self._beat)

    def _push(self, messages: Messages, age_s: float, past: bool = False) -> None:
        frame = pb.StreamFrame(server_time_ns=NOW_NS, past=past)
        for topic, message in messages:
            frame.messages.add(
                topic=topic,
                schema=message.DESCRIPTOR.full_name,
                payload=message.SerializeToString(),
                receive_time_ns=NOW_NS - round(age_s * 1e9),
            )
        for message in frame.messages:
            self._last[message.topic] = message
        data = frame.SerializeToString()
        for queue in self._sockets.values():
            queue.put_nowait(data)

    def calls_of(self, method: str, path: str) -> list[Call]:
        """The requests of this kind so far, in order."""
        with self._called:
            return [call for call in self.calls if (call.method, call.path) == (method, path)]

    def wait_for_call(self, method: str, path: str, count: int = 1, timeout_s: float = PATIENCE_S) -> Call:
        """The `count`-th request of this kind, when it has come."""
        with self._called:
            came = self._called.wait_for(lambda: len(self.calls_of(method, path)) >= count, timeout_s)
        assert came, f"no {method} {path}"
        return self.calls_of(method, path)[count - 1]

    async def _answer(self, request: Request) -> Response:
        path = request.path_params["path"]
        call = Call(request.method, path, request.url.query, (await request.body()).decode())
        with self._called:
            self.calls.append(call)
            self._called.notify_all()
        if held := self._held.get((request.method, path)):
            await asyncio.to_thread(held.wait, PATIENCE_S)
        status, body = self.replies.get((request.method, path), (404, {"detail": f"nothing at {path}"}))
        if isinstance(body, bytes):
            return Response(body, status, media_type="application/octet-stream")
        return JSONResponse(body, status)

    async def _foresight(self, socket: WebSocket) -> None:
        await socket.accept()
        try:
            while True:
                request = json.loads(await socket.receive_text())
                for answer in self.foresee(request):
                    await socket.send_text(json.dumps({"id": request["id"], **answer}))
        except WebSocketDisconnect:
            pass

    async def _stream(self, socket: WebSocket) -> None:
        await socket.accept()
        queue: asyncio.Queue[bytes] = asyncio.Queue()
        frame = pb.StreamFrame(server_time_ns=NOW_NS, messages=self._last.values())
        queue.put_nowait(frame.SerializeToString())
        self._sockets[socket] = queue
        sender = asyncio.create_task(_send_all(socket, queue))
        try:
            await socket.receive()
        except WebSocketDisconnect:
            pass
        finally:
            sender.cancel()
            self._sockets.pop(socket, None)

    def _app(self) -> Starlette:
        async def scene(_: Request) -> Response:
            return HTMLResponse(SCENE)

        async def page(_: Request) -> Response:
            return HTMLResponse(
                (self.console / "index.html").read_text(), headers={"content-security-policy": POLICY}
            )

        return Starlette(
            routes=[
                WebSocketRoute("/api/stream", self._stream),
                WebSocketRoute("/ws/foresight", self._foresight),
                Route("/api/{path:path}", self._answer, methods=["GET", "POST", "PUT", "DELETE"]),
                Route("/scene/{tab}/", scene),
                Route("/", page),
                Mount("/", StaticFiles(directory=self.console)),
            ]
        )


async def _send_all(socket: WebSocket, queue: "asyncio.Queue[bytes]") -> None:
    while True:
        await socket.send_bytes(await queue.get())
