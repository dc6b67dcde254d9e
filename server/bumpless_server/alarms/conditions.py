"""What there is to be alarmed at, in what the server hears: pure, one message after the other."""

from collections.abc import Callable, Iterator
from math import hypot, inf, isfinite
from typing import Any

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FLYING, MOVING
from bumpless_server.alarms.limits import Limits
from bumpless_server.alarms.tracking import TrackingWatch

CYCLE = ("navigation", "guidance", "supervisor", "control")
WARNING, ALARM = pb.SEVERITY_WARNING, pb.SEVERITY_ALARM
# a warning's event that a person must know of, by code; all alarms are
LATCHED = ("fault_detected", "target_lost", "waved_off", "docking_ended", "node_elsewhere")
# the event that ends another's cause; without one an event is over as soon as it has happened
ENDED_BY = {
    "fault_cleared": "fault_detected",
    "target_found": "target_lost",
    "recording_again": "recorder_failed",
}
LASTING = frozenset({*ENDED_BY.values(), "link_lost"})

# (code, None when the cause has gone else (severity, text))
Change = tuple[str, tuple[int, str] | None]


class Conditions:
    """Feed it every sample; it gives what has come and what has gone. `free_bytes`: of the runs' disk."""

    def __init__(self, limits: Limits, free_bytes: Callable[[], float] = lambda: inf) -> None:
        self._limits, self._free_bytes = limits, free_bytes
        self._tracking = TrackingWatch(limits)
        self._last: dict[str, Message] = {}
        self._session, self._parameters, self._lost_parameters = "", "", ""
        self._saturated: dict[str, float] = {}

    def hear(self, topic: str, message: Message, receive_ns: int) -> Iterator[Change]:
        """What follows from one message."""
        self._last[topic] = message
        if isinstance(message, pb.Event):
            yield from self._event(message)
        elif isinstance(message, pb.VehicleDescription):
            yield from self._node(message)
        elif isinstance(message, pb.ParametersStatus):
            yield from self._told_parameters(message)
        elif isinstance(message, pb.ServerStatus):
            yield from self._server(message)
        elif isinstance(message, pb.Navigation):
            yield from self._navigation(message, receive_ns)
        elif isinstance(message, pb.Actuators):
            yield from self._cycle(message)

    def _event(self, event: pb.Event) -> Iterator[Change]:
        if event.code in ENDED_BY:
            yield ENDED_BY[event.code], None
        if event.severity >= ALARM or event.code in LATCHED:
            yield event.code, (event.severity, event.text)
            if event.code not in LASTING:
                yield event.code, None  # happened, and is over: it stays until it was seen

    def _node(self, description: pb.VehicleDescription) -> Iterator[Change]:
        session, before = description.session_id, self._session
        self._session = session
        if before and session and session != before:
            self._lost_parameters = self._parameters
            text = "The vehicle's node was started anew: what was flown is over, what was set is gone."
            yield "node_restarted", (ALARM, text)
            yield "node_restarted", None

    def _told_parameters(self, status: pb.ParametersStatus) -> Iterator[Change]:
        before, self._lost_parameters = self._lost_parameters, ""
        self._parameters = status.sha256
        if before and before != status.sha256:
            text = (
                f"Parameters lost: since its restart the vehicle flies with revision {status.revision}, "
                "which is not what was set."
            )
            yield "parameters_lost", (ALARM, text)
            yield "parameters_lost", None

    def _server(self, status: pb.ServerStatus) -> Iterator[Change]:
        if status.link == pb.LINK_STATE_LIVE:
            yield "link_lost", None
        elif status.link == pb.LINK_STATE_LOST:
            self._tracking.reset()
        if status.recorder_trouble and not status.recording and self._phase in MOVING:
            text = f"The vehicle moves and is not recorded: {status.recorder_trouble}."
            yield "not_recorded", (ALARM, text)
        else:
            yield "not_recorded", None
        free_mb = self._free_bytes() / 1e6
        text = f"The disk of the runs has {free_mb:.0f} MB left, less than {self._limits.disk_mb:g} MB."
        yield "disk", (WARNING, text) if free_mb < self._limits.disk_mb else None

    def _navigation(self, nav: pb.Navigation, receive_ns: int) -> Iterator[Change]:
        off_s = (nav.stamp.time_ns - receive_ns) * 1e-9
        if abs(off_s) > self._limits.clock_s:
            way = "ahead of" if off_s > 0 else "behind"
            text = (
                f"The vehicle's clock is {_long(abs(off_s))} {way} the server's: times of its runs are wrong."
            )
            yield "clock_offset", (WARNING, text)
        else:
            yield "clock_offset", None
        p, a = nav.position_ned_m, nav.attitude
        bad = not all(map(isfinite, (p.x, p.y, p.z, a.roll_deg, a.pitch_deg, a.yaw_deg, nav.depth_m)))
        text = "Navigation tells values that are no numbers: the vehicle does not know where it is."
        yield "not_finite", (ALARM, text) if bad else None
        yield from self._bounds(nav)

    def _bounds(self, nav: pb.Navigation) -> Iterator[Change]:
        """Depth and area, whatever is flown: a vehicle that drifts leaves them too."""
        deepest, area = self._limits.deepest_m, self._limits.area_m
        if deepest is not None:
            text = f"Depth {nav.depth_m:.1f} m is greater than the {deepest:g} m that are allowed."
            yield "too_deep", (ALARM, text) if nav.depth_m > deepest else None
        if area is not None:
            away = hypot(nav.position_ned_m.x, nav.position_ned_m.y)
            text = f"The vehicle is {away:.0f} m from the mission's start, outside its area of {area:g} m."
            yield "outside_area", (ALARM, text) if away > area else None

    @property
    def _phase(self) -> int:
        return getattr(self._last.get("tlm/supervisor"), "phase", 0)

    def _cycle(self, actuators: pb.Actuators) -> Iterator[Change]:
        if self._phase not in FLYING:
            self._tracking.reset()
            self._saturated.clear()
            return
        parts: Any = [self._last.get(f"tlm/{name}") for name in CYCLE]
        if any(part is None for part in parts):
            return
        nav, guidance, supervisor, control = parts
        lasting = {o.name: o for o in self._tracking.cycle(nav, guidance, supervisor, control, actuators)}
        for name in ("depth", "heading", "cross-track", "speed"):
            off = lasting.get(name)
            yield f"tracking_{name.replace('-', '_')}", None if off is None else (WARNING, off.text)
        yield from self._saturation(actuators)

    def _saturation(self, actuators: pb.Actuators) -> Iterator[Change]:
        now = actuators.stamp.time_ns * 1e-9
        at_bound = [a for a in actuators.actuators if a.saturated]
        names = {a.name for a in at_bound}
        self._saturated = {name: at for name, at in self._saturated.items() if name in names}
        for a in at_bound:
            self._saturated.setdefault(a.name, now)
        long = [name for name, at in self._saturated.items() if now - at >= self._limits.saturated_s]
        text = f"At its bound for {self._limits.saturated_s:g} s and longer: {', '.join(long)}."
        yield "saturated", (WARNING, text) if long else None


def _long(seconds: float) -> str:
    for unit, size in (("years", 31_557_600.0), ("days", 86_400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 1.5 * size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"
