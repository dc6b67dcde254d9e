"""A link that can be cut and joined again: TCP to an address passes, or it doesn't."""

import contextlib
import socket
import threading
from collections.abc import Iterator


class Cut:
    """Passes on what comes to `port` to `target`, a port of loopback, while it is not cut."""

    def __init__(self, target: int) -> None:
        self._target, self._is_cut = target, False
        self._sockets: list[socket.socket] = []
        self._door = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._door.getsockname()[1]
        threading.Thread(target=self._take, daemon=True).start()

    def cut(self, silently: bool = False) -> None:
        """Every connection ends, and none is taken. `silently`: they stay, and swallow what is said."""
        self._is_cut = True
        if silently:
            return
        for one in self._sockets:
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
        self._sockets.clear()

    def join(self) -> None:
        """Connections are taken again; those of before are of no use any more."""
        self.cut()
        self._is_cut = False

    def close(self) -> None:
        """For good."""
        self.cut()
        self._door.close()

    def _take(self) -> None:
        while True:
            try:
                near, _ = self._door.accept()
            except OSError:
                return
            try:
                if self._is_cut:
                    raise OSError
                far = socket.create_connection(("127.0.0.1", self._target))
            except OSError:
                near.close()
                continue
            self._sockets += [near, far]
            for source, sink in ((near, far), (far, near)):
                threading.Thread(target=self._pass_on, args=(source, sink), daemon=True).start()

    def _pass_on(self, source: socket.socket, sink: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while data := source.recv(65536):
                if not self._is_cut:
                    sink.sendall(data)
        for one in (source, sink):
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)


@contextlib.contextmanager
def cuttable(target: int) -> Iterator[Cut]:
    """A link to this port, not cut."""
    link = Cut(target)
    try:
        yield link
    finally:
        link.close()
