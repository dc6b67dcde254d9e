"""The ways out of the present mode, each a checklist: what the vehicle's own automaton weighs in this cycle.

The published automaton's guards are those of eq. (53), Gao et al. 2026: met to the last means that the switch
comes with the next cycle. Of the docking automaton the conditions are told that its parameters set.
"""

from collections.abc import Iterator
from math import cos, hypot, nan, pi, sin
from typing import TYPE_CHECKING, cast

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import APPROACH, ENDED, FORWARD, HOVER, IDLE, PAUSED, REVERSE

if TYPE_CHECKING:
    from bumpless.telemetry.context import Context

_LEAST_SPEED = 0.02  # m/s; slower, nobody can tell when a distance will be covered
_DEG = 180.0 / pi


def exits(row: np.void, context: "Context", stamp: pb.Stamp) -> pb.Exits:
    """Topic "exits" of one LOG row. A paused or ended flight has none: its supervisor is frozen."""
    phase, mode = int(row["phase"]), int(row["mode"])
    out = pb.Exits(stamp=stamp, mode=cast("pb.Mode", mode))
    if phase in (IDLE, PAUSED, *ENDED):
        return out
    found = _docking(row, context) if row["stage"] else _published(row, context)
    for to, name, guards in found:
        exit_ = out.exits.add(to=cast("pb.Mode", to), name=name, guards=guards)
        exit_.expected_s = _expected(row, guards)
    return out


def _published(row: np.void, context: "Context") -> Iterator[tuple[int, str, list[pb.Guard]]]:
    s, mode, d = context.supervisor, int(row["mode"]), float(row["range"])
    if mode == FORWARD and row["leg"] >= row["leg_count"] > 0:
        return  # on the way back after a missed approach a glimpse of the target is no approach
    dwell = _dwell(row, context)
    if mode == FORWARD:
        yield REVERSE, "brake", [_seen(row, context), dwell, _within("range", d, s.range_fr_lower_m)]
    elif mode == REVERSE:
        yield HOVER, "hover", [_seen(row, context), dwell, _within("range", d, s.range_rh_lower_m)]
        yield FORWARD, "target lost", [_unseen(row), dwell]
        yield FORWARD, "too far", [dwell, _beyond("range", d, s.range_fr_upper_m)]
    else:
        yield REVERSE, "drifted off", [dwell, _beyond("range", d, s.range_rh_upper_m)]
        yield FORWARD, "target lost", [_unseen(row), dwell]
        yield FORWARD, "too far", [dwell, _beyond("range", d, s.range_hf_upper_m)]


def _docking(row: np.void, context: "Context") -> Iterator[tuple[int, str, list[pb.Guard]]]:
    s, p, mode, left = context.supervisor, context.docking, int(row["mode"]), float(row["along_track"])
    if int(row["stage"]) != APPROACH:
        return
    aside = abs(float(row["cross_track"]))
    if mode == FORWARD:
        cone = p.cone_base_m + p.cone_slope * max(left, 0.0)
        guards = [
            _seen(row, context),
            _within("way to go", left, s.range_fr_lower_m),
            _within("aside", aside, cone),
        ]
        yield REVERSE, "brake", guards
    elif mode == REVERSE:
        yield HOVER, "hover", [_within("way to go", left, s.range_rh_lower_m), *_gate(row, context)]
    else:
        yield REVERSE, "drifted off", [_beyond("way to go", left, s.range_rh_upper_m)]


def _gate(row: np.void, context: "Context") -> list[pb.Guard]:
    """Past the gate, or what it waits for."""
    passed = bool(row["cleared"])
    gate = _yes("gate passed", passed)
    if passed:
        return [gate]
    p, eta = context.docking, row["eta_hat"]
    off = abs((float(eta[5] - row["approach"]) + pi) % (2 * pi) - pi)
    return [
        _within("depth error", abs(float(eta[2] - row["target"][2])), p.gate_depth_m),
        _within("heading error", off * _DEG, p.gate_heading_deg, "°"),
        _within("aside", abs(float(row["cross_track"])), p.gate_lateral_m),
        gate,
    ]


def _seen(row: np.void, context: "Context") -> pb.Guard:
    """chi: the hits that the filter counts, or how long the last detection still lasts."""
    s, seen = context.supervisor, bool(row["detected"])
    name = f"seen in {s.detection_window} frames"
    return pb.Guard(name=name, value=float(row["hits"]), limit=s.detection_hits, at_least=True, met=seen)


def _unseen(row: np.void) -> pb.Guard:
    left = float(row["hold_left"])
    return pb.Guard(name="frames until given up", value=left, limit=0.0, met=not row["detected"])


def _dwell(row: np.void, context: "Context") -> pb.Guard:
    least = context.supervisor.dwell_cycles * context.period_s
    stayed = max(0.0, least - float(row["dwell_remaining"]))
    return pb.Guard(
        name="dwell", value=stayed, limit=least, at_least=True, met=row["dwell_remaining"] <= 0.0, unit="s"
    )


def _within(name: str, value: float, limit: float, unit: str = "m") -> pb.Guard:
    return pb.Guard(name=name, value=value, limit=limit, met=value <= limit, unit=unit)


def _beyond(name: str, value: float, limit: float) -> pb.Guard:
    return pb.Guard(name=name, value=value, limit=limit, at_least=True, met=value >= limit, unit="m")


def _yes(name: str, met: bool) -> pb.Guard:
    return pb.Guard(name=name, value=float(met), limit=1.0, at_least=True, met=met)


def _expected(row: np.void, guards: list[pb.Guard]) -> float:
    """Until the last unmet condition is met, s, where only time and way are wanting."""
    closing, wait = _closing(row), 0.0
    for guard in guards:
        if guard.met:
            continue
        if guard.name == "dwell":
            wait = max(wait, guard.limit - guard.value)
        elif guard.name in ("range", "way to go"):
            speed = -closing if guard.at_least else closing
            if speed < _LEAST_SPEED:
                return nan
            wait = max(wait, abs(guard.value - guard.limit) / speed)
        else:
            return nan
    return wait


def _closing(row: np.void) -> float:
    """Speed towards the observation point, m/s, horizontally."""
    eta, nu, point = row["eta_hat"], row["nu_hat"], row["observation_point"]
    c, s = cos(eta[5]), sin(eta[5])
    north, east = c * nu[0] - s * nu[1], s * nu[0] + c * nu[1]
    to_north, to_east = point[0] - eta[0], point[1] - eta[1]
    way = hypot(to_north, to_east)
    return 0.0 if way < 1e-6 else float((north * to_north + east * to_east) / way)
