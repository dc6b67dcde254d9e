"""A worker: `python -m bumpless_server.foresight.worker [CHARTS]`. It flies what its input asks.

It keeps its compiled code warm, and ends with its input, so that it never outlives its server.
"""

import os
import select
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol

from bumpless_server.foresight import tasks
from bumpless_server.foresight.tasks import GivenUp, Head


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


class Works(Protocol):
    """What a worker can do; made once, so that it keeps what is dear."""

    def read(self, line: bytes) -> tasks.Line:
        """The task of a line."""
        ...

    def answers(self, task: Any) -> Iterator[tuple[tasks.Told, str]]:
        """The task's answers, kind and body. Raises GivenUp between flights when a newer waits."""
        ...


Make = Callable[[Callable[[], bool]], Works]  # handed whether another line waits


def serve(lines: Line, tell: Callable[[Head, str], None], make: Make) -> None:
    """Carry out tasks until the input ends; the last of several that wait is the one that counts."""
    work = make(lines.waits)
    while line := lines.next():
        if line == b"stop":  # what it should stop is over already
            continue
        task = work.read(line)
        try:
            for kind, body in work.answers(task):
                tell(Head(number=task.number, kind=kind), body)
            tell(Head(number=task.number, end=True), "")
        except GivenUp:
            tell(Head(number=task.number, end=True, given_up=True), "")
        except Exception as fault:  # one strange mission must not cost the next its warm worker
            tell(Head(number=task.number, end=True, failed=f"{type(fault).__name__}: {fault}"), "")


def main(make: Make) -> None:
    """Serve."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, whose end is ours
    out = os.dup(1)
    os.dup2(2, 1)  # what a library prints must not come between our lines

    def tell(head: Head, body: str) -> None:
        rest = memoryview(f"{head.model_dump_json()}\n{body}\n".encode())
        while rest:
            rest = rest[os.write(out, rest) :]

    try:
        serve(Line(0), tell, make)
    except BrokenPipeError:
        sys.exit(0)


if __name__ == "__main__":
    from bumpless_server.foresight.work import Work

    # the argument: the folder of the depth grids that missions may name
    charts = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    main(lambda newer: Work(newer, charts))
