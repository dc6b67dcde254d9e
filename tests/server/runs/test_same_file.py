"""One format, one writer: a flight recorded live and the same flight saved at once are the same file."""

from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap.records import Attachment, Channel, Message, Metadata, Schema
from mcap.stream_reader import StreamReader

from bumpless.runs.names import ENDING
from bumpless.runs.summary import summarise
from bumpless_server.live.sample import Sample
from bumpless_server.runs.recorder import Recorder
from bumpless_server.views.foxglove import Foxglove
from tests.runs.flights import Flight, make_flight
from tests.server.runs.clock import Clock

DELAY_NS = 1_000_000  # from the vehicle to the server


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    """A docking flight's first minute."""
    return make_flight(tmp_path_factory.mktemp("flight"))


def recorded(folder: Path, flight: Flight, clock: Clock, delay_ns: int = 0, ticks: bool = False) -> Path:
    """What the live recorder makes of the flight's messages, received `delay_ns` after they were made."""
    folder.mkdir()
    recorder = Recorder(folder, lambda *_: None, lambda _: None, lambda: (Foxglove(),))
    for time_ns, topic, schema, payload in flight.bus:
        if ticks:
            clock.now = 1000.0 + (time_ns - flight.bus[0][0]) * 1e-9
        recorder._worker._handle(Sample(topic, schema, payload, time_ns + delay_ns))
        if ticks:
            recorder._worker._on_time()
    recorder._close()
    return folder / f"{flight.run.info.id}{ENDING}"


def test_the_operator_hears_how_a_recorded_run_ended(
    flight: Flight, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: the server's judgement reaches the screen and the list, and is the saved run's own."""
    Clock(monkeypatch)
    told: list[tuple] = []
    recorder = Recorder(tmp_path, lambda *said: told.append(said), lambda _: None)
    for time_ns, topic, schema, payload in flight.bus:
        recorder._worker._handle(Sample(topic, schema, payload, time_ns))
    recorder._close()
    outcome, run = flight.run.outcome, flight.run.info.id
    assert [(code, text, details["run"]) for _, code, text, details in told] == [
        ("outcome", outcome.sentence, run)
    ]
    summary = summarise(tmp_path / f"{run}{ENDING}")
    assert (summary.outcome, summary.outcome_reason) == (outcome.ending, outcome.reason)
    assert summary.metrics is not None and summary.metrics["outcome"]["reason"] == outcome.reason


def records(path: Path) -> list[object]:
    """Every record of the data in order; how it is cut into chunks is left out."""
    kept = (Schema, Channel, Message, Attachment, Metadata)
    with path.open("rb") as file:
        return [record for record in StreamReader(file).records if isinstance(record, kept)]


def test_the_same_messages_at_the_same_times_are_the_same_bytes(
    flight: Flight, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: names, metadata, hashes, attachments, views and figures are decided once, by no clock."""
    saved = flight.run.save(tmp_path / "saved.mcap", [Foxglove()])
    live = recorded(tmp_path / "live", flight, Clock(monkeypatch))
    assert live.read_bytes() == saved.read_bytes()
    again = flight.run.save(tmp_path / "again.mcap", [Foxglove()])
    assert again.read_bytes() == saved.read_bytes()


def test_a_live_recording_differs_in_its_times_and_in_where_chunks_end(
    flight: Flight, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: what is named as different is all that is: log times by the delay, chunks by the flushes."""
    saved = flight.run.save(tmp_path / "saved.mcap", [Foxglove()])
    live = recorded(tmp_path / "live", flight, Clock(monkeypatch), DELAY_NS, ticks=True)
    with live.open("rb") as one, saved.open("rb") as other:
        chunks = [len(make_reader(file).get_summary().chunk_indexes) for file in (one, other)]  # type: ignore[union-attr]
    assert chunks[0] > 55 and chunks[1] < 10

    def untimed(record: object) -> object:
        if isinstance(record, Message):
            return (record.channel_id, record.sequence, record.publish_time, record.data)
        if isinstance(record, Attachment):
            return (record.name, record.media_type, record.data)
        if isinstance(record, Metadata):
            return (record.name, {k: v for k, v in record.metadata.items() if k != "ended_ns"})
        return record

    assert in_order(live, untimed) == in_order(saved, untimed)
    times = [[r.log_time for r in records(path) if isinstance(r, Message)] for path in (live, saved)]
    assert {late - soon for late, soon in zip(*times, strict=True)} == {DELAY_NS}


def in_order(path: Path, untimed: object) -> list[object]:
    """Messages in order, then the rest in order: an attachment stands between chunks, not messages."""
    assert callable(untimed)
    found = [untimed(record) for record in records(path)]
    return sorted(found, key=lambda record: not (isinstance(record, tuple) and isinstance(record[0], int)))
