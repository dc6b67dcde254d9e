"""Foresight with its real processes, on a loop of the test's own."""

import asyncio
import json
from collections.abc import AsyncIterator, Callable
from typing import Any

import pytest

from bumpless_server.foresight.foresight import Client, Foresight

PATIENCE_S = 150.0  # a worker may have to compile first


class Planner:
    """A client, and all that it was told."""

    def __init__(self, client: Client) -> None:
        self.client = client
        self.told: asyncio.Queue[dict[str, Any]] = asyncio.Queue()

    def ask(self, request_id: int, text: str, **more: Any) -> None:
        self.client.ask(json.dumps({"id": request_id, "text": text, **more}))

    async def until_end(self, request_id: int) -> list[dict[str, Any]]:
        """Every message of a request, to its last; those of others are left out."""
        found: list[dict[str, Any]] = []
        while not found or found[-1]["kind"] not in ("done", "failed", "problems"):
            message = await asyncio.wait_for(self.told.get(), PATIENCE_S)
            if message["id"] == request_id:
                found.append(message)
        return found


@pytest.fixture
async def foresight() -> AsyncIterator[Foresight]:
    """Two workers, ended with the test."""
    found = Foresight(workers=2)
    yield found
    await found.stop()


@pytest.fixture
async def planner(foresight: Foresight) -> AsyncIterator[Planner]:
    """One client of them."""
    async with joined(foresight)() as one:
        yield one


def joined(foresight: Foresight) -> Callable[[], Any]:
    """A way to bring in clients."""
    from contextlib import asynccontextmanager

    @asynccontextmanager
    async def join() -> AsyncIterator[Planner]:
        holder: list[Planner] = []

        async def send(text: str) -> None:
            holder[0].told.put_nowait(json.loads(text))

        async with foresight.client(send) as client:
            holder.append(Planner(client))
            yield holder[0]

    return join
