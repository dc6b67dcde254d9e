"""What a request asks for: read and checked here, off the loop, then handed to it."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from google.protobuf.message import DecodeError, Message

from bumpless.config.problems import Problem
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.node.flight import Flight
from bumpless.node.loop import ControlLoop, Handoff
from bumpless.node.order import Order
from bumpless.telemetry import problem_messages, run_id

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

ANSWER_S = 2.0  # longest wait for the loop, many cycles
LARGEST_REQUEST = 1_000_000  # bytes; reading a larger one would take the interpreter from the loop


class Executor:
    """Carries requests out, one for each thread that asks; accepted means done."""

    def __init__(
        self, vehicle: "Vehicle", flight: Flight, loop: ControlLoop, time_ns: Callable[[], int]
    ) -> None:
        self._vehicle = vehicle
        self._flight = flight  # read here; changed by the loop alone
        self._loop = loop
        self._time_ns = time_ns

    def answer(self, order: Order) -> pb.CommandReply:
        """The reply, once the loop has carried the request out or it was refused."""
        verb, payload = order.verb, order.payload
        if verb not in keys.COMMANDS:
            return self.refuse(order, f"there is no command {verb!r}; known are {', '.join(keys.COMMANDS)}")
        if len(payload) > LARGEST_REQUEST:
            return self.refuse(order, f"a request has at most {LARGEST_REQUEST} bytes, not {len(payload)}")
        try:
            request = keys.COMMANDS[verb].FromString(payload)
        except DecodeError:
            return self.refuse(order, f"the request is not a {keys.COMMANDS[verb].DESCRIPTOR.full_name}")
        try:
            return self._carry_out(order, request)
        except Exception as fault:  # one bad request must not leave the vehicle deaf to the next
            return self.refuse(order, f"{type(fault).__name__}: {fault}")

    def refuse(
        self,
        order: Order,
        reason: str,
        problems: Sequence[Problem] = (),
        cause: pb.RefusalCause = pb.REFUSAL_CAUSE_UNSPECIFIED,
    ) -> pb.CommandReply:
        """Say no, and have the loop put it on record."""
        told = problem_messages(problems)
        handoff = Handoff(order.verb, lambda flight: flight.refuse(order.verb, reason, told, cause))
        return self._loop.submit(handoff).reply(ANSWER_S)

    def _carry_out(self, order: Order, request: Message) -> pb.CommandReply:
        if order.verb == "shutdown":
            return pb.CommandReply(accepted=True, reason="the vehicle node is stopping")
        if order.verb == "start":
            return self._start(order, request)
        if order.verb == "set_parameters":
            return self._set_parameters(order, request)
        if order.verb == "abort" and order.stops.starts_wait:
            return self._hand_over(order, Flight.abort_or_stay)
        return self._hand_over(order, lambda flight: getattr(flight, order.verb)())

    def _start(self, order: Order, request: Message) -> pb.CommandReply:
        from bumpless.config.mission import MissionError, parse_mission
        from bumpless.config.parameters import ParameterError, check, with_overrides

        assert isinstance(request, pb.StartMission)
        try:
            mission = parse_mission(request.mission_yaml, request.file_name or "mission.yaml", self._vehicle)
        except MissionError as error:
            return self.refuse(order, "the mission file is not valid", error.problems)
        try:
            parameters = with_overrides(self._flight.chosen, mission.parameters)
        except ParameterError as error:
            return self.refuse(order, "the mission's parameters are not valid", error.problems)
        problems = check(parameters, self._vehicle, mission.source)
        if problems:
            return self.refuse(order, "the mission's parameters are out of range", problems)
        seed = request.seed if request.HasField("seed") else None
        run = run_id(mission.name, self._time_ns())
        return self._hand_over(order, lambda flight: flight.start(mission, seed, parameters, run))

    def _set_parameters(self, order: Order, request: Message) -> pb.CommandReply:
        from bumpless.config.parameters import ParameterError, check, from_message

        assert isinstance(request, pb.Parameters)
        try:
            active = from_message(request, self._flight.state.parameters)
            chosen = from_message(request, self._flight.chosen)
            problems = check(active, self._vehicle)
        except ParameterError as error:
            return self.refuse(order, "parameters are out of range", error.problems)
        if problems:
            return self.refuse(order, "parameters are out of range", problems)
        seen = order.header.if_revision if order.header.HasField("if_revision") else None
        return self._hand_over(order, lambda flight: flight.set_parameters(active, chosen, seen))

    def _hand_over(self, order: Order, apply: Callable[[Flight], pb.CommandReply]) -> pb.CommandReply:
        """Have it applied between two cycles, unless it has become void by then."""

        def unless_void(flight: Flight) -> pb.CommandReply:
            void = order.void()
            return flight.refuse(order.verb, void[0], cause=void[1]) if void else apply(flight)

        handoff = Handoff(order.verb, unless_void)
        return self._loop.submit(handoff).reply(max(0.0, min(ANSWER_S, order.left_s)))
