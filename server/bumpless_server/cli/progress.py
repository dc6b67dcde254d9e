"""How far it is, on stderr: a bar that a terminal keeps rewriting; nothing when nobody watches."""

import sys
from types import TracebackType
from typing import Any, Self

WIDTH = 30


class Progress:
    """A bar from 0 to 1, and a count of compiled functions while the compiler is at work."""

    def __init__(self, label: str) -> None:
        self.label, self.shown = label, ""
        self.live = sys.stderr.isatty()
        self._compiled = 0
        self._recorder: Any = None

    def update(self, share: float, more: str = "") -> None:
        """Show how much is done, and what else there is to say of it."""
        full = round(WIDTH * min(max(share, 0.0), 1.0))
        self._show(f"{self.label} [{'#' * full}{'-' * (WIDTH - full)}] {share:4.0%} {more}".rstrip())

    def _show(self, line: str) -> None:
        if self.live and line != self.shown:
            self.shown = line
            print(f"\r\x1b[K{line}", end="", file=sys.stderr, flush=True)

    def watch_compiler(self) -> None:
        """Count what Numba compiles: on a machine's first run that takes a while."""
        from numba.core import event

        progress = self

        class Listener(event.Listener):
            def on_start(self, event: Any) -> None:
                progress._show(f"{progress.label}: compiling, once on this machine ({progress._compiled})")

            def on_end(self, event: Any) -> None:
                progress._compiled += 1

        self._recorder = Listener()
        event.register("numba:compile", self._recorder)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._recorder is not None:
            from numba.core import event

            event.unregister("numba:compile", self._recorder)
        if self.live and self.shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
