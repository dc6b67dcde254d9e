"""Whether a vehicle is there is decided by time and liveliness alone; nothing stale may look live."""

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.freshness import stale_after_s
from bumpless_server.live.link import LOST_WITHOUT_TOKEN_S, STALE_AFTER_S, Link


def test_waiting_until_something_is_seen() -> None:
    """A console without a vehicle waits; it has lost nothing."""
    link = Link()
    link.token(False)
    assert link.state(100.0) == pb.LINK_STATE_WAITING
    assert link.next_change_s(100.0) is None


def test_live_turns_stale_by_silence_and_lost_by_the_token() -> None:
    """Silence dims the screen; only the liveliness token's end means the vehicle is gone."""
    link = Link()
    link.token(True)
    assert link.state(0.0) == pb.LINK_STATE_STALE
    link.heard(10.0)
    assert link.state(10.0) == pb.LINK_STATE_LIVE
    assert link.next_change_s(10.0) == pytest.approx(STALE_AFTER_S)
    assert link.state(10.0 + STALE_AFTER_S) == pb.LINK_STATE_STALE
    assert link.state(1e6) == pb.LINK_STATE_STALE
    link.token(False)
    assert link.state(10.0) == pb.LINK_STATE_LOST
    link.token(True)
    link.heard(11.0)
    assert link.state(11.0) == pb.LINK_STATE_LIVE


def test_a_bus_that_filters_liveliness_still_loses_a_silent_vehicle() -> None:
    """Without any token, silence must do in the end."""
    link = Link()
    link.heard(0.0)
    assert link.state(0.1) == pb.LINK_STATE_LIVE
    assert link.state(STALE_AFTER_S) == pb.LINK_STATE_STALE
    assert link.next_change_s(STALE_AFTER_S) == pytest.approx(LOST_WITHOUT_TOKEN_S - STALE_AFTER_S)
    assert link.state(LOST_WITHOUT_TOKEN_S) == pb.LINK_STATE_LOST


def test_a_slow_vehicle_is_given_its_time() -> None:
    """Protects: telemetry at 1 Hz flapped between live and stale; it is late by its own period."""
    link = Link(stale_after_s=stale_after_s(1.0))
    link.token(True)
    link.heard(0.0)
    assert link.state(1.5) == pb.LINK_STATE_LIVE
    assert link.state(2.5) == pb.LINK_STATE_STALE
    assert stale_after_s(0.05) == STALE_AFTER_S
