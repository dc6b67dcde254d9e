"""One real flight, flown once and logged once, for all tests of logs."""

from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.sim.twin import Result, simulate
from bumpless.telemetry import run_messages
from bumpless_server.runs.writer import LogWriter

MISSION = Path(__file__).parents[3] / "missions" / "docking.yaml"
START_NS = 1_700_000_000_000_000_000
FLUSH_EVERY = 160  # messages, about a second


@dataclass(frozen=True)
class Flight:
    """A flown mission, what the bus would have carried, and its log."""

    result: Result
    bus: list[tuple[int, str, str, bytes]]  # time, topic, schema, payload
    path: Path


@pytest.fixture(scope="session")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    """The docking mission's first 60 s: all three modes."""
    mission = replace(parse_mission(MISSION.read_text(encoding="utf-8"), MISSION.name), duration_s=60.0)
    result = simulate(mission, load_vehicle("ts100"))
    bus = [
        (time_ns, topic, message.DESCRIPTOR.full_name, message.SerializeToString())
        for time_ns, topic, message in run_messages(result, "run-1", START_NS)
    ]
    path = tmp_path_factory.mktemp("log") / "run-1.mcap"
    with LogWriter(path, {"run_id": "run-1", "mission_sha256": mission.sha256}) as log:
        log.attach(MISSION.name, "application/yaml", mission.text.encode())
        for i, (time_ns, topic, schema, payload) in enumerate(bus):
            log.write(topic, schema, payload, time_ns + 1000, time_ns)
            if i % FLUSH_EVERY == 0:
                log.flush()
        log.metadata("end", {"state": "complete"})
    return Flight(result, bus, path)
