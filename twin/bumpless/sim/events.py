"""What happened, in sentences an operator can act on: one entry per switch, loss, find and fallback."""

from dataclasses import dataclass, field

import numpy as np

from bumpless.contract.enums import (
    FALLBACK,
    FORWARD,
    HOVER,
    IDLE,
    INFEASIBLE,
    INFO,
    REFUSED,
    REVERSE,
    WARNING,
)
from bumpless.contract.modes import LOOKS
from bumpless.sim.docking_events import HELD_S, docking_events, docking_switch

_STATUS = {
    INFEASIBLE: "bounds contradict each other",
    FALLBACK: "the QP solver failed; built-in active set used",
    REFUSED: "demand refused",
}
QUIET_S = 5.0  # mission time; an allocator on the edge flips its status many times a second


@dataclass(frozen=True)
class TwinEvent:
    """One event; time_s is mission time."""

    severity: int
    code: str
    text: str
    details: dict[str, str] = field(default_factory=dict)
    time_s: float = 0.0


class EventWriter:
    """Collects events until they are drained. actuators: whose each command is."""

    def __init__(self, actuators: tuple[str, ...] = ()) -> None:
        self.actuators = actuators
        self._events: list[TwinEvent] = []
        self._told: dict[int, tuple[float, int]] = {}  # allocator status -> told at mission time, more since

    def add(
        self, code: str, text: str, details: dict[str, str], severity: int = INFO, time_s: float = 0.0
    ) -> None:
        """Append one event."""
        if code == "mission_started":
            self._told.clear()
        self._events.append(TwinEvent(severity, code, text, details, time_s))

    def allocator(self, status: int, time_s: float) -> None:
        """The solver came to `status`: told the first time, then with a count once QUIET_S have passed."""
        told_s, more = self._told.get(status, (-np.inf, 0))
        if time_s < told_s + QUIET_S:
            self._told[status] = told_s, more + 1
            return
        self._told[status] = time_s, 0
        self._add_allocator(status, more + 1, told_s, time_s)

    def settle(self, time_s: float) -> None:
        """Tell what has been counted and not told."""
        for status, (told_s, more) in self._told.items():
            if more:
                self._told[status] = time_s, 0
                self._add_allocator(status, more, told_s, time_s)

    def _add_allocator(self, status: int, count: int, since_s: float, time_s: float) -> None:
        often = "" if count == 1 else f", {count} times in {time_s - since_s:.1f} s"
        details = {"status": _STATUS[status], "count": str(count)}
        self.add("allocator", f"Allocator: {_STATUS[status]}{often}.", details, WARNING, time_s)

    def drain(self) -> list[TwinEvent]:
        """All events since the last call, oldest first."""
        events, self._events = self._events, []
        return events


def switch_reason(before: int, after: int, row: np.void, s: np.void) -> tuple[str, str]:
    """(why the mode changed, what would have kept it), from eq. (53)'s guards at this row.

    s: SUPERVISOR_SETTINGS.
    """
    if row["stage"]:
        return docking_switch(before, after, row)
    d, seen = row["range"], bool(row["detected"])
    if (before, after) == (FORWARD, REVERSE):
        return f"target seen and range {d:.2f} m <= {s['d_fr_l']:.2f} m", "a range above it, or no detection"
    if (before, after) == (REVERSE, HOVER):
        return f"target seen and range {d:.2f} m <= {s['d_rh_l']:.2f} m", "a range above it, or no detection"
    if after == FORWARD:
        limit = s["d_fr_u"] if before == REVERSE else s["d_hf_u"]
        if not seen:
            return "target lost", "a detection within the hold time"
        return f"range {d:.2f} m >= {limit:.2f} m", "a range below it"
    return f"range {d:.2f} m >= {s['d_rh_u']:.2f} m", "a range below it"


def completed_event(out: EventWriter, row: np.void) -> None:
    """Add that the mission was completed with this LOG row."""
    time_s = float(row["time"])
    out.settle(time_s)
    out.add("mission_completed", f"Mission completed after {time_s:.1f} s.", {}, time_s=time_s)


def eventful(log: np.ndarray) -> list[int]:
    """Rows of a LOG array that `row_events` has something to say about, against the row before."""
    changed = np.zeros(max(0, len(log) - 1), bool)
    for name in ("mode", "detected", "leg", "status", "faults", "stage", "cleared", "captured"):
        changed |= log[name][1:] != log[name][:-1]
    changed |= (log["held"][1:] >= HELD_S) & (log["held"][:-1] < HELD_S)
    return [int(k) for k in np.flatnonzero(changed) + 1]


def row_events(out: EventWriter, last: np.void, row: np.void, settings: np.void) -> None:
    """Compare two consecutive LOG rows and add what an operator should hear of. settings: SETTINGS."""
    time_s = float(row["time"])
    if IDLE in (row["phase"], last["phase"]) or last["cycle"] + 1 != row["cycle"]:
        return
    if row["mode"] != last["mode"]:
        before, after = int(last["mode"]), int(row["mode"])
        why, unless = switch_reason(before, after, row, settings["supervisor"])
        out.add(
            "mode_switch",
            f"{LOOKS[before].name} to {LOOKS[after].key}: {why}.",
            {
                "from": LOOKS[before].key,
                "to": LOOKS[after].key,
                "range_m": f"{row['range']:.3f}",
                "detected": str(bool(row["detected"])).lower(),
                "dwelt_s": f"{last['time_in_mode'] + settings['dt']:.2f}",
                "dwell_s": f"{settings['supervisor']['n_dwell'] * settings['dt']:.2f}",
                "reason": why,
                "unless": unless,
            },
            time_s=time_s,
        )
    if row["captured"] and not last["captured"]:
        told = {"nose_depth_m": f"{row['nose_depth']:.3f}", "contact_force_n": f"{row['contact_force']:.1f}"}
        out.add("captured", f"Captured: nose {row['nose_depth']:.2f} m inside the dock.", told, time_s=time_s)
    for code, text, told, severity in docking_events(last, row):
        out.add(code, text, told, severity, time_s)
    if row["detected"] != last["detected"]:
        if row["detected"]:
            out.add("target_found", f"Target found at {row['range']:.2f} m.", {}, time_s=time_s)
        else:
            out.add("target_lost", "Target lost; flying on its last known place.", {}, WARNING, time_s)
    if row["leg"] != last["leg"]:
        _leg_events(out, int(last["leg"]), int(row["leg"]), int(row["leg_count"]), time_s)
    if row["status"] != last["status"] and int(row["status"]) in _STATUS:
        out.allocator(int(row["status"]), time_s)
    if row["faults"] != last["faults"]:
        _fault_events(out, last, row, time_s)


def _fault_events(out: EventWriter, last: np.void, row: np.void, time_s: float) -> None:
    """An actuator that the autopilot has diagnosed, or that works again."""
    for i, name in enumerate(out.actuators):
        before, after = int(last["faults"]) >> i & 1, int(row["faults"]) >> i & 1
        share = float(row["effectiveness_hat"][i])
        details = {"actuator": name, "effectiveness": f"{share:.3f}"}
        if after > before:
            text = f"Fault detected: {name} at about {share:.2f} of its effect."
            out.add("fault_detected", text, details, WARNING, time_s)
        elif after < before:
            out.add("fault_cleared", f"Fault cleared: {name} works again.", details, time_s=time_s)


def _leg_events(out: EventWriter, before: int, after: int, count: int, time_s: float) -> None:
    """Leg `count` is the way back after a missed approach."""
    if after >= count:
        text = "Target passed without being seen; going back for another approach."
        out.add("approach_missed", text, {}, WARNING, time_s)
    elif before >= count:
        out.add("approach_repeated", "Back on the last leg; approaching again.", {}, time_s=time_s)
