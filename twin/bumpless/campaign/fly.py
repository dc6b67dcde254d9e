"""Fly what of a campaign is not stored yet."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from bumpless.campaign.cluster import cores_of
from bumpless.campaign.engine import answers, in_chunks
from bumpless.campaign.flight import FlyNumbers
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.store import Store, missing

if TYPE_CHECKING:
    from distributed import Client


@dataclass(frozen=True)
class Pace:
    """How far a campaign is."""

    stored: int  # flights, earlier sessions included
    total: int
    per_s: float  # flights per second in this session
    left_s: float  # at this pace

    def __str__(self) -> str:
        left = f"{self.left_s:.0f} s" if self.left_s < 120.0 else f"{self.left_s / 60.0:.0f} min"
        return f"{self.stored:,} of {self.total:,} flights, {self.per_s:.0f} per second, {left} left"


def fly_missing(
    prepared: Prepared, store: Store, client: "Client", progress: Callable[[Pace], None] | None = None
) -> None:
    """Fly and store every flight that is not stored. Whatever ends this early, what was stored stays."""
    total = prepared.campaign.count
    todo = missing(store.numbers(), range(total))
    begin, left = time.perf_counter(), len(todo)
    for _, rows in answers(client, FlyNumbers(prepared), dict(enumerate(in_chunks(todo, cores_of(client))))):
        store.add(rows)
        left -= len(rows)
        if progress:
            per_s = (len(todo) - left) / (time.perf_counter() - begin)
            progress(Pace(total - left, total, per_s, left / per_s))
