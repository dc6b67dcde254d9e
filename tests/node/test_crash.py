"""A node that dies in flight leaves word of it: the next one does what the vehicle's file declares."""

import json
from pathlib import Path

import pytest

from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import IDLE, RUNNING
from bumpless.node.memory import Memory
from bumpless.telemetry import FlightState
from tests.node.listening import Listener, light_node_with


def vehicle_file(folder: Path, reaction: str) -> str:
    path = folder / "ts100.toml"
    path.write_text(load_vehicle("ts100").text + f'\n[failsafe]\nafter_crash = "{reaction}"\n')
    return str(path)


@pytest.mark.parametrize(
    ("reaction", "phase"), [("hold", pb.MISSION_PHASE_PAUSED), ("abort", pb.MISSION_PHASE_IDLE)]
)
def test_after_a_crash_in_flight_it_does_what_was_declared(
    bus: Listener, endpoint: str, tmp_path: Path, reaction: str, phase: int
) -> None:
    """Protects: a vehicle whose program died in flight was idle by accident, and nobody was told."""
    memory = tmp_path / "flight.json"
    files = {"vehicle": vehicle_file(tmp_path, reaction), "memory": str(memory)}
    with light_node_with(endpoint, **files) as first:
        bus.until_alive()
        run = bus.start().run_id
        bus.until(lambda: memory.exists() and len(bus.of("tlm/mission")) > 1)
        first.kill()
    bus.until(lambda: bus.alive[-1] is False)
    before = len(bus.of("tlm/mission"))
    with light_node_with(endpoint, **files):
        bus.until_alive(2)
        (event,) = bus.until(lambda: [e for e in bus.of("event") if e.code == "failsafe"])
        assert event.details == {"cause": "after_crash", "reaction": reaction}
        assert run in event.text
        status = bus.until(lambda: [s for s in bus.of("tlm/mission")[before:] if s.phase == phase])[-1]
        assert status.run_id == (run if reaction == "hold" else "")


def test_what_was_not_in_flight_leaves_nothing(tmp_path: Path) -> None:
    """Protects: a node that ended in order, or at rest, must not be taken for a crash."""
    path = tmp_path / "flight.json"
    memory = Memory(path)
    state = FlightState(None)  # type: ignore[arg-type]
    memory.note(IDLE, state, None)
    memory.note(RUNNING, state, None)
    assert not path.exists() and memory.left() is None
    path.write_text("{}")
    assert memory.left() is None
    memory.forget()
    assert not path.exists()
    Memory(None).note(RUNNING, state, None)


@pytest.mark.parametrize("text", ["", "[]", json.dumps({"position_ned_m": 1}), "x" * 3_000_000])
def test_a_spoilt_memory_is_none(tmp_path: Path, text: str) -> None:
    """Protects: what a full disk left half must not keep the node from starting."""
    path = tmp_path / "flight.json"
    path.write_text(text)
    assert Memory(path).left() is None
