"""The recorder's clock, which stands until a test moves it."""

import pytest


class Clock:
    """Takes the place of the recorder's `time`; `now`: s."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 1000.0
        monkeypatch.setattr("bumpless_server.runs.recorder.time", self)

    def monotonic(self) -> float:
        """Seconds, as the test says."""
        return self.now
