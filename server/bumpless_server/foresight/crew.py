"""Worker processes: started on first use, one task each at a time, ended when idle and with the server.

They give way to every other process from their first moment.
"""

import asyncio
import contextlib
import logging
import os
import sys
from collections.abc import Callable, Sequence

from bumpless_server.foresight.tasks import Head, Line

log = logging.getLogger(__name__)

NICE = 10
LONGEST_LINE = 32 << 20  # bytes
ONE_THREAD = dict.fromkeys(("NUMBA_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
COMMAND = (sys.executable, "-m", "bumpless_server.foresight.worker")
Heard = Callable[["Worker", Head, bytes], None]


class Worker:
    """One process. `heard` is told each answer, `ended` that the process is gone; both on the loop."""

    def __init__(
        self, heard: Heard, ended: Callable[["Worker"], None], command: Sequence[str] = COMMAND
    ) -> None:
        self.task: Line | None = None  # what it does now
        self.stopping = False  # told to give its task up
        self._heard, self._ended, self._command = heard, ended, command
        self._process: asyncio.subprocess.Process | None = None
        self._reading: asyncio.Task[None] | None = None

    async def start(self) -> None:
        """Start the process. Raises OSError."""
        self._process = await asyncio.create_subprocess_exec(
            *self._command,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            limit=LONGEST_LINE,
            env={**os.environ, **ONE_THREAD},
        )
        with contextlib.suppress(ProcessLookupError):  # at once: what it imports costs a second of a core
            os.setpriority(os.PRIO_PROCESS, self._process.pid, os.nice(0) + NICE)
        self._reading = asyncio.create_task(self._read(self._process))

    def give(self, task: Line) -> None:
        """Begin a task; there must be none."""
        self.task, self.stopping = task, False
        self._write(task.model_dump_json().encode() + b"\n")

    def give_up(self) -> None:
        """Let it drop its task after the flight it is in."""
        if self.task is not None and not self.stopping:
            self.stopping = True
            self._write(b"stop\n")

    async def stop(self) -> None:
        """End the process."""
        process, reading = self._process, self._reading
        if process is None or reading is None:
            return
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.wait()
        await reading
        if process.stdin is not None:  # its pipe would outlive the loop else
            process.stdin.close()
            with contextlib.suppress(OSError):
                await process.stdin.wait_closed()

    def _write(self, line: bytes) -> None:
        if self._process is not None and self._process.stdin is not None:
            with contextlib.suppress(OSError, RuntimeError):  # gone: its reader says so
                self._process.stdin.write(line)

    async def _read(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdout is not None
        try:
            while head := await process.stdout.readline():
                body = await process.stdout.readline()
                self._heard(self, Head.model_validate_json(head), body[:-1])
        except (ValueError, OSError):
            log.exception("a foresight worker cannot be understood")
            with contextlib.suppress(ProcessLookupError):
                process.kill()
        self._ended(self)
