"""A log looked at from the middle tells what the whole of it tells."""

from itertools import pairwise
from pathlib import Path

import pytest

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import decoded, encoded
from bumpless.runs.flight_replay import FlightReplay
from bumpless.runs.flown import Flown
from bumpless.runs.info import ending_of
from bumpless.runs.names import MISSION as MISSION_TOPIC
from bumpless.runs.replay import NoReplay, Replay
from bumpless.runs.writer import RunWriter

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A saved flight."""
    return bumpless.fly(MISSION).save(tmp_path_factory.mktemp("log") / "a.mcap")


@pytest.fixture(scope="module")
def replay(log: Path) -> Replay:
    return Replay(log)


def messages(frame: pb.StreamFrame) -> dict:
    return {m.topic: decoded(m.schema, m.payload) for m in frame.messages}


def test_the_whole_range_is_every_cycle_with_its_messages(log: Path, replay: Replay) -> None:
    """Protects plots from gaps: every cycle comes once, in order, whole, with the bus's own bytes."""
    told = [message for topic, message in bumpless.open_run(log).messages() if topic == "tlm/control"]
    frames = list(replay.frames(replay.first_s, replay.last_s, 10_000))
    controls = [messages(frame)["tlm/control"] for frame in frames]
    assert controls == told
    assert len(frames) == replay.cycles
    whole = {"tlm/navigation", "tlm/guidance", "tlm/supervisor", "tlm/actuators", "tlm/allocation"}
    assert all(whole <= messages(frame).keys() for frame in frames)


@pytest.mark.parametrize("most", [1, 7, 100, 1799])
def test_a_long_range_is_thinned_evenly(replay: Replay, most: int) -> None:
    """Protects the browser from a two-hour log: no more than asked for, over all of the range."""
    times = [
        messages(frame)["tlm/navigation"].stamp.mission_time_s for frame in replay.frames(10.0, 70.0, most)
    ]
    assert len(times) <= most and times[0] == pytest.approx(10.0, abs=0.051)
    steps = {round(b - a, 6) for a, b in pairwise(times)}
    assert len(steps) <= 1
    if most >= 100:
        assert times[-1] > 68.0


@pytest.mark.parametrize("time_s", [0.0, 31.2, 60.03, 1e6])
def test_a_moment_is_the_last_of_each_topic_and_nothing_later(replay: Replay, time_s: float) -> None:
    """Protects a seek: slow topics are those that held then, not the next ones."""
    told = messages(replay.at(time_s))
    assert {"tlm/navigation", "tlm/mission", "tlm/plan", "tlm/parameters", "tlm/description"} <= told.keys()
    assert all(message.stamp.mission_time_s <= time_s + 1e-6 for message in told.values())
    last = min(time_s, replay.last_s)
    assert told["tlm/navigation"].stamp.mission_time_s == pytest.approx(last, abs=0.051)
    assert told["tlm/mission"].stamp.mission_time_s > last - 0.6


def test_before_the_beginning_there_is_nothing(replay: Replay) -> None:
    """Protects from a seek that shows the start as if it had been."""
    assert list(replay.at(-10.0).messages) == []
    assert list(replay.frames(-20.0, -10.0, 10)) == []


def test_events_come_in_order(replay: Replay) -> None:
    """Protects the marks on the scrubber."""
    events = replay.events()
    times = [event.stamp.mission_time_s for event in events]
    assert times == sorted(times) and {"mode_switch", "outcome"} <= {event.code for event in events}


def test_what_has_no_index_is_refused_in_words(tmp_path: Path, log: Path) -> None:
    """Protects: a cut file is repaired first, and rubbish is no log."""
    for data in (b"", b"rubbish" * 100, log.read_bytes()[:200_000]):
        path = tmp_path / "bad.mcap"
        path.write_bytes(data)
        with pytest.raises(NoReplay):
            Replay(path)


def test_what_is_missing_within_a_file_is_told(tmp_path: Path) -> None:
    """Protects from a stretch that nobody recorded and that looks flown; a slower pace is no gap."""
    run = bumpless.fly(MISSION)
    source = run._source
    assert isinstance(source, Flown)
    start_ns = source.started_ns
    told = []
    for time_ns, topic, message in source.timed():
        t = (time_ns - start_ns) * 1e-9
        rare = t > 60.0 and round(t / 0.05) % 20  # once a second, as a hold is recorded
        if not (12.0 < t < 20.0 or (rare and topic.startswith("tlm/"))):
            told.append((time_ns, topic, message))
    status = next(message for _, topic, message in told if topic == MISSION_TOPIC)
    path = tmp_path / "gap.mcap"
    writer = RunWriter(path, status, path.stem, durable=False)
    for time_ns, topic, message in told:
        writer.write(topic, message.DESCRIPTOR.full_name, encoded(message), time_ns, message)
    writer.finish(*ending_of(status))
    assert FlightReplay([path]).gaps == [pytest.approx((12.0, 20.0), abs=0.051)]


def test_a_whole_log_has_no_gap(replay: Replay) -> None:
    """Protects from hatching where all was recorded."""
    assert replay.gaps == []
