"""Foresight on the server's loop: who asked last, what is done next, and what is told to whom.

Each client has one job, its newest request; a newer one takes its place and what was begun for the old is
given up after the flight being flown. Nominal flights and findings go before anybody's fan, and fans take
turns. The loop only passes lines on.
"""

import asyncio
import contextlib
import itertools
import json
import logging
import os
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path

from pydantic import ValidationError

from bumpless.campaign.summary import share_of
from bumpless_server.foresight.crew import COMMAND, Worker
from bumpless_server.foresight.job import Job, Present
from bumpless_server.foresight.tasks import Head, Task
from bumpless_server.foresight.told import ForesightDone, ForesightFailed
from bumpless_server.foresight.wanted import ForesightRequest

log = logging.getLogger(__name__)

MOST_CLIENTS = 16
MOST_WAITING = 64  # messages for a client that reads too slowly
IDLE_S = 300.0
MOST_STILLBORN = 4  # workers in a row; fewer may have been killed by chance
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
WORKERS = max(1, min(CORES, 4))


class Client:
    """One planner: its newest request and the messages that wait for it."""

    def __init__(self, owner: "Foresight") -> None:
        self._owner = owner
        self.job: Job | None = None
        self.waiting: asyncio.Queue[str] = asyncio.Queue()

    def ask(self, text: str) -> None:
        """Foresee this request in place of the one before."""
        try:
            request = ForesightRequest.model_validate_json(text)
        except ValidationError as error:
            first = error.errors(include_url=False, include_context=False)[0]
            place = ".".join(map(str, first["loc"]))
            self.tell(ForesightFailed(id=_id_of(text), reason=f"{place}: {first['msg']}").model_dump_json())
            return
        self._owner.take(self, request)

    def tell(self, message: str) -> None:
        """Queue a message; what is older than a whole fan and was never read is worth nothing."""
        while self.waiting.qsize() >= MOST_WAITING:
            self.waiting.get_nowait()
        self.waiting.put_nowait(message)


class Foresight:
    """All planners and all workers. To be used on one loop; nothing runs before the first client comes.

    charts: folder of the depth grids that missions may name.
    """

    def __init__(
        self, present: Callable[[], Present] = Present, workers: int = WORKERS, charts: Path | None = None
    ) -> None:
        self._present, self._most = present, workers
        self._command = COMMAND if charts is None else (*COMMAND, str(charts))
        self._clients: list[Client] = []
        self._workers: list[Worker] = []
        self._doing: dict[int, tuple[Client, Job]] = {}  # by the task's number
        self._numbers = itertools.count(1)
        self._starting = asyncio.Lock()
        self._begun: set[asyncio.Task[None]] = set()
        self._idle: asyncio.TimerHandle | None = None
        self._stillborn = 0  # workers in a row that ended before they were ready

    @asynccontextmanager
    async def client(self, send: Callable[[str], Awaitable[None]]) -> AsyncIterator[Client]:
        """A planner that is there for as long as the context is entered; `send` takes its messages."""
        client = Client(self)
        if len(self._clients) >= MOST_CLIENTS:
            await send(ForesightFailed(id=0, reason="too many planners are open").model_dump_json())
            raise RuntimeError("too many planners are open")
        self._clients.append(client)
        sending = asyncio.create_task(_pass_on(client, send))
        try:
            await self._start()
            yield client
        finally:
            sending.cancel()
            self._clients.remove(client)
            self._drop(client)
            self._rest_when_idle()

    def take(self, client: Client, request: ForesightRequest) -> None:
        """Give a client a new job in place of its old one."""
        self._drop(client)
        client.job = Job(request, self._present(), self._numbers)
        if len(self._workers) < self._most:
            self._begin()
        self._hand_out()

    async def stop(self) -> None:
        """End every worker."""
        if self._idle is not None:
            self._idle.cancel()
        workers, self._workers = self._workers, []
        for worker in workers:
            await worker.stop()

    def _begin(self) -> None:
        """Start what is missing, beside whatever goes on."""
        starting = asyncio.create_task(self._start())
        self._begun.add(starting)  # the loop keeps only a weak reference
        starting.add_done_callback(self._begun.discard)

    async def _start(self) -> None:
        if self._idle is not None:
            self._idle.cancel()
        async with self._starting:
            await asyncio.to_thread(share_of, 0, 0)  # it loads a large library, which the loop must not
            while len(self._workers) < self._most:
                worker = Worker(self._heard, self._ended, self._command)
                try:
                    await worker.start()
                except OSError as error:
                    log.error("a foresight worker cannot be started: %s", error)
                    return
                worker.give(Task(number=next(self._numbers), kind="warm"))
                self._workers.append(worker)

    def _drop(self, client: Client) -> None:
        """Give up what a client asked for before, and what was to be told of it."""
        old, client.job = client.job, None
        while not client.waiting.empty():
            client.waiting.get_nowait()
        for worker in self._workers:
            task = worker.task
            if task is not None and old is not None and self._doing.get(task.number, (None, None))[1] is old:
                worker.give_up()

    def _hand_out(self) -> None:
        """Give every free worker the next task: what is urgent first, then fans in turn."""
        for worker in self._workers:
            if worker.task is None and (found := self._next()) is not None:
                client, job, task = found
                self._doing[task.number] = (client, job)
                worker.give(task)

    def _next(self) -> tuple[Client, Job, Task] | None:
        for urgent in (True, False):
            for client in list(self._clients):
                if client.job is not None and (task := client.job.task(urgent)) is not None:
                    self._clients.remove(client)  # its next turn comes after the others'
                    self._clients.append(client)
                    return client, client.job, task
        return None

    def _heard(self, worker: Worker, head: Head, body: bytes) -> None:
        client, job = self._doing.get(head.number, (None, None))
        if client is not None and job is not None and client.job is job:
            self._pass(client, job, head, body)
        if head.end:
            self._stillborn = 0
            self._doing.pop(head.number, None)
            worker.task = None
            self._hand_out()

    def _pass(self, client: Client, job: Job, head: Head, body: bytes) -> None:
        """Tell a client what its job has found."""
        if head.kind == "flights":
            client.tell(job.fan(body).model_dump_json())
        elif head.kind != "none":
            client.tell(body.decode())
            job.refused = job.refused or head.kind == "problems"
        if head.failed:
            self._fail(client, job, head.failed)
        elif head.end:
            job.finished()
            if job.done:
                if not job.refused:
                    client.tell(ForesightDone(id=job.request.id).model_dump_json())
                client.job = None

    def _ended(self, worker: Worker) -> None:
        """A process is gone: what it did has failed, and who still waits gets another process."""
        if worker not in self._workers:
            return
        self._workers.remove(worker)
        task = worker.task
        client, job = self._doing.pop(task.number, (None, None)) if task is not None else (None, None)
        if isinstance(task, Task) and task.kind == "warm":
            log.error("a foresight worker ended before it was ready")
            self._stillborn += 1
            if self._stillborn >= MOST_STILLBORN:  # none comes up, and the next would not either
                for one in self._clients:
                    self._fail(one, one.job, "no process can be started that flies it")
        else:
            self._fail(client, job, "the process that flew it ended")
        if any(one.job is not None for one in self._clients):
            self._begin()

    def _fail(self, client: Client | None, job: Job | None, reason: str) -> None:
        if client is not None and job is not None and client.job is job:
            client.tell(ForesightFailed(id=job.request.id, reason=reason).model_dump_json())
            client.job = None

    def _rest_when_idle(self) -> None:
        if not self._clients and self._workers:
            loop = asyncio.get_running_loop()
            self._idle = loop.call_later(IDLE_S, lambda: asyncio.ensure_future(self.stop()))


async def _pass_on(client: Client, send: Callable[[str], Awaitable[None]]) -> None:
    with contextlib.suppress(RuntimeError, OSError):  # it left; its receiver says so
        while True:
            await send(await client.waiting.get())


def _id_of(text: str) -> int:
    """The id of a request that could not be read, 0 when even that is missing."""
    try:
        found = json.loads(text)["id"]
    except (ValueError, TypeError, KeyError, RecursionError):
        return 0
    return found if isinstance(found, int) and 0 <= found < 2**53 else 0
