"""A recorded run as the columns that metrics are made of; also of a file still being written or cut off."""

import math
import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import zstandard
from google.protobuf.message import DecodeError
from mcap.exceptions import McapError
from mcap.records import Channel, Message
from mcap.stream_reader import StreamReader

from twin.contract import bumpless_pb2 as pb
from twin.metrics import Run
from twin.vehicle import Vehicle, VehicleError, parse_vehicle

_CUT = (McapError, struct.error, zstandard.ZstdError, UnicodeDecodeError, EOFError)
_FLYING = (pb.MISSION_PHASE_UNSPECIFIED, pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED)
_SI_PER_EDGE = {"deg": math.pi / 180.0, "rpm": 1.0 / 60.0}
_UNKNOWN = (math.nan,) * 6
_SINGLE = ("time", "cycle", "mode", "kappa", "range", "depth", "status", "solve_time")
_ROWS = ("eta_hat", "nu_hat", "tau_d", "tau_plus", "tau_minus", "tau_c", "tau", "u", "du_max")
_INTEGERS = ("cycle", "mode", "status")

Columns = dict[str, Any]


def messages(path: Path, topics: frozenset[str]) -> Iterator[tuple[str, bytes]]:
    """(topic, payload) of every whole message of these topics, in the order of the file."""
    channels: dict[int, str] = {}
    with path.open("rb") as file:
        records = StreamReader(file, record_size_limit=None).records
        try:
            for record in records:
                if isinstance(record, Channel) and record.topic in topics:
                    channels[record.id] = record.topic
                elif isinstance(record, Message) and record.channel_id in channels:
                    yield channels[record.channel_id], record.data
        except _CUT:
            return  # a file being written, or cut off: what came before is whole


def _wrench(w: pb.Wrench) -> tuple[float, ...]:
    return (w.x_n, w.y_n, w.z_n, w.k_nm, w.m_nm, w.n_nm)


def _vector(v: pb.Vector3) -> tuple[float, float, float]:
    return (v.x, v.y, v.z)


def _navigation(m: pb.Navigation) -> Columns:
    a, w = m.attitude, _vector(m.angular_rate_body_degps)
    angles = (math.radians(a.roll_deg), math.radians(a.pitch_deg), math.radians(a.yaw_deg))
    return {
        "time": m.stamp.mission_time_s,
        "depth": m.depth_m,
        "eta_hat": (*_vector(m.position_ned_m), *angles),
        "nu_hat": (*_vector(m.velocity_body_mps), *(math.radians(rate) for rate in w)),
    }


def _supervisor(m: pb.Supervisor) -> Columns:
    return {"mode": m.mode - 1, "kappa": m.kappa, "range": m.range_m, "phase": m.phase}


def _control(m: pb.Control) -> Columns:
    return {
        "tau_d": _wrench(m.demanded),
        "tau_plus": _wrench(m.demanded_raw),
        "tau_minus": _wrench(m.frozen),
        "tau_c": _wrench(m.achieved),
    }


def _allocation(m: pb.Allocation) -> Columns:
    return {"status": m.status, "solve_time": m.solve_time_us * 1e-6}


def _actuators(m: pb.Actuators) -> Columns:
    scales = [_SI_PER_EDGE.get(a.unit, 1.0) for a in m.actuators]
    return {
        "u": [a.command * scale for a, scale in zip(m.actuators, scales, strict=True)],
        "du_max": [a.increment_bound * scale for a, scale in zip(m.actuators, scales, strict=True)],
    }


def _truth(m: pb.TruthState) -> Columns:
    return {"tau": _wrench(m.actuator_wrench)}


_READERS: dict[str, tuple[type[Any], Callable[[Any], Columns]]] = {
    "tlm/navigation": (pb.Navigation, _navigation),
    "tlm/supervisor": (pb.Supervisor, _supervisor),
    "tlm/control": (pb.Control, _control),
    "tlm/allocation": (pb.Allocation, _allocation),
    "tlm/actuators": (pb.Actuators, _actuators),
    "truth/state": (pb.TruthState, _truth),
}
_DESCRIPTION = "tlm/description"
_NEEDED = {*_SINGLE, *_ROWS} - {"tau"}


def read_run(path: Path) -> tuple[Run, Vehicle] | None:
    """The cycles of the mission that the file holds whole, and the vehicle that flew them.

    None when it holds no such cycle or no description of the vehicle.
    """
    cycles: dict[int, Columns] = {}
    vehicle: Vehicle | None = None
    for topic, payload in messages(path, frozenset({*_READERS, _DESCRIPTION})):
        try:
            if topic == _DESCRIPTION:
                vehicle = vehicle or _described(pb.VehicleDescription.FromString(payload))
                continue
            kind, columns_of = _READERS[topic]
            message = kind.FromString(payload)
        except DecodeError:
            continue
        cycles.setdefault(message.stamp.cycle, {"cycle": message.stamp.cycle}).update(columns_of(message))
    flown = [c for _, c in sorted(cycles.items()) if c.keys() >= _NEEDED and c["phase"] in _FLYING]
    if vehicle is None or not flown:
        return None
    n_u = len(vehicle.actuators)
    flown = [c for c in flown if len(c["u"]) == n_u]
    columns: Columns = {
        name: np.array([c[name] for c in flown], np.int64 if name in _INTEGERS else np.float64)
        for name in _SINGLE
    }
    for name in _ROWS:
        columns[name] = np.array([c.get(name, _UNKNOWN) for c in flown], np.float64)
    return Run(**columns), vehicle


def _described(description: pb.VehicleDescription) -> Vehicle | None:
    try:
        return parse_vehicle(description.vehicle_toml, description.vehicle_id)
    except VehicleError:
        return None
