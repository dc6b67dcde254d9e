"""One holder of control at a time, in virtual time."""

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.access.lease import GRACE_S, Lease, NotHolder
from bumpless_server.access.who import Role, Who

ADA = Who("ada", Role.operator, "a", "Ada")
BEN = Who("ben", Role.operator, "b", "Ben")
EVE = Who("eve", Role.observer, "e", "Eve")


class Desk:
    """A lease, its clock, and what was told."""

    def __init__(self) -> None:
        self.now = 100.0
        self.told: list[pb.ControlHolder] = []
        self.said: list[tuple[str, str]] = []
        self.lease = Lease(
            self.told.append, lambda _s, code, text, _d: self.said.append((code, text)), lambda: self.now
        )

    @property
    def holder(self) -> str:
        return self.lease.state().holder_name


@pytest.fixture
def desk() -> Desk:
    return Desk()


def test_the_first_browser_without_accounts_holds_control_and_a_second_does_not(desk: Desk) -> None:
    """Protects: a single console works without a further click; a second one commands nothing."""
    one, two = (Who("", Role.engineer, c, f"Browser {c}", open=True) for c in "xy")
    desk.lease.joined(one)
    desk.lease.joined(two)
    desk.lease.use(one)
    with pytest.raises(NotHolder, match="Browser x holds control"):
        desk.lease.use(two)
    desk.lease.left(one)
    desk.now += GRACE_S + 0.1
    desk.lease.tick()
    assert desk.told[-1].holder_name == "Browser y"


def test_with_accounts_watching_takes_nothing_but_the_first_command_does(desk: Desk) -> None:
    """Protects: an operator who only looks on keeps control from nobody."""
    desk.lease.joined(ADA)
    assert desk.holder == ""
    desk.lease.use(BEN)
    assert desk.holder == "Ben"
    with pytest.raises(NotHolder):
        desk.lease.use(ADA)


def test_asked_for_and_handed_over(desk: Desk) -> None:
    """Protects: everybody sees who asks; only the holder can give control away."""
    desk.lease.joined(ADA)
    desk.lease.joined(BEN)
    desk.lease.ask(ADA)
    desk.lease.ask(BEN, "my turn")
    (request,) = desk.told[-1].requests
    assert (request.name, request.reason) == ("Ben", "my turn")
    with pytest.raises(NotHolder):
        desk.lease.hand_over(BEN, "b")
    desk.lease.hand_over(ADA, "b")
    assert desk.holder == "Ben" and not desk.told[-1].requests
    assert [code for code, _ in desk.said] == ["control_asked", "control_handed"]


def test_taken_with_a_reason_that_everybody_reads(desk: Desk) -> None:
    """Protects: control never changes hands unseen."""
    desk.lease.use(ADA)
    desk.lease.take(BEN, "Ada is on the phone")
    assert desk.holder == "Ben" and desk.told[-1].reason == "Ada is on the phone"
    assert ("control_taken", "Ben took control from Ada: Ada is on the phone") in desk.said


def test_the_lease_ends_with_the_connection_but_not_with_a_reload(desk: Desk) -> None:
    """Protects: a page that is loaded anew keeps control; one that is gone does not block the others."""
    desk.lease.joined(ADA)
    desk.lease.use(ADA)
    desk.lease.left(ADA)
    assert desk.told[-1].until_ns > 0
    desk.now += GRACE_S - 1
    desk.lease.joined(ADA)
    assert desk.told[-1].until_ns == 0
    desk.now += 100 * GRACE_S
    assert desk.holder == "Ada"
    desk.lease.left(ADA)
    desk.lease.joined(BEN)
    desk.lease.ask(BEN)
    desk.now += GRACE_S + 0.1
    desk.lease.tick()
    assert desk.told[-1].holder_name == "Ben"  # who asked has it
    assert ("control_lost", "Ada is gone and lost control") in desk.said


def test_the_vehicle_is_told_at_once_that_the_holder_is_gone(desk: Desk) -> None:
    """Protects: the lease outlasts a reload by its grace; the vehicle's own limit must not begin after it."""
    assert not desk.lease.present()
    desk.lease.joined(ADA)
    assert not desk.lease.present()  # watches, holds nothing
    desk.lease.use(ADA)
    assert desk.lease.present()
    desk.lease.left(ADA)
    assert not desk.lease.present() and desk.holder == "Ada"
    desk.lease.joined(ADA)
    assert desk.lease.present()


def test_a_script_without_a_stream_is_there_for_the_grace(desk: Desk) -> None:
    """Protects: a script that commands and never listens is no holder that vanished between two commands."""
    desk.lease.use(ADA)
    desk.now += GRACE_S - 0.1
    assert desk.lease.present()
    desk.now += 0.2
    assert not desk.lease.present()


def test_two_tabs_of_one_browser_are_one_holder(desk: Desk) -> None:
    """Protects: closing one of two tabs gives nothing away."""
    desk.lease.joined(ADA)
    desk.lease.joined(ADA)
    desk.lease.use(ADA)
    desk.lease.left(ADA)
    desk.now += 10 * GRACE_S
    assert desk.holder == "Ada"


def test_who_is_logged_out_holds_nothing(desk: Desk) -> None:
    """Protects: a revoked session's lease does not outlive it by the grace."""
    desk.lease.joined(ADA)
    desk.lease.use(ADA)
    desk.lease.forget("a")
    assert desk.holder == "" and desk.told[-1].holder == ""


def test_control_is_given_to_nobody_who_may_not_command(desk: Desk) -> None:
    """Protects: an observer never becomes the holder, by no way."""
    desk.lease.joined(ADA)
    desk.lease.joined(EVE)
    desk.lease.use(ADA)
    with pytest.raises(NotHolder):
        desk.lease.hand_over(ADA, "e")
    with pytest.raises(NotHolder):
        desk.lease.ask(EVE)
    desk.lease.let_go(ADA)
    assert desk.holder == ""
