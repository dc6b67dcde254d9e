"""One holder of control at a time: a lease that ends some seconds after the holder's last sign of life.

Where no accounts are asked for, the first browser holds control without asking. With accounts it is asked
for, or taken by the first command while nobody holds it. Whoever asks is on a list that all see; the holder
hands over, or somebody takes control and says why.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.access.who import Role, Who

GRACE_S = 10.0  # a page that is loaded anew, or a short cut of the network, gives nothing away
MOST_REQUESTS = 20
MOST_REASON = 200

Told = Callable[[pb.ControlHolder], None]
Said = Callable[[pb.Severity, str, str, dict[str, str]], None]


class NotHolder(RuntimeError):
    """Somebody else holds control."""


@dataclass(frozen=True)
class Holder:
    """Who has it, since when (UNIX ns), and why it was taken from somebody."""

    who: Who
    since_ns: int
    reason: str = ""
    seen_s: float = 0.0  # by the lease's clock
    left: bool = False  # its last stream has ended, and nothing came of it since


class Lease:
    """Usable from any thread. `told` hears each new state, `said` what an operator should read of it."""

    def __init__(self, told: Told, said: Said, now: Callable[[], float] = time.monotonic) -> None:
        self._told, self._said, self._now = told, said, now
        self._lock = threading.RLock()
        self._holder: Holder | None = None
        self._requests: dict[str, pb.ControlRequest] = {}
        self._here: dict[str, tuple[Who, int]] = {}  # client -> who, open streams
        self._last = b""

    def state(self) -> pb.ControlHolder:
        """As it is now."""
        with self._lock:
            told = pb.ControlHolder(requests=self._requests.values())
            if (held := self._held()) is not None:
                told.holder, told.holder_name = held.who.client, held.who.shown
                told.since_ns, told.reason = held.since_ns, held.reason
                if held.who.client not in self._here:
                    told.until_ns = time.time_ns() + round((held.seen_s + GRACE_S - self._now()) * 1e9)
            return told

    def present(self) -> bool:
        """Whether somebody in control is there: its stream is open, or it commanded within the grace.

        Unlike the lease it does not outlast a page that was closed: the vehicle is told of that at once.
        """
        with self._lock:
            held = self._held()
            return held is not None and (held.who.client in self._here or not held.left)

    def joined(self, who: Who) -> None:
        """A browser's stream is open."""
        with self._lock:
            self._here[who.client] = (who, self._here.get(who.client, (who, 0))[1] + 1)
            self._settle()

    def left(self, who: Who) -> None:
        """A browser's stream has ended."""
        with self._lock:
            count = self._here.get(who.client, (who, 0))[1] - 1
            if count > 0:
                self._here[who.client] = (who, count)
            else:
                self._here.pop(who.client, None)
                self._seen(who, left=True)
            self._settle()

    def tick(self) -> None:
        """Time has passed."""
        with self._lock:
            self._settle()

    def use(self, who: Who) -> None:
        """A command that only the holder may give: take control that nobody has. Raises NotHolder."""
        _may_command(who)
        with self._lock:
            held = self._held()
            if held is None:
                self._give(who)
            elif held.who.client != who.client:
                raise NotHolder(_refused(held))
            self._seen(who)
            self._settle()

    def check(self, who: Who) -> None:
        """Raises NotHolder when somebody else holds control; takes nothing."""
        with self._lock:
            held = self._held()
            if held is not None and held.who.client != who.client:
                raise NotHolder(_refused(held))

    def ask(self, who: Who, reason: str = "") -> None:
        """Ask the holder for control; where nobody has it, it is given at once. Raises NotHolder."""
        _may_command(who)
        with self._lock:
            held = self._held()
            if held is None:
                self._give(who)
            elif held.who.client != who.client:
                if who.client not in self._requests and len(self._requests) >= MOST_REQUESTS:
                    raise NotHolder(f"{MOST_REQUESTS} others ask for control already")
                new = who.client not in self._requests
                self._requests[who.client] = pb.ControlRequest(
                    client=who.client, name=who.shown, since_ns=time.time_ns(), reason=reason[:MOST_REASON]
                )
                if new:
                    self._say(pb.SEVERITY_INFO, "control_asked", f"{who.shown} asks for control")
            self._settle()

    def take(self, who: Who, reason: str) -> None:
        """Take control from whoever has it. Raises NotHolder."""
        _may_command(who)
        with self._lock:
            held = self._held()
            if held is not None and held.who.client == who.client:
                return
            self._give(who, reason[:MOST_REASON] if held is not None else "")
            if held is not None:
                text = f"{who.shown} took control from {held.who.shown}: {reason[:MOST_REASON]}"
                self._say(pb.SEVERITY_WARNING, "control_taken", text)
            self._settle()

    def hand_over(self, who: Who, client: str) -> None:
        """Give control to somebody who asks for it or watches. Raises NotHolder, KeyError: nobody such."""
        with self._lock:
            self._must_hold(who)
            asked = self._requests.get(client)
            known = self._here.get(client)
            if known is None:
                raise KeyError(client)
            _may_command(known[0])
            self._give(known[0])
            verb = "handed control over to" if asked is None else "gave control to"
            self._say(pb.SEVERITY_INFO, "control_handed", f"{who.shown} {verb} {known[0].shown}")
            self._settle()

    def decline(self, who: Who, client: str) -> None:
        """Answer a request with no. Raises NotHolder, KeyError."""
        with self._lock:
            self._must_hold(who)
            declined = self._requests.pop(client)
            self._say(
                pb.SEVERITY_INFO, "control_declined", f"{who.shown} keeps control; {declined.name} asked"
            )
            self._settle()

    def let_go(self, who: Who) -> None:
        """Give control up, or stop asking for it."""
        with self._lock:
            self._requests.pop(who.client, None)
            held = self._held()
            if held is not None and held.who.client == who.client:
                self._holder = None
                self._say(pb.SEVERITY_INFO, "control_free", f"{who.shown} gave control up")
            self._settle(but=who.client)

    def forget(self, client: str) -> None:
        """Somebody's session was ended: what it held or asked for is over at once."""
        with self._lock:
            self._here.pop(client, None)
            self._requests.pop(client, None)
            if self._holder is not None and self._holder.who.client == client:
                name, self._holder = self._holder.who.shown, None
                self._say(pb.SEVERITY_WARNING, "control_lost", f"{name} was logged out and lost control")
            self._settle()

    def _held(self) -> Holder | None:
        """The holder, unless its lease has ended."""
        held = self._holder
        if held is None or held.who.client in self._here or self._now() - held.seen_s < GRACE_S:
            return held
        self._holder = None
        self._say(pb.SEVERITY_WARNING, "control_lost", f"{held.who.shown} is gone and lost control")
        return None

    def _must_hold(self, who: Who) -> None:
        held = self._held()
        if held is None or held.who.client != who.client:
            raise NotHolder("only the holder of control can hand it over")

    def _give(self, who: Who, reason: str = "") -> None:
        self._requests.pop(who.client, None)
        self._holder = Holder(who, time.time_ns(), reason, self._now())

    def _seen(self, who: Who, left: bool = False) -> None:
        if self._holder is not None and self._holder.who.client == who.client:
            self._holder = replace(self._holder, who=who, seen_s=self._now(), left=left)

    def _settle(self, but: str = "") -> None:
        """Give free control to who waits for it, and tell of what changed."""
        if self._held() is None:
            asked = [self._here[client][0] for client in self._requests if client in self._here]
            idle = [who for who, _ in self._here.values() if who.open and who.client != but]
            for who in (asked or idle)[:1]:
                if who.role >= Role.operator:
                    self._give(who)
        state = self.state()
        key = pb.ControlHolder()
        key.CopyFrom(state)
        key.until_ns = int(state.until_ns > 0)  # runs with the clock
        if (now := key.SerializeToString()) != self._last:
            self._last = now
            self._told(state)

    def _say(self, severity: pb.Severity, code: str, text: str) -> None:
        self._said(severity, code, text, {})


def _refused(held: Holder) -> str:
    return (
        f"{held.who.shown} holds control: ask for it, or take it and say why "
        "(pause and abort are open to every operator)"
    )


def _may_command(who: Who) -> None:
    if who.role < Role.operator:
        raise NotHolder(f"{who.shown} is an observer and can't hold control")
