"""One TCP connection: answered without delay, and closed when a request does not come whole in time."""

import asyncio
import socket
from collections.abc import Callable
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

HEAD_S = 10.0  # from the connection, or from the last answer, to a whole head
BODY_S = 30.0  # from the head to the end of the body: uploads are small
MOST = 400  # connections at once, browsers' streams among them

Note = Callable[[str, str], None]


def bounded_protocol(note: Note) -> type[H11Protocol]:
    """uvicorn's HTTP protocol with limits; `note(kind, example)` hears of who broke them."""

    class Bounded(H11Protocol):
        """Whoever holds a place without asking for anything loses it to the next who comes."""

        _timer: asyncio.TimerHandle | None = None
        _waits_for = ""

        def connection_made(self, transport: Any) -> None:
            """A place for it, else one is taken from the longest that asks for nothing."""
            super().connection_made(transport)
            plain = transport.get_extra_info("socket")
            if plain is not None and plain.family in (socket.AF_INET, socket.AF_INET6):
                # asyncio sets it only for sockets that say their protocol; without it each answer waits 44 ms
                plain.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            if len(self.connections) > MOST:
                idle = [
                    one for one in self.connections if isinstance(one, Bounded) and one._waits_for == "head"
                ]
                oldest = min(idle, key=lambda one: one._due, default=self)
                oldest._give_up(f"{MOST} connections are open")
            if not transport.is_closing():
                self._look()

        def data_received(self, data: bytes) -> None:
            """Bytes of a request, of any size."""
            super().data_received(data)
            self._look()

        def on_response_complete(self) -> None:
            """Ready for the next request."""
            super().on_response_complete()
            self._look()

        def handle_websocket_upgrade(self, event: h11.Request) -> None:
            """From here on the connection is the WebSocket's."""
            self._wait_for("")
            super().handle_websocket_upgrade(event)

        def connection_lost(self, exc: Exception | None) -> None:
            """Gone."""
            self._wait_for("")
            super().connection_lost(exc)

        @property
        def _due(self) -> float:
            return self._timer.when() if self._timer is not None else 0.0

        def _look(self) -> None:
            """What does it owe us?"""
            state = self.conn.their_state
            if self.transport.get_protocol() is not self or self.transport.is_closing():
                self._wait_for("")
            elif state is h11.IDLE:
                self._wait_for("head")
            else:
                self._wait_for("body" if state is h11.SEND_BODY else "")

        def _wait_for(self, what: str) -> None:
            if what == self._waits_for:
                return  # the time that was given runs on, however the bytes trickle
            if self._timer is not None:
                self._timer.cancel()
                self._timer = None
            self._waits_for = what
            if what:
                seconds = HEAD_S if what == "head" else BODY_S
                self._timer = self.loop.call_later(
                    seconds, self._give_up, f"no whole {what} in {seconds:g} s"
                )

        def _give_up(self, why: str) -> None:
            # a browser keeps connections that it may need: only what began and did not end is worth a word
            if self._waits_for == "body" or self.conn.trailing_data[0] or len(self.connections) > MOST:
                note("slow_request", f"{self.client[0] if self.client else 'somebody'}: {why}")
            self._wait_for("")
            self.transport.abort()

    return Bounded
