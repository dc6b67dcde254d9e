"""One vehicle id, one node: see who else wants it, and give way by a rule both sides come to alike."""

import time
from collections.abc import Callable

import zenoh

from twin.contract import keys

ASK_S = 1.0  # for a bus that doesn't answer; one that does takes milliseconds


class TakenError(RuntimeError):
    """The vehicle id is alive already, or an older node claims it."""


class Claim:
    """This session's claim on a vehicle id.

    `stake` refuses when the id is alive. After that every node sees the claims of all others, also of
    one that was cut off from the bus while both started: the older claim stays, the younger node calls
    `give_way` with a reason. Equal times are told apart by session id, so exactly one stays.
    """

    def __init__(self, session: zenoh.Session, vehicle: str, give_way: Callable[[str], None]) -> None:
        self._session = session
        self._vehicle = vehicle
        self._give_way = give_way
        self._mine = (f"{time.time_ns():020d}", str(session.zid()))
        self._held: list[zenoh.LivelinessToken | zenoh.Subscriber] = []

    def stake(self) -> None:
        """Claim the id for this session. Raises TakenError when a vehicle of that id is alive."""
        liveliness = self._session.liveliness()
        for reply in liveliness.get(keys.alive(self._vehicle), timeout=ASK_S):
            if reply.ok is not None:
                raise TakenError(f"{self._vehicle} is already alive on this bus; not starting a second one")
        since, session_id = self._mine
        self._held.append(liveliness.declare_token(keys.claim(self._vehicle, since, session_id)))
        self._held.append(
            liveliness.declare_subscriber(keys.claim(self._vehicle, "*", "*"), self._seen, history=True)
        )

    def declare_alive(self) -> None:
        """Say that the vehicle is ready."""
        self._held.append(self._session.liveliness().declare_token(keys.alive(self._vehicle)))

    def release(self) -> None:
        """Alive no longer."""
        while self._held:
            self._held.pop().undeclare()

    def _seen(self, sample: zenoh.Sample) -> None:
        since, session_id = str(sample.key_expr).split("/")[-2:]
        if sample.kind == zenoh.SampleKind.PUT and (since, session_id) < self._mine:
            self._give_way(f"{self._vehicle} is an older node's already (session {session_id}); giving way")
