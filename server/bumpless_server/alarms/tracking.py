"""Does the vehicle follow its references? Errors against limits for a time, with the likely cause.

Pure: fed with the vehicle's messages, on mission time.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.modes import LOOKS
from bumpless_server.alarms.limits import Limits

FULL = 0.9  # share of its travel from which an actuator counts as used up
AXES = {"depth": ("Z", "z_n", "N"), "heading": ("N", "n_nm", "N·m"), "speed": ("X", "x_n", "N")}


@dataclass(frozen=True)
class Off:
    """What is off by how much."""

    name: str  # "depth"
    error: float  # believed minus reference
    unit: str
    text: str


class TrackingWatch:
    """Feed it every cycle of a flight; `off` are the errors that have lasted."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._since: dict[str, float] = {}
        self._mode, self._mode_s = 0, 0.0

    def reset(self) -> None:
        """Nothing is flown."""
        self._since.clear()
        self._mode = 0

    def cycle(
        self,
        navigation: pb.Navigation,
        guidance: pb.Guidance,
        supervisor: pb.Supervisor,
        control: pb.Control,
        actuators: pb.Actuators,
    ) -> list[Off]:
        """The errors that have been too large for long enough, in this cycle."""
        now = navigation.stamp.time_ns * 1e-9
        mode = supervisor.flown or supervisor.mode
        if mode != self._mode:
            self._mode, self._mode_s = mode, now
            self._since.clear()
        lasting = []
        for name, error, unit, limit in self._errors(navigation, guidance):
            if not isfinite(error) or abs(error) <= limit:
                self._since.pop(name, None)
                continue
            since = max(self._since.setdefault(name, now), self._mode_s + self._limits.after_switch_s)
            if now - since >= self._limits.for_s:
                lasting.append(Off(name, error, unit, _sentence(name, error, unit, mode, control, actuators)))
        return lasting

    def _errors(
        self, navigation: pb.Navigation, guidance: pb.Guidance
    ) -> Iterator[tuple[str, float, str, float]]:
        limits = self._limits
        turn = navigation.attitude.yaw_deg - guidance.attitude_reference.yaw_deg
        yield "depth", navigation.depth_m - guidance.depth_reference_m, "m", limits.depth_m
        yield "heading", (turn + 180.0) % 360.0 - 180.0, "°", limits.heading_deg
        yield "cross-track", guidance.cross_track_error_m, "m", limits.cross_track_m
        speed = navigation.velocity_body_mps.x - guidance.surge_speed_reference_mps
        yield "speed", speed, "m/s", limits.speed_mps


def _sentence(
    name: str, error: float, unit: str, mode: int, control: pb.Control, actuators: pb.Actuators
) -> str:
    look = LOOKS.get(mode)
    where = f" in {look.name.lower()}" if look else ""
    gap = "" if unit == "°" else " "
    what = f"{name.capitalize()} {_way(name, error)} by {abs(error):.2f}{gap}{unit}{where}"
    return f"{what}: {_cause(name, control, actuators)}."


def _way(name: str, error: float) -> str:
    if name == "depth":
        return "is too great" if error > 0 else "is too small"
    if name == "speed":
        return "is too high" if error > 0 else "is too low"
    return "is off"


def _cause(name: str, control: pb.Control, actuators: pb.Actuators) -> str:
    """What most likely keeps it there: an actuator at its end, a demand not met, or the demand itself."""
    shares = sorted(((_share(a), a) for a in actuators.actuators), key=lambda one: one[0], reverse=True)
    full = [f"{a.name} at {100 * share:.0f} %" for share, a in shares if share >= FULL]
    letter, field, unit = AXES.get(name, ("N", "n_nm", "N·m"))
    demanded, achieved = getattr(control.demanded, field), getattr(control.achieved, field)
    asked = f"{letter} demand {demanded:.2f} {unit}"
    if abs(demanded - achieved) > max(0.1 * abs(demanded), 0.02):
        return f"{asked}, {achieved:.2f} {unit} of it achieved" + (f", {', '.join(full[:3])}" if full else "")
    if full:
        return f"{asked}, {', '.join(full[:3])}"
    return f"{asked} is met and does not suffice: a disturbance, trim, or too small a gain"


def _share(a: pb.Actuator) -> float:
    bound = a.amplitude_upper if a.command >= 0 else -a.amplitude_lower
    return abs(a.command) / bound if bound > 0 else 0.0
