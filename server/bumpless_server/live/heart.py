"""Says to the vehicle, as long as this server works, that a console is there, and who holds control too."""

import threading
from collections.abc import Callable

PERIOD_S = 0.5


class Heart(threading.Thread):
    """Calls `beat` twice a second until stopped."""

    def __init__(self, beat: Callable[[], None]) -> None:
        super().__init__(name="heart", daemon=True)
        self._beat = beat
        self._stopping = threading.Event()

    def run(self) -> None:
        """Until stopped."""
        self._beat()
        while not self._stopping.wait(PERIOD_S):
            self._beat()

    def stop(self) -> None:
        """End it and wait for that."""
        self._stopping.set()
        self.join()
