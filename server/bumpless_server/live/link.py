"""Is there a vehicle, and is what it says fresh? A pure state machine on monotonic time."""

from dataclasses import dataclass

from bumpless.contract import bumpless_pb2 as pb

STALE_AFTER_S = 0.5  # ten control cycles at 20 Hz
LOST_WITHOUT_TOKEN_S = 10.0  # for a bus that filters liveliness: silence alone must do


@dataclass
class Link:
    """The link to one vehicle; `now` is always time.monotonic() of the caller, s."""

    alive: bool = False  # liveliness token present
    stale_after_s: float = STALE_AFTER_S  # longer for a vehicle whose control period is
    _had_token: bool = False
    _heard_at: float | None = None

    def token(self, present: bool) -> None:
        """The vehicle's liveliness token appeared or went."""
        self.alive = present
        self._had_token = self._had_token or present

    def heard(self, now: float) -> None:
        """A telemetry message arrived."""
        self._heard_at = now

    def age_s(self, now: float) -> float:
        """Seconds since the last telemetry; infinite when there was none."""
        return float("inf") if self._heard_at is None else max(0.0, now - self._heard_at)

    def state(self, now: float) -> pb.LinkState:
        """WAITING until anything was seen, LOST when the token is gone, STALE when telemetry is late."""
        age = self.age_s(now)
        if not self._had_token and self._heard_at is None:
            return pb.LINK_STATE_WAITING
        if self._had_token and not self.alive:
            return pb.LINK_STATE_LOST
        if not self._had_token and age >= LOST_WITHOUT_TOKEN_S:
            return pb.LINK_STATE_LOST
        return pb.LINK_STATE_LIVE if age < self.stale_after_s else pb.LINK_STATE_STALE

    def next_change_s(self, now: float) -> float | None:
        """Seconds until time alone would change the state; None when only a message can."""
        age = self.age_s(now)
        if self.state(now) == pb.LINK_STATE_LIVE:
            return self.stale_after_s - age
        if self.state(now) == pb.LINK_STATE_STALE and not self._had_token:
            return LOST_WITHOUT_TOKEN_S - age
        return None
