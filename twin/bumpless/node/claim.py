"""One vehicle id, one node: see who else wants it, and give way by a rule both sides come to alike."""

import time

import zenoh

from bumpless.contract import keys
from bumpless.node.links import wait_for_links

MOST_CLAIMS = 64  # remembered of others
ASK_S = 1.0  # for a bus that doesn't answer; one that does takes milliseconds


class TakenError(RuntimeError):
    """The vehicle id is alive already, or an older node claims it."""


class Claim:
    """This session's claim on a vehicle id.

    A vehicle says nothing before `stake` and `confirm` have passed: both refuse when the id is alive. Where
    the bus it connects to is not there, `settled` stays False: it asks again, by `confirm`, once it is.
    After that every node sees the claims of all others, also of one that was cut off from the bus while
    both started: the older claim stays, `contested` tells the younger one why it must leave. Equal times are
    told apart by session id, so exactly one stays. `connects` says that there should be a bus to link with.
    """

    def __init__(self, session: zenoh.Session, vehicle: str, connects: bool = False) -> None:
        self._session = session
        self._vehicle = vehicle
        self._connects = connects
        self._mine = ("", "")
        self.settled = False  # asked of everybody that this session can ever hear of before it speaks
        self._older: dict[str, str] = {}  # claims older than ours by session id; written on Zenoh's thread
        self._held: list[zenoh.LivelinessToken | zenoh.Subscriber] = []

    def stake(self) -> None:
        """Claim the id for this session. Raises TakenError when a vehicle of that id is alive."""
        wait_for_links(self._session, self._connects)
        self._refuse_alive()
        self._mine = since, session_id = f"{time.time_ns():020d}", str(self._session.zid())
        liveliness = self._session.liveliness()
        self._held.append(liveliness.declare_token(keys.claim(self._vehicle, since, session_id)))
        self._held.append(
            liveliness.declare_subscriber(keys.claim(self._vehicle, "*", "*"), self._seen, history=True)
        )

    def confirm(self) -> None:
        """Look again, now that all links had time to come up. Raises TakenError when the id is another's."""
        wait_for_links(self._session, connects=False)
        self._refuse_alive()
        for key in self._alive(keys.claim(self._vehicle, "*", "*")):
            if _claimed(key) < self._mine:
                raise TakenError(self._why(key))
        self.settled = self.linked() or not self._connects

    def linked(self) -> bool:
        """Is there anybody on the bus beside this session?"""
        return next(iter(self._session.info.transports()), None) is not None

    def declare_alive(self) -> None:
        """Say that the vehicle is ready."""
        self._held.append(self._session.liveliness().declare_token(keys.alive(self._vehicle)))

    def release(self) -> None:
        """Alive no longer."""
        while self._held:
            self._held.pop().undeclare()

    def _refuse_alive(self) -> None:
        if self._alive(keys.alive(self._vehicle)):
            raise TakenError(f"{self._vehicle} is already alive on this bus; not starting a second one")

    def _alive(self, key: str) -> list[str]:
        replies = self._session.liveliness().get(key, timeout=ASK_S)
        return [str(reply.ok.key_expr) for reply in replies if reply.ok is not None]

    def contested(self) -> str | None:
        """Why this node must give way; None while no older node serves the vehicle.

        A claim alone is not enough: anybody can say one. Its session must answer as a vehicle does.
        """
        older = dict(self._older)
        if not older:
            return None
        replies = self._session.get(
            keys.schema(self._vehicle),
            timeout=ASK_S,
            target=zenoh.QueryTarget.ALL,
            consolidation=zenoh.ConsolidationMode.NONE,
        )
        for reply in replies:
            if reply.ok is not None and reply.replier_id is not None:
                key = older.get(str(reply.replier_id.zid))
                if key is not None:
                    return self._why(key)
        return None

    def _seen(self, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        claimed = _claimed(key)
        if sample.kind != zenoh.SampleKind.PUT:
            self._older.pop(claimed[1], None)
        elif claimed < self._mine and len(self._older) < MOST_CLAIMS:
            self._older[claimed[1]] = key

    def _why(self, key: str) -> str:
        return f"{self._vehicle} is an older node's already (session {_claimed(key)[1]}); giving way"


def _claimed(key: str) -> tuple[str, str]:
    """(since, session id) of a claim's key."""
    since, session_id = key.split("/")[-2:]
    return since, session_id
