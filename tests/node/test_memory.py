"""What the node's threads hold does not grow with the length of a run."""

import gc
import multiprocessing
import tracemalloc
from concurrent.futures import ProcessPoolExecutor
from itertools import pairwise
from pathlib import Path

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.node.flight import Flight
from bumpless.node.loop import ControlLoop
from bumpless.node.pacing import FreeClock
from bumpless.node.ring import Cycle, Ring
from bumpless.sim.twin import Twin
from bumpless.telemetry import Teller

DOCKING = Path(__file__).parents[2] / "missions" / "docking.yaml"
MINUTE = 1200  # cycles


def test_what_it_holds_does_not_grow_with_every_mission():
    """Protects: a vehicle that flies for days; every row, event and message is let go of."""
    # in a process of its own: what other tests' threads hold grows with time, and is counted too
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as alone:
        cycles, said, held = alone.submit(fly_on).result()
    assert cycles == 20 + 12 * MINUTE and said > 8 * cycles
    # what leaks, leaks each time; what was made elsewhere long before may be moved to a larger place once
    assert min(after - before for before, after in pairwise(held)) < 10_000


def fly_on() -> tuple[int, int, list[int]]:
    """Cycles flown, messages made, and the bytes held by Python and NumPy after every other minute."""
    vehicle = load_vehicle("ts100")
    twin, ring = Twin(vehicle), Ring()
    flight = Flight(twin)
    loop = ControlLoop(flight, FreeClock(round(twin.period_s * 1e9)), ring)
    teller = Teller(vehicle, twin.parameters)
    said = 0

    def tell(cycle: Cycle) -> None:
        nonlocal said
        for _, message in teller.tell(cycle.row, cycle.state, cycle.events, cycle.time_ns, cycle.number):
            message.SerializeToString(deterministic=True)
            said += 1

    def fly(cycles: int) -> int:
        """Bytes held after so many more cycles, again and again on the same mission."""
        for _ in range(cycles):
            if twin.phase != pb.MISSION_PHASE_RUNNING:
                flight.start(mission, None, twin.parameters, "run")
            loop._cycle()
            ring.take_all(tell)
        gc.collect()
        return tracemalloc.get_traced_memory()[0]

    mission = parse_mission(DOCKING.read_text(encoding="utf-8"), DOCKING.name, vehicle)
    fly(20)  # what is imported and cached once
    tracemalloc.start()
    fly(2 * MINUTE)  # a mission to its end and the next begun: what each kind of moment caches once
    held = [fly(2 * MINUTE) for _ in range(5)]
    return loop.cycles, said, held
