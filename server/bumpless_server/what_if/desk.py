"""One worker for all who ask what a draft would do. It starts on first use and ends when it is long idle.

To be used on one loop, which only passes lines on. Who asks while it flies waits; few may.
"""

import asyncio
import itertools
import logging
import sys

from bumpless_server.foresight.crew import Worker
from bumpless_server.foresight.tasks import Head
from bumpless_server.what_if.told import AheadPair, AheadTask

log = logging.getLogger(__name__)

COMMAND = (sys.executable, "-m", "bumpless_server.what_if.worker")
IDLE_S = 300.0
MOST_WAITING = 8
LONGEST_S = 120.0  # the first answer of a machine that has never compiled takes so long


class NoFlight(RuntimeError):
    """It can't be flown now; the text says why, for people."""


class WhatIfDesk:
    """Asks the worker, one after the other."""

    def __init__(self) -> None:
        self._worker: Worker | None = None
        self._answer: asyncio.Future[AheadPair] | None = None
        self._numbers = itertools.count(1)
        self._turn = asyncio.Lock()
        self._waiting = 0
        self._idle: asyncio.TimerHandle | None = None

    async def ask(self, task: AheadTask) -> AheadPair:
        """The pair of flights. Raises NoFlight."""
        if self._waiting >= MOST_WAITING:
            raise NoFlight("too many ask what a draft would do; try again in a moment")
        self._waiting += 1
        try:
            async with self._turn:
                return await asyncio.wait_for(self._asked(task), LONGEST_S)
        except TimeoutError as error:
            await self.stop()
            raise NoFlight(f"the flight ahead took longer than {LONGEST_S:g} s") from error
        finally:
            self._waiting -= 1
            self._rest_when_idle()

    async def stop(self) -> None:
        """End the worker."""
        if self._idle is not None:
            self._idle.cancel()
        worker, self._worker = self._worker, None
        if worker is not None:
            await worker.stop()

    async def _asked(self, task: AheadTask) -> AheadPair:
        if self._worker is None:
            worker = Worker(self._heard, self._ended, COMMAND)
            try:
                await worker.start()
            except OSError as error:
                raise NoFlight(f"no process can be started that flies it: {error}") from error
            self._worker = worker
        self._answer = asyncio.get_running_loop().create_future()
        self._worker.give(task.model_copy(update={"number": next(self._numbers)}))
        return await self._answer

    def _heard(self, worker: Worker, head: Head, body: bytes) -> None:
        answer = self._answer
        if worker is not self._worker or answer is None or answer.done():
            return
        if head.kind == "ahead":
            answer.set_result(AheadPair.model_validate_json(body))
        elif head.end and head.failed:
            answer.set_exception(NoFlight(head.failed))

    def _ended(self, worker: Worker) -> None:
        if worker is not self._worker:
            return
        self._worker = None
        if self._answer is not None and not self._answer.done():
            self._answer.set_exception(NoFlight("the process that flew it ended"))

    def _rest_when_idle(self) -> None:
        if self._idle is not None:
            self._idle.cancel()
        if self._worker is not None and not self._waiting:
            loop = asyncio.get_running_loop()
            self._idle = loop.call_later(IDLE_S, lambda: asyncio.ensure_future(self.stop()))
