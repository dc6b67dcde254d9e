"""Somebody else speaks for the vehicle: an alarm at once, and of each no more than one a minute."""

import time

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.told import Say

PAUSE_S = 60.0  # between two alarms about one and the same
MOST = 100


class Rivals:
    """Called with the session that spoke, "" for one without an id, and what it said."""

    def __init__(self, vehicle_id: str, say: Say) -> None:
        self._vehicle_id, self._say = vehicle_id, say
        self._told: dict[str, float] = {}  # when each was told of, s

    def __call__(self, session: str, said: str) -> None:
        """Tell of it, unless that was done a moment ago."""
        now = time.monotonic()
        if now - self._told.get(session, -PAUSE_S) < PAUSE_S or len(self._told) > MOST:
            return
        self._told[session] = now
        who = f"session {session}" if session else "a session without an id"
        text = f"Somebody else speaks for {self._vehicle_id} on the bus and is not listened to: {who}"
        self._say(pb.SEVERITY_ALARM, "second_speaker", text, {"session": session, "said": said})
