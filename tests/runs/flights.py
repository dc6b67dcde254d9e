"""One real flight, flown once and logged once, and ways to log parts of it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from bumpless import Run, fly, load_mission
from bumpless.config.mission import parse_mission
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import encoded
from bumpless.runs.flown import Flown
from bumpless.runs.names import COMPLETE
from bumpless.runs.names import MISSION as MISSION_STATUS
from bumpless.runs.view import View
from bumpless.runs.writer import Beside, RunWriter
from bumpless.sim.twin import Result

MISSION = "docking.yaml"
START_NS = 1_700_000_000_000_000_000
FLUSH_EVERY = 160  # messages, about a second

Told = tuple[int, str, str, bytes]  # time, topic, schema, payload


@dataclass(frozen=True)
class Flight:
    """A flown mission, what the bus would have carried, and its log, recorded with a delay of 1 µs."""

    run: Run
    bus: list[Told]
    path: Path

    @property
    def kept(self) -> list[Told]:
        """What a log of it holds: all of the bus, and how it ended."""
        *_, (topic, event) = self.run.messages()
        return [*self.bus, (self.bus[-1][0], topic, event.DESCRIPTOR.full_name, encoded(event))]

    @property
    def result(self) -> Result:
        """The LOG rows behind the run."""
        source = self.run._source
        assert isinstance(source, Flown)
        return source.result


def on_bus(run: Run) -> list[Told]:
    """What the bus carries while a run is flown live."""
    source = run._source
    assert isinstance(source, Flown)
    return [
        (time_ns, topic, message.DESCRIPTOR.full_name, encoded(message))
        for time_ns, topic, message in source.timed()
    ]


def make_flight(folder: Path, views: Sequence[View] = ()) -> Flight:
    """The docking mission's first 60 s: all three modes."""
    text = load_mission("docking").text.replace("duration_s: 90", "duration_s: 60")
    run = fly(parse_mission(text, MISSION), started_ns=START_NS)
    bus = on_bus(run)
    path = folder / f"{run.info.id}.mcap"
    record(path, bus, views=views, delay_ns=1000, flush_every=FLUSH_EVERY)
    return Flight(run, bus, path)


def begin(path: Path, views: Sequence[View] = (), run: str = "run-1", **status: object) -> RunWriter:
    """A writer of a run that has just begun."""
    return RunWriter(path, pb.MissionStatus(**({"run_id": run} | status)), path.stem, views)  # type: ignore[arg-type]


def record(
    path: Path,
    bus: Iterable[Told],
    views: Sequence[View] = (),
    delay_ns: int = 0,
    flush_every: int = 10**9,
    depths: Beside = lambda plan: None,
) -> None:
    """Record messages of the bus as a live recorder would."""
    bus = list(bus)
    first = next((payload for _, topic, _, payload in bus if topic == MISSION_STATUS), b"")
    status = pb.MissionStatus.FromString(first)
    status.run_id = status.run_id or "run-1"
    writer = RunWriter(path, status, path.stem, views, depths=depths)
    for i, (time_ns, topic, schema, payload) in enumerate(bus):
        writer.write(topic, schema, payload, time_ns + delay_ns)
        if topic == MISSION_STATUS:
            writer.status = pb.MissionStatus.FromString(payload)
        if i % flush_every == flush_every - 1:
            writer.flush()
    writer.finish(COMPLETE, "done")
