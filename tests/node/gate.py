"""A door in a link: TCP to an address passes only once it has been opened."""

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Gate:
    """Takes connections at `port` at once; what they say waits for `open` and goes to `target` then."""

    def __init__(self, target: int) -> None:
        self._target = target
        self._opened = threading.Event()
        self._sockets: list[socket.socket] = []
        self._door = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._door.getsockname()[1]
        threading.Thread(target=self._take, daemon=True).start()

    def open(self) -> None:
        """Let everything through, now and from now on."""
        self._opened.set()

    def close(self) -> None:
        """Cut every connection."""
        self._opened.set()
        for one in (self._door, *self._sockets):
            one.close()

    def _take(self) -> None:
        while True:
            try:
                near, _ = self._door.accept()
            except OSError:
                return
            self._sockets.append(near)
            threading.Thread(target=self._join, args=(near,), daemon=True).start()

    def _join(self, near: socket.socket) -> None:
        self._opened.wait()
        try:
            far = socket.create_connection(("127.0.0.1", self._target))
        except OSError:
            near.close()
            return
        self._sockets.append(far)
        threading.Thread(target=_pass_on, args=(far, near), daemon=True).start()
        _pass_on(near, far)


def _pass_on(source: socket.socket, sink: socket.socket) -> None:
    try:
        while data := source.recv(65536):
            sink.sendall(data)
        sink.shutdown(socket.SHUT_WR)
    except OSError:
        return


@contextmanager
def gate(target: int) -> Iterator[Gate]:
    """A closed gate before port `target` of loopback."""
    door = Gate(target)
    try:
        yield door
    finally:
        door.close()
