"""The vehicle node as a process: from its arguments to its exit code."""

import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from bumpless.contract import keys
from bumpless.contract.exits import FAILED, TAKEN
from bumpless.node.stop import Stop

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle
    from bumpless.node.flight import TwinLike


@dataclass(frozen=True)
class Options:
    """How one node is run; see `main`."""

    vehicle_id: str
    vehicle_file: str | Path | None = None
    connect: Sequence[str] = ()
    listen: Sequence[str] = ()
    realtime: bool = True
    mission: str | Path | None = None
    mode: str | None = None
    make_twin: "Callable[[Vehicle], TwinLike] | None" = None
    zenoh_config: Path | None = None
    memory: Path | None = None


def say(text: str) -> None:
    """Progress and faults, one line each, on stderr."""
    print(f"bumpless vehicle: {text}", file=sys.stderr, flush=True)


def main(
    vehicle_id: str,
    vehicle_file: str | Path | None = None,
    connect: Sequence[str] = (),
    listen: Sequence[str] = (),
    realtime: bool = True,
    mission: str | Path | None = None,
    mode: str | None = None,
    make_twin: "Callable[[Vehicle], TwinLike] | None" = None,
    zenoh_config: Path | None = None,
    memory: Path | None = None,
) -> int:
    """Run the vehicle `vehicle_id` on the bus until SIGTERM, SIGINT or its `shutdown` command.

    `vehicle_file` is a vehicle's name or path; without it the one named like the id. `connect` and
    `listen` are Zenoh endpoints, `mode` is "peer" or "client" (chosen by the endpoints when None, see
    `bumpless.node.session.choose_mode`). `mission` is a file to fly as soon as the node is ready. Without
    `realtime` a mission is flown in virtual time, as fast as the bus takes it. `make_twin` replaces the
    simulated vehicle. `zenoh_config` is a Zenoh configuration file, which then says all of the session.
    `memory` is the file by which a node that comes back from a crash knows that it was in flight. To be
    called from the main thread.

    Returns the exit code: 0 after a stop that was asked for, 1 after a failure, 3 when the id is taken.
    """
    from bumpless.config.problems import ProblemsError

    stop = Stop()
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda which, frame: stop(f"stopped by {signal.Signals(which).name}"))
    options = Options(
        vehicle_id, vehicle_file, connect, listen, realtime, mission, mode, make_twin, zenoh_config, memory
    )
    try:
        keys.check_vehicle_id(vehicle_id)
        return _run(options, stop)
    except (ProblemsError, OSError, ValueError) as error:
        say(str(error))
        return FAILED


def _run(options: Options, stop: Stop) -> int:
    import zenoh

    from bumpless.config.vehicle import load_vehicle
    from bumpless.contract.session import endpoints_of, session_file
    from bumpless.node.claim import Claim, TakenError
    from bumpless.node.memory import Memory
    from bumpless.node.node import Node
    from bumpless.node.prepare import ready_twin, start_request
    from bumpless.node.priority import raise_process
    from bumpless.node.session import node_config, open_session

    vehicle = load_vehicle(str(options.vehicle_file or options.vehicle_id))
    first = None if options.mission is None else start_request(Path(options.mission))
    try:
        if options.zenoh_config is None:
            config = node_config(options.connect, options.listen, options.mode)
        else:
            config = session_file(options.zenoh_config)
        session = open_session(config, stop.event, say)
    except zenoh.ZError as error:
        say(f"cannot open the bus: {error}")
        return FAILED
    if session is None:
        return stop.code
    with session:
        connects = bool(endpoints_of(config)[0])
        claim = Claim(session, options.vehicle_id, connects)
        try:
            claim.stake()
            twin = ready_twin(vehicle, options.make_twin, say)
            claim.confirm()
        except TakenError as error:
            say(str(error))
            return TAKEN
        raise_process()
        memory = Memory(options.memory)
        node = Node(session, options.vehicle_id, vehicle, twin, stop, options.realtime, memory)
        fault = None if stop.event.is_set() else node.run(claim, first, say)
        claim.release()
    say(stop.reason)
    if fault is not None:
        raise fault
    return stop.code
