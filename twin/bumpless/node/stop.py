"""How a node's end is asked for."""

import threading

from bumpless.contract.exits import STOPPED


class Stop:
    """Ends the node, from any thread: the first call decides the reason and the exit code."""

    def __init__(self) -> None:
        self.event = threading.Event()
        self.reason = ""
        self.code = STOPPED

    def __call__(self, reason: str, code: int = STOPPED) -> None:
        if not self.event.is_set():
            self.reason, self.code = reason, code
            self.event.set()
