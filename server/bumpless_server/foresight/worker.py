"""A worker: `python -m bumpless_server.foresight.worker [CHARTS]`. It flies what its input asks.

It gives way to every other process, keeps its compiled code warm, and ends with its input, so that it never
outlives its server.
"""

import os
import select
import signal
import sys
from collections.abc import Callable
from pathlib import Path

from bumpless_server.foresight.tasks import Head, Task

NICE = 10


class Line:
    """Lines from a pipe, and whether one waits: select and a buffer of Python's do not go together."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor, self._rest = descriptor, b""

    def waits(self) -> bool:
        """Whether something has arrived, an end included."""
        return b"\n" in self._rest or bool(select.select([self._descriptor], [], [], 0)[0])

    def next(self) -> bytes:
        """The next line; b"" at the end."""
        while b"\n" not in self._rest:
            more = os.read(self._descriptor, 1 << 16)
            if not more:
                return b""
            self._rest += more
        line, _, self._rest = self._rest.partition(b"\n")
        return line


def serve(lines: Line, tell: Callable[[Head, str], None], charts: Path | None = None) -> None:
    """Carry out tasks until the input ends; the last of several that wait is the one that counts.

    charts: folder of the depth grids that missions may name.
    """
    from bumpless_server.foresight.work import GivenUp, Work

    work = Work(lines.waits, charts)
    while line := lines.next():
        if line == b"stop":  # what it should stop is over already
            continue
        task = Task.model_validate_json(line)
        try:
            for kind, body in work.answers(task):
                tell(Head(number=task.number, kind=kind), body)
            tell(Head(number=task.number, end=True), "")
        except GivenUp:
            tell(Head(number=task.number, end=True, given_up=True), "")
        except Exception as fault:  # one strange mission must not cost the next its warm worker
            tell(Head(number=task.number, end=True, failed=f"{type(fault).__name__}: {fault}"), "")


def main() -> None:
    """Give way, then serve."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, whose end is ours
    os.nice(NICE)
    out = os.dup(1)
    os.dup2(2, 1)  # what a library prints must not come between our lines

    def tell(head: Head, body: str) -> None:
        rest = memoryview(f"{head.model_dump_json()}\n{body}\n".encode())
        while rest:
            rest = rest[os.write(out, rest) :]

    try:
        serve(Line(0), tell, Path(sys.argv[1]) if len(sys.argv) > 1 else None)
    except BrokenPipeError:
        sys.exit(0)


if __name__ == "__main__":
    main()
