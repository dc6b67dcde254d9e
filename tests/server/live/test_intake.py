"""What is taken from the bus, who speaks, and how far two clocks are apart: decided without any bus."""

import pytest
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.flown import Flown
from bumpless.sim.twin import Result
from bumpless_server.live.clock import WINDOW_S, VehicleClock
from bumpless_server.live.intake import Intake, non_finite
from bumpless_server.live.sample import Sample
from bumpless_server.live.speaker import QUIET_S, Speaker
from bumpless_server.live.tally import EXAMPLE_CHARS, KINDS, Tally, printable


class Now:
    """A clock that stands until it is moved."""

    def __init__(self) -> None:
        self.s = 100.0

    def __call__(self) -> float:
        return self.s


def taken(message: Message, topic: str) -> tuple[bool, dict[str, int]]:
    """Is it taken, and what was counted?"""
    tally = Tally()
    intake = Intake(tally, Speaker(), VehicleClock(), lambda *_: None)
    sample = Sample(topic, message.DESCRIPTOR.full_name, message.SerializeToString())
    found = intake.take(sample) is not None
    return found, {one.kind: one.count for one in tally.counts() if one.kind != "clock_offset"}


STAMP = pb.Stamp(time_ns=1)


@pytest.mark.parametrize(
    ("topic", "message"),
    [
        ("tlm/mission", pb.MissionStatus(stamp=STAMP, run_id="../../x")),
        ("tlm/mission", pb.MissionStatus(stamp=STAMP, run_id="/etc/passwd")),
        ("tlm/mission", pb.MissionStatus(stamp=STAMP, run_id="x" * 129)),
        ("tlm/mission", pb.MissionStatus(stamp=STAMP, run_id="a\x00b")),
        ("tlm/description", pb.VehicleDescription(stamp=STAMP, vehicle_id="../x")),
        ("tlm/plan", pb.Plan(stamp=STAMP, file_name="../../.bashrc")),
    ],
)
def test_a_name_that_breaks_its_rule_names_nothing(topic: str, message: Message) -> None:
    """Protects: a run id such as `../../x` in a status from the bus became a path outside the data folder."""
    assert taken(message, topic) == (False, {"bad_name": 1})


def test_what_the_contract_calls_nan_is_not_odd() -> None:
    """Protects the counters from crying wolf: an unseen target has no range, and
    nobody can tell when a way out of a mode is taken that nothing leads to."""
    unseen = pb.Target(stamp=STAMP, measured_range_m=float("nan"), bearing_deg=float("nan"))
    assert taken(unseen, "tlm/target") == (True, {})
    nobody_knows = pb.Exits(stamp=STAMP, exits=[pb.ModeExit(name="brake", expected_s=float("nan"))])
    assert taken(nobody_knows, "tlm/exits") == (True, {})
    odd = pb.Target(stamp=STAMP, position_ned_m=pb.Vector3(x=float("inf")))
    assert taken(odd, "tlm/target") == (True, {"non_finite": 1})


def test_a_whole_docking_flight_is_not_odd(flight: Result) -> None:
    """Protects an operator from a warning in every flight of our own: what may be no number is declared."""
    odd = {f"{topic}: {found}" for _, topic, m in Flown(flight, 1).timed() if (found := non_finite(m))}
    assert odd == set()


def test_one_session_speaks_until_it_has_left() -> None:
    """Protects: whoever speaks last must not take a vehicle's place that is still there."""
    now = Now()
    speaker = Speaker(now)
    assert speaker.accepts("a") and not speaker.accepts("b")
    now.s += QUIET_S / 2
    assert speaker.accepts("a")
    now.s += QUIET_S * 1.1
    assert speaker.accepts("b") and not speaker.accepts("a")


def test_a_claim_beats_who_has_none_and_lasts_through_silence() -> None:
    """Protects: a vehicle node that pauses for breath is not replaced by a stranger."""
    now = Now()
    speaker = Speaker(now)
    assert speaker.accepts("stranger")
    speaker.claim("node", "1", True)
    assert speaker.accepts("node") and not speaker.accepts("stranger")
    speaker.token(True)
    now.s += 100 * QUIET_S
    assert not speaker.accepts("stranger") and speaker.session == "node"
    speaker.claim("node", "1", False)
    speaker.token(False)
    assert not speaker.accepts("stranger")
    speaker.claim("next", "2", True)
    speaker.token(True)
    assert speaker.accepts("next") and not speaker.accepts("node")


def test_the_clock_offset_is_that_of_the_fastest_message() -> None:
    """Protects the expiry of commands: a late message must not look like a clock that is behind."""
    now = Now()
    clock = VehicleClock(now)
    hour = 3_600 * 10**9
    clock.heard(hour + 1_000_000_000, 1_001_000_000)
    clock.heard(hour + 1_000_000_000, 1_900_000_000)
    assert clock.offset_s == pytest.approx(3_600.0 - 0.001)
    assert clock.to_vehicle(5) == hour - 1_000_000 + 5
    now.s += 2 * WINDOW_S
    clock.heard(1_000_000_000, 9_000_000_000)  # after a silence: it had waited for the link
    assert clock.offset_s == pytest.approx(3_600.0 - 0.001)
    for _ in range(3):
        now.s += WINDOW_S / 2
        clock.heard(2_000_000_000, 2_000_000_000)  # set right again
    assert clock.offset_s == 0.0


def test_foreign_text_writes_no_lines_of_ours() -> None:
    """Protects log, terminal and JSON from what a stranger says."""
    odd = "a\nb\x1b[31m\udc80" + "x" * 1000
    told = printable(odd)
    assert told.startswith("a\\nb\\x1b[31m\\udc80") and len(told) == EXAMPLE_CHARS
    told.encode()


def test_the_first_of_each_kind_is_told_and_none_is_unknown() -> None:
    """Protects: nothing silent, and nobody flooded with events."""
    told: list[tuple[str, str]] = []
    tally = Tally(lambda kind, example: told.append((kind, example)))
    for number in range(3):
        tally.note("undecodable", str(number))
    assert told == [("undecodable", "0")]
    (count,) = tally.counts()
    assert (count.count, count.example, tally.total) == (3, "2", 3)
    with pytest.raises(ValueError, match="is no kind"):
        tally.note("nonsense", "")
    assert all(meaning.endswith(".") for meaning in KINDS.values())
