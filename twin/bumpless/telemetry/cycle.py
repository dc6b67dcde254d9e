"""One LOG row -> the messages of one control cycle."""

import math
from collections.abc import Sequence
from struct import Struct
from typing import cast

import numpy as np
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import IDLE
from bumpless.contract.units import DEG
from bumpless.sim.log import LOG
from bumpless.telemetry.context import ActuatorContext, Context

_VALUES = {name: LOG[name].itemsize // 8 for name in LOG.names or ()}
_UNPACK = Struct("=" + "".join(("q" if LOG[n].base.kind == "i" else "d") * _VALUES[n] for n in _VALUES))


def _slices() -> dict[str, slice]:
    places, at = {}, 0
    for name, count in _VALUES.items():
        places[name] = slice(at, at + count)
        at += count
    return places


_AT = _slices()
_FIRST = {name: place.start for name, place in _AT.items()}


class _Row:
    """The numbers of a row as plain Python ones, unpacked once: much faster than field by field."""

    __slots__ = ("_numbers",)

    def __init__(self, row: np.void) -> None:
        self._numbers = _UNPACK.unpack(row.tobytes())

    def one(self, name: str) -> float:
        return self._numbers[_FIRST[name]]

    def all(self, name: str) -> Sequence[float]:
        return self._numbers[_AT[name]]


def messages(
    row: np.void, context: Context, time_ns: int | None = None, cycle: int | None = None
) -> list[tuple[str, Message]]:
    """What one control cycle says, as (topic, message) in a fixed order.

    `row` is one element of a LOG array (SI, radians); topics are keys after the vehicle's name, such as
    "tlm/navigation" or "truth/state". `time_ns` is the UNIX time of the cycle; without it the time is
    the context's start plus mission time, so that a simulation's log depends on nothing but the row.
    `cycle` counts since the node started; without it the row's own count is told.
    """
    r = _Row(row)
    if time_ns is None:
        time_ns = context.start_time_ns + round(r.one("time") * 1e9)
    stamp = pb.Stamp(
        time_ns=time_ns,
        mission_time_s=0.0 if r.one("phase") == IDLE else r.one("time"),
        cycle=int(r.one("cycle")) if cycle is None else cycle,
    )
    return [
        ("tlm/navigation", _navigation(r, stamp)),
        ("tlm/guidance", _guidance(r, stamp)),
        ("tlm/supervisor", _supervisor(r, stamp, context)),
        ("tlm/control", _control(r, stamp)),
        ("tlm/actuators", actuators := _actuators(r, stamp, context)),
        ("tlm/allocation", _allocation(r, stamp, context, actuators)),
        ("tlm/target", _target(r, stamp)),
        ("truth/state", _truth(r, stamp, context)),
    ]


def _vector(out: pb.Vector3, v: Sequence[float], scale: float = 1.0) -> None:
    out.x, out.y, out.z = v[0] * scale, v[1] * scale, v[2] * scale


def _attitude(out: pb.Attitude, v: Sequence[float]) -> None:
    out.roll_deg, out.pitch_deg, out.yaw_deg = v[0] * DEG, v[1] * DEG, v[2] * DEG


def _wrench(out: pb.Wrench, v: Sequence[float]) -> None:
    out.x_n, out.y_n, out.z_n, out.k_nm, out.m_nm, out.n_nm = v


def _navigation(r: _Row, stamp: pb.Stamp) -> pb.Navigation:
    eta, nu = r.all("eta_hat"), r.all("nu_hat")
    out = pb.Navigation(stamp=stamp, depth_m=r.one("depth"))
    _vector(out.position_ned_m, eta)
    _attitude(out.attitude, eta[3:])
    _vector(out.velocity_body_mps, nu)
    _vector(out.velocity_through_water_body_mps, r.all("nu_r_hat"))
    _vector(out.angular_rate_body_degps, nu[3:], DEG)
    out.speed_over_ground_mps = math.hypot(nu[0], nu[1], nu[2])
    _vector(out.current_estimate_ned_mps, r.all("current_hat"))
    return out


def _guidance(r: _Row, stamp: pb.Stamp) -> pb.Guidance:
    reference = r.all("reference")
    out = pb.Guidance(stamp=stamp, leg=max(0, int(r.one("leg"))), leg_count=int(r.one("leg_count")))
    out.surge_speed_reference_mps, out.sway_speed_reference_mps, out.depth_reference_m = reference[:3]
    _attitude(out.attitude_reference, reference[3:])
    out.cross_track_error_m = r.one("cross_track")
    out.along_track_error_m = r.one("along_track")
    return out


def _supervisor(r: _Row, stamp: pb.Stamp, context: Context) -> pb.Supervisor:
    out = pb.Supervisor(stamp=stamp)
    out.MergeFrom(context.thresholds)
    out.mode = cast("pb.Mode", int(r.one("mode")))
    out.previous_mode = cast("pb.Mode", int(r.one("previous_mode")))
    out.range_m = r.one("range")
    out.detection_raw, out.detection = bool(r.one("detected_raw")), bool(r.one("detected"))
    out.kappa = r.one("kappa")
    out.time_in_mode_s, out.dwell_remaining_s = r.one("time_in_mode"), r.one("dwell_remaining")
    out.phase = cast("pb.MissionPhase", int(r.one("phase")))
    out.docking_stage = cast("pb.DockingStage", int(r.one("stage")))
    out.wave_off_reason = cast("pb.WaveOffReason", int(r.one("reason")))
    out.docking_tries, out.docking_tries_most = int(r.one("tried")), int(r.one("tries"))
    out.flown = cast("pb.Mode", int(r.one("flown")))
    out.approach_heading_deg, out.fix_age_s = r.one("approach") * DEG, r.one("fix_age")
    out.captured = bool(r.one("captured"))
    return out


def _control(r: _Row, stamp: pb.Stamp) -> pb.Control:
    demanded, achieved = r.all("tau_d"), r.all("tau_c")
    out = pb.Control(stamp=stamp)
    _wrench(out.demanded, demanded)
    _wrench(out.demanded_raw, r.all("tau_plus"))
    _wrench(out.achieved, achieved)
    _wrench(out.residual, [d - a for d, a in zip(demanded, achieved, strict=True)])
    _wrench(out.frozen, r.all("tau_minus"))
    return out


def _actuators(r: _Row, stamp: pb.Stamp, context: Context) -> pb.Actuators:
    out = pb.Actuators(stamp=stamp)
    out.MergeFrom(context.nameplates)
    columns = zip(
        r.all("u"), r.all("u_feedback"), r.all("u_lower"), r.all("u_upper"), r.all("du_max"), strict=True
    )
    for said, a, numbers in zip(out.actuators, context.actuators, columns, strict=False):
        _actuator(said, a, *(number * a.scale for number in numbers))
    faults, shares, evidences = int(r.one("faults")), r.all("effectiveness_hat"), r.all("fault_evidence")
    for said, a in zip(out.actuators, context.actuators, strict=True):
        i = a.first
        said.effectiveness, said.fault_evidence, said.faulty = shares[i], evidences[i], bool(faults >> i & 1)
    return out


def _actuator(
    out: pb.Actuator,
    a: ActuatorContext,
    command: float,
    feedback: float,
    lower: float,
    upper: float,
    increment: float,
) -> None:
    near = a.tolerance
    saturated = command <= a.lower + near or command >= a.upper - near
    bounded = upper > lower and (command <= lower + near or command >= upper - near)
    out.command, out.feedback, out.lower, out.upper = command, feedback, lower, upper
    out.saturated, out.rate_limited = saturated, bounded and not saturated
    out.increment_bound = increment


def _allocation(r: _Row, stamp: pb.Stamp, context: Context, actuators: pb.Actuators) -> pb.Allocation:
    return pb.Allocation(
        stamp=stamp,
        status=cast("pb.SolveStatus", int(r.one("status"))),
        sqp_iterations=int(r.one("iterations")),
        kkt_residual=r.one("kkt"),
        residual_norm=r.one("residual_norm"),
        cost=r.one("cost"),
        solve_time_us=r.one("solve_time") * 1e6,
        saturated_count=sum(a.saturated for a in actuators.actuators),
        solver=context.solver,
        slack_norm=math.hypot(*r.all("slack")),
    )


def _target(r: _Row, stamp: pb.Stamp) -> pb.Target:
    distance, bearing, elevation = r.all("target_measured")
    estimate = r.all("target")
    out = pb.Target(stamp=stamp, detected=bool(r.one("detected_raw")))
    out.measured_range_m = distance
    out.bearing_deg, out.elevation_deg = bearing * DEG, elevation * DEG
    _vector(out.position_ned_m, estimate)
    out.heading_deg = estimate[3] * DEG
    _vector(out.observation_point_ned_m, r.all("observation_point"))
    return out


def _truth(r: _Row, stamp: pb.Stamp, context: Context) -> pb.TruthState:
    eta, nu, shares = r.all("eta"), r.all("nu"), r.all("effectiveness")
    out = pb.TruthState(stamp=stamp, effectiveness=[shares[a.first] for a in context.actuators])
    _vector(out.position_ned_m, eta)
    _attitude(out.attitude, eta[3:])
    _vector(out.velocity_body_mps, nu)
    _vector(out.angular_rate_body_degps, nu[3:], DEG)
    _wrench(out.actuator_wrench, r.all("tau"))
    _vector(out.current_ned_mps, r.all("current"))
    _vector(out.target_position_ned_m, r.all("target_true"))
    out.contact_force_n, out.contact_force_most_n = r.one("contact_force"), r.one("contact_most")
    out.nose_depth_m, out.nose_offset_m = r.one("nose_depth"), r.one("nose_offset")
    return out
