"""Requests that the guard refused, for the audit: the first of a kind at once, then how many more there were.

A flood can't fill the audit, nor push what was done out of what is shown of it: the pauses between two lines
of a kind grow, and all kinds together have so many lines an hour. What has no line is counted into a later.
"""

import asyncio
import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from fastapi.concurrency import run_in_threadpool

from bumpless_server.audit import Audit
from bumpless_server.web.guesses import network_of

VERB, MOST_SAID = "turned_away", 300

PAUSES_S = (60.0, 600.0, 3600.0)  # between two lines of a kind, the last one from then on
LINES, WITHIN_S = 60, 3600.0  # of all kinds
MOST_KINDS = 500
OTHERS = "more kinds than are told apart"


class Refused(NamedTuple):
    """A request that was not let in."""

    request: str  # "POST /api/mission/start"
    status: int
    reason: str
    author: str  # "": nobody who is known
    address: str


TurnAway = Callable[[Refused], Awaitable[None]]


async def nobody_told(_one: Refused) -> None:
    """Where there is no audit."""


class Line(NamedTuple):
    """For the audit: the newest refusal of its kind, and how many it stands for."""

    newest: Refused
    times: int


@dataclass
class _Kind:
    newest: Refused
    waiting: int = 0  # refused since the last line
    told: int = 0  # lines
    due_s: float = 0.0


@dataclass
class TurnedAway:
    """Counts; used on the event loop alone. A kind is whose, from where, and refused how."""

    now: Callable[[], float] = time.monotonic
    _kinds: OrderedDict[tuple[str, str, int], _Kind] = field(default_factory=OrderedDict)
    _told_s: list[float] = field(default_factory=list)

    def hear(self, one: Refused) -> list[Line]:
        """Take in one more; the lines that are due now, of this kind and of others."""
        key = (network_of(one.address), one.author, one.status)
        if key not in self._kinds and len(self._kinds) >= MOST_KINDS and not self._forget():
            key, one = ("", "", 0), one._replace(request=OTHERS, author="", address="")
        kind = self._kinds.setdefault(key, _Kind(one))
        kind.newest, kind.waiting = one, kind.waiting + 1
        return self.due()

    def due(self) -> list[Line]:
        """What may be told by now."""
        now, lines = self.now(), []
        self._told_s = [told for told in self._told_s if told > now - WITHIN_S]
        for kind in self._kinds.values():
            if kind.waiting and kind.due_s <= now and len(self._told_s) < LINES:
                lines.append(Line(kind.newest, kind.waiting))
                self._told_s.append(now)
                kind.due_s = now + PAUSES_S[min(kind.told, len(PAUSES_S) - 1)]
                kind.told, kind.waiting = kind.told + 1, 0
        return lines

    @property
    def waiting(self) -> bool:
        """Whether some were counted and not told yet."""
        return any(kind.waiting for kind in self._kinds.values())

    def rest(self) -> list[Line]:
        """All that was not told, at the end."""
        lines = [Line(kind.newest, kind.waiting) for kind in self._kinds.values() if kind.waiting]
        for kind in self._kinds.values():
            kind.waiting = 0
        return lines[:LINES]

    def _forget(self) -> bool:
        """Make room: of a kind that has nothing to tell and is long quiet."""
        now = self.now()
        for key, kind in self._kinds.items():
            if not kind.waiting and kind.due_s <= now:
                del self._kinds[key]
                return True
        return False


class Doorman:
    """Writes down who was turned away: at once what is due, and by a clock what was counted."""

    def __init__(self, audit: Audit, turned: TurnedAway | None = None) -> None:
        self._audit, self._turned = audit, turned or TurnedAway()
        self._clock: asyncio.Task[None] | None = None

    async def turn_away(self, one: Refused) -> None:
        """Note one more."""
        await self._write(self._turned.hear(one))
        if self._clock is None or self._clock.done():
            self._clock = asyncio.create_task(self._later())

    async def stop(self) -> None:
        """Write down what was counted and not told."""
        if self._clock is not None:
            self._clock.cancel()
        await self._write(self._turned.rest())

    async def _later(self) -> None:
        await asyncio.sleep(PAUSES_S[0])
        await self._write(self._turned.due())
        if self._turned.waiting:
            self._clock = asyncio.create_task(self._later())

    async def _write(self, lines: list[Line]) -> None:
        for one, times in lines:
            details = {"request": one.request, "status": one.status, "times": times}
            note = self._audit.note
            await run_in_threadpool(note, VERB, one.author, one.address, details, one.reason[:MOST_SAID])
