"""Requests from the bus: read and checked here, off the loop, then handed to it and answered."""

import threading
from collections.abc import Callable, Sequence
from queue import SimpleQueue
from typing import TYPE_CHECKING

import zenoh
from google.protobuf.message import DecodeError, Message

from bumpless.config.problems import Problem
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.flight import Flight
from bumpless.node.loop import ControlLoop, Handoff
from bumpless.telemetry import problem_messages, run_id

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

ANSWER_S = 2.0  # longest wait for the loop, many cycles
LARGEST_REQUEST = 1_000_000  # bytes; reading a larger one would take the interpreter from the loop


class Commander:
    """Answers `bumpless/<vehicle>/cmd/*`, one request after the other; accepted means done."""

    def __init__(
        self,
        name: str,
        vehicle: "Vehicle",
        flight: Flight,
        loop: ControlLoop,
        time_ns: Callable[[], int],
        shutdown: Callable[[str], None],
    ) -> None:
        self._name = name  # on the bus
        self._vehicle = vehicle
        self._flight = flight  # read here; changed by the loop alone
        self._loop = loop
        self._time_ns = time_ns
        self._shutdown = shutdown
        self._queries: SimpleQueue[zenoh.Query | None] = SimpleQueue()
        self._thread = threading.Thread(target=self._serve, name="commands", daemon=True)

    def start(self) -> None:
        """Begin to answer."""
        self._thread.start()

    def close(self) -> None:
        """Answer what has arrived, then end."""
        self._queries.put(None)
        self._thread.join()

    def enqueue(self, query: zenoh.Query) -> None:
        """The queryable's callback, on Zenoh's thread."""
        self._queries.put(query)

    def _serve(self) -> None:
        while (query := self._queries.get()) is not None:
            with query:
                verb = str(query.key_expr).rsplit("/", 1)[-1]
                payload = b"" if query.payload is None else query.payload.to_bytes()
                reply = self.answer(verb, payload)
                if verb in keys.COMMANDS:
                    query.reply(
                        keys.command(self._name, verb),
                        reply.SerializeToString(),
                        encoding=keys.encoding_of(reply),
                        express=True,
                    )
                else:
                    query.reply_err(reply.reason.encode())
            if verb == "shutdown" and reply.accepted:
                self._shutdown("stopped by command")

    def answer(self, verb: str, payload: bytes) -> pb.CommandReply:
        """The reply to one request, once the loop has carried it out or it was refused."""
        if verb not in keys.COMMANDS:
            return self._refuse(verb, f"there is no command {verb!r}; known are {', '.join(keys.COMMANDS)}")
        if len(payload) > LARGEST_REQUEST:
            return self._refuse(verb, f"a request has at most {LARGEST_REQUEST} bytes, not {len(payload)}")
        try:
            request = keys.COMMANDS[verb].FromString(payload)
        except DecodeError:
            return self._refuse(verb, f"the request is not a {keys.COMMANDS[verb].DESCRIPTOR.full_name}")
        try:
            return self._carry_out(verb, request)
        except Exception as fault:  # one bad request must not leave the vehicle deaf to the next
            return self._refuse(verb, f"{type(fault).__name__}: {fault}")

    def _carry_out(self, verb: str, request: Message) -> pb.CommandReply:
        if verb == "shutdown":
            return pb.CommandReply(accepted=True, reason="the vehicle node is stopping")
        if verb == "start":
            return self._start(request)
        if verb == "set_parameters":
            return self._set_parameters(request)
        return self._hand_over(verb, lambda flight: getattr(flight, verb)())

    def _start(self, request: Message) -> pb.CommandReply:
        from bumpless.config.mission import MissionError, parse_mission
        from bumpless.config.parameters import ParameterError, check, with_overrides

        assert isinstance(request, pb.StartMission)
        try:
            mission = parse_mission(request.mission_yaml, request.file_name or "mission.yaml", self._vehicle)
        except MissionError as error:
            return self._refuse("start", "the mission file is not valid", error.problems)
        try:
            parameters = with_overrides(self._flight.chosen, mission.parameters)
        except ParameterError as error:
            return self._refuse("start", "the mission's parameters are not valid", error.problems)
        problems = check(parameters, self._vehicle, mission.source)
        if problems:
            return self._refuse("start", "the mission's parameters are out of range", problems)
        seed = request.seed if request.HasField("seed") else None
        run = run_id(mission.name, self._time_ns())
        return self._hand_over("start", lambda flight: flight.start(mission, seed, parameters, run))

    def _set_parameters(self, request: Message) -> pb.CommandReply:
        from bumpless.config.parameters import ParameterError, check, from_message

        assert isinstance(request, pb.Parameters)
        try:
            active = from_message(request, self._flight.state.parameters)
            chosen = from_message(request, self._flight.chosen)
            problems = check(active, self._vehicle)
        except ParameterError as error:
            return self._refuse("set_parameters", "parameters are out of range", error.problems)
        if problems:
            return self._refuse("set_parameters", "parameters are out of range", problems)
        return self._hand_over("set_parameters", lambda flight: flight.set_parameters(active, chosen))

    def _refuse(self, verb: str, reason: str, problems: Sequence[Problem] = ()) -> pb.CommandReply:
        told = problem_messages(problems)
        return self._hand_over(verb, lambda flight: flight.refuse(verb, reason, told))

    def _hand_over(self, verb: str, apply: Callable[[Flight], pb.CommandReply]) -> pb.CommandReply:
        return self._loop.submit(Handoff(verb, apply)).reply(ANSWER_S)
