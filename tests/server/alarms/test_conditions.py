"""What the server is alarmed at, each kind by the messages that cause and end it."""

import math
from collections.abc import Callable, Iterable, Sequence
from math import nan
from pathlib import Path

import pytest
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.alarms.conditions import Conditions
from bumpless_server.alarms.limits import Limits, read_limits

NOW_NS = 1_800_000_000_000_000_000
TOPICS = {
    pb.Event: "event",
    pb.ServerStatus: "server/status",
    pb.VehicleDescription: "tlm/description",
    pb.ParametersStatus: "tlm/parameters",
    pb.Navigation: "tlm/navigation",
    pb.Guidance: "tlm/guidance",
    pb.Supervisor: "tlm/supervisor",
    pb.Control: "tlm/control",
    pb.Actuators: "tlm/actuators",
}


class Heard:
    """Conditions, and which of them hold."""

    def __init__(
        self, limits: Limits | None = None, free_bytes: Callable[[], float] = lambda: math.inf
    ) -> None:
        self.conditions = Conditions(limits or Limits(), free_bytes)
        self.holds: dict[str, str] = {}
        self.ever: dict[str, str] = {}

    def __call__(self, *messages: Message) -> None:
        for message in messages:
            for code, cause in self.conditions.hear(TOPICS[type(message)], message, NOW_NS):
                if cause is None:
                    self.holds.pop(code, None)
                else:
                    self.holds[code] = self.ever[code] = cause[1]


def cycle(
    at_s: float, depth: float = 3.0, z: tuple[float, float] = (0.0, 0.0), rpm: float = 0.0, phase: int = 2
) -> Iterable[Message]:
    """One cycle in hover with reference depth 3 m; z: demanded and achieved, N."""
    stamp = pb.Stamp(time_ns=NOW_NS + round(at_s * 1e9))
    vertical = pb.Actuator(
        name="n_v1", command=rpm, amplitude_lower=-200, amplitude_upper=200, saturated=abs(rpm) >= 200
    )
    return (
        pb.Guidance(stamp=stamp, depth_reference_m=3.0),
        pb.Supervisor(stamp=stamp, mode=pb.MODE_HOVER, phase=phase),  # type: ignore[arg-type]
        pb.Control(stamp=stamp, demanded=pb.Wrench(z_n=z[0]), achieved=pb.Wrench(z_n=z[1])),
        pb.Navigation(stamp=stamp, depth_m=depth),
        pb.Actuators(stamp=stamp, actuators=[vertical]),
    )


def seconds(first: float, last: float) -> Sequence[float]:
    return [first + 0.5 * k for k in range(round(2 * (last - first)) + 1)]


def test_a_depth_beside_its_reference_is_told_with_its_likely_cause() -> None:
    """Protects: depth was beside its reference for 15 s and nothing was said."""
    heard = Heard()
    for t in seconds(0.0, 17.5):
        heard(*cycle(t, depth=2.2, z=(0.72, 0.72), rpm=188.0))
    assert heard.holds == {}, "just after a switch, and not for long enough"
    for t in seconds(18.0, 19.0):
        heard(*cycle(t, depth=2.2, z=(0.72, 0.72), rpm=188.0))
    text = heard.holds["tracking_depth"]
    assert text == "Depth is too small by 0.80 m in hover: Z demand 0.72 N, n_v1 at 94 %."
    heard(*cycle(19.5, depth=2.9))
    assert heard.holds == {}


def test_a_demand_that_is_not_met_is_named_and_so_is_one_that_does_not_suffice() -> None:
    """Protects the operator's next step: more thrust, or another gain."""
    for z, words in (
        ((2.0, 1.2), "Z demand 2.00 N, 1.20 N of it achieved"),
        ((0.3, 0.3), "does not suffice"),
    ):
        heard = Heard(Limits(after_switch_s=0.0, for_s=1.0))
        for t in seconds(0.0, 2.0):
            heard(*cycle(t, depth=3.5, z=z))
        assert words in heard.holds["tracking_depth"]


def test_nothing_is_tracked_that_is_not_flown() -> None:
    """Protects from an alarm about a vehicle that is aborted and drifts, as it must."""
    heard = Heard(Limits(after_switch_s=0.0, for_s=0.0))
    for t in seconds(0.0, 3.0):
        heard(*cycle(t, depth=0.0, phase=pb.MISSION_PHASE_ABORTED))
    assert heard.holds == {}


def test_an_actuator_at_its_bound_for_long_is_named() -> None:
    """Protects the margin that has been used up."""
    heard = Heard()
    for t in seconds(0.0, 5.0):
        heard(*cycle(t, rpm=200.0))
    assert heard.holds["saturated"] == "At its bound for 5 s and longer: n_v1."
    heard(*cycle(5.5, rpm=150.0))
    assert "saturated" not in heard.holds


def test_a_node_that_comes_back_is_told_and_so_are_its_lost_parameters() -> None:
    """Protects: tuned weights were back at their defaults without a word."""
    heard = Heard()
    heard(pb.VehicleDescription(session_id="one"), pb.ParametersStatus(sha256="tuned", revision=4))
    heard(pb.VehicleDescription(session_id="one"), pb.ParametersStatus(sha256="tuned", revision=4))
    assert heard.ever == {}
    heard(pb.VehicleDescription(session_id="two"), pb.ParametersStatus(sha256="default", revision=1))
    assert set(heard.ever) == {"node_restarted", "parameters_lost"}
    assert "revision 1" in heard.ever["parameters_lost"]
    kept = Heard()
    kept(pb.VehicleDescription(session_id="one"), pb.ParametersStatus(sha256="same", revision=1))
    kept(pb.VehicleDescription(session_id="two"), pb.ParametersStatus(sha256="same", revision=1))
    assert set(kept.ever) == {"node_restarted"}


def test_a_link_is_lost_until_it_is_live_again() -> None:
    """Protects the difference between over and seen."""
    heard = Heard()
    heard(pb.Event(severity=pb.SEVERITY_ALARM, code="link_lost", text="Lost."))
    heard(pb.ServerStatus(link=pb.LINK_STATE_LOST))
    assert "link_lost" in heard.holds
    heard(pb.ServerStatus(link=pb.LINK_STATE_LIVE))
    assert "link_lost" not in heard.holds


@pytest.mark.parametrize(
    ("code", "severity", "latched"),
    [
        ("leak", pb.SEVERITY_ALARM, True),
        ("waved_off", pb.SEVERITY_WARNING, True),
        ("command_refused", pb.SEVERITY_WARNING, False),
        ("mode_switch", pb.SEVERITY_INFO, False),
    ],
)
def test_events_that_a_person_must_know_of(code: str, severity: "pb.Severity", latched: bool) -> None:
    """Protects: every alarm's event is one to be seen; what is told to whoever asked is none."""
    heard = Heard()
    heard(pb.Event(severity=severity, code=code, text="x"))
    assert (code in heard.ever) is latched and heard.holds == {}


def test_a_clock_of_1970_and_values_that_are_no_numbers() -> None:
    """Protects: both looked like a vehicle in good health."""
    heard = Heard()
    heard(pb.Navigation(stamp=pb.Stamp(time_ns=1), depth_m=nan))
    assert "57 years behind" in heard.holds["clock_offset"]
    assert "not_finite" in heard.holds
    heard(*cycle(0.0))
    assert heard.holds == {}


def test_a_vehicle_that_moves_unrecorded() -> None:
    """Protects: after its mission thrusters ran on, and nothing said that nobody recorded them."""
    heard = Heard()
    heard(*cycle(0.0, phase=pb.MISSION_PHASE_COMPLETED))
    heard(pb.ServerStatus(recorder_trouble="the disk is full", link=pb.LINK_STATE_LIVE))
    assert "the disk is full" in heard.holds["not_recorded"]
    heard(*cycle(0.0, phase=pb.MISSION_PHASE_ABORTED))
    heard(pb.ServerStatus(recorder_trouble="the disk is full", link=pb.LINK_STATE_LIVE))
    assert heard.holds == {}


def test_limits_come_from_a_file_of_the_vehicle(tmp_path: Path) -> None:
    """Protects: what a file does not set, or sets wrongly, keeps its default."""
    path = tmp_path / "ts100.toml"
    assert read_limits(path) == Limits()
    path.write_text("depth_m = 0.1\n")
    assert read_limits(path) == Limits(depth_m=0.1)
    for wrong in ("depth = 0.1\n", "depth_m = -1\n", "depth_m ="):
        path.write_text(wrong)
        assert read_limits(path) == Limits()


def test_depth_and_area_are_watched_where_a_file_says_so() -> None:
    """Protects the vehicle from the ground and from traffic, drifting too; without a file nobody knows."""
    far = pb.Navigation(
        stamp=pb.Stamp(time_ns=NOW_NS), position_ned_m=pb.Vector3(x=60.0, y=80.0), depth_m=12.0
    )
    silent = Heard()
    silent(far)
    assert silent.holds == {}
    heard = Heard(Limits(deepest_m=10.0, area_m=90.0))
    heard(far)
    assert heard.holds["too_deep"].startswith("Depth 12.0 m is greater than the 10 m")
    assert "100 m from the mission's start" in heard.holds["outside_area"]
    heard(pb.Navigation(stamp=pb.Stamp(time_ns=NOW_NS), depth_m=3.0))
    assert heard.holds == {}


def test_a_disk_that_fills_is_told_before_the_recorder_stops() -> None:
    """Protects the log of a flight that is still to come."""
    heard = Heard(free_bytes=lambda: 5e8)
    heard(pb.ServerStatus(link=pb.LINK_STATE_LIVE))
    assert heard.holds["disk"] == "The disk of the runs has 500 MB left, less than 2000 MB."
