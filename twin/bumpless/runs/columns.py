"""A recorded run back as columns: the bus's messages, joined by control cycle, in SI and radians."""

from array import array
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np
from google.protobuf.message import DecodeError

from bumpless.chart import NotAGrid, from_bytes, with_floor
from bumpless.config.mission import Mission, parse_mission
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import Vehicle, VehicleError, parse_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import SAID
from bumpless.contract.modes import MODE_LETTERS
from bumpless.contract.units import EDGE_PER_SI
from bumpless.metrics import Columns, Figures
from bumpless.metrics.columns import FLOWN, MOST_ODD, DockColumns
from bumpless.runs.figures import figures_of_log
from bumpless.runs.names import DESCRIPTION, MISSION, PLAN, TRUTH
from bumpless.runs.read import log_messages


@dataclass(frozen=True)
class RecordedColumns:
    """What the messages of a file tell. `vehicle` is None when it holds no usable description."""

    columns: Columns
    vehicle: Vehicle | None
    status: pb.MissionStatus  # the last; empty when there is none
    plan: pb.Plan  # the last; empty when there is none

    @property
    def mission(self) -> Mission | None:
        """The mission as the vehicle flew it; None when there is none that can be read."""
        plan = self.plan
        try:
            return parse_mission(plan.mission_yaml, plan.file_name, self.vehicle, any_vehicle=True)
        except ProblemsError:
            return None


class _Column:
    """Numbers of one topic, one row per message."""

    def __init__(self) -> None:
        self.cycles, self.values = array("q"), array("d")
        self.odd: set[int] = set()  # cycles with a number that is none

    def add(self, cycle: int, numbers: Iterable[float], finite: bool) -> None:
        """Take in a message; an odd one (of another width, with a number that is none) is a missing one."""
        row = array("d", numbers)
        if self.cycles and len(row) * len(self.cycles) != len(self.values):
            return
        if finite and not all(map(isfinite, row)):
            self.odd.add(cycle)
            return
        self.cycles.append(cycle)
        self.values.extend(row)

    def table(self) -> tuple[np.ndarray, np.ndarray]:
        """Cycles (m,), ascending and each once, and rows (m, width)."""
        cycles = np.array(self.cycles, np.int64)
        values = np.array(self.values).reshape(len(cycles), -1) if len(cycles) else np.empty((0, 0))
        unique, first = np.unique(cycles, return_index=True)
        return unique, values[first]


def read_columns(path: Path) -> RecordedColumns:
    """Read a log, whole or cut. A cycle that lacks one of its messages is left out."""
    columns = {topic: _Column() for topic in _NUMBERS}
    vehicle: Vehicle | None = None
    status, plan = pb.MissionStatus(), pb.Plan()
    wanted = {DESCRIPTION, MISSION, PLAN, *_NUMBERS}
    for topic, record in log_messages(path, wanted):
        if topic == DESCRIPTION and vehicle is not None:
            continue
        message: Any = SAID[topic]()
        try:
            message.ParseFromString(record.data)
        except DecodeError:
            continue
        if topic == DESCRIPTION:
            vehicle = _vehicle(message)
        elif topic == MISSION:
            status = message
        elif topic == PLAN:
            plan = message
        else:
            with suppress(KeyError, ValueError, OverflowError):  # a unit or a count of another contract
                columns[topic].add(message.stamp.cycle, _NUMBERS[topic](message), topic != TRUTH)
    return RecordedColumns(_joined(columns), vehicle, status, plan)


def over_floor(mission: Mission | None, grid: bytes | None) -> Mission | None:
    """The mission over the depth grid that its log carries; as it is without one that can be read."""
    if mission is None or grid is None:
        return mission
    try:
        return with_floor(mission, from_bytes(grid))
    except NotAGrid:
        return mission


def figures_of_file(
    path: Path,
    run_id: str,
    state: str,
    status: pb.MissionStatus,
    reason: str = "",
    grid: bytes | None = None,
) -> Figures | None:
    """Figures of a log, also of one that is still being written (flush it first) or was cut.

    `state`, `status` and `reason` are the run's last, `grid` its depth grid. None when the file holds no
    cycle of a mission or no usable vehicle description. Raises ValueError when it is not MCAP.
    """
    data = read_columns(path)
    mission = over_floor(data.mission, grid)
    return figures_of_log(data.columns, data.vehicle, mission, status, state, reason, run_id)


def _vehicle(message: pb.VehicleDescription) -> Vehicle | None:
    try:
        return parse_vehicle(message.vehicle_toml, f"{message.vehicle_id}.toml")
    except VehicleError:
        return None


def _is_lost(columns: dict[str, _Column], last: int) -> bool:
    """Whether, after cycle `last`, the state was no number any more for the rest of the flight."""
    said = columns["tlm/supervisor"]
    odd = set().union(*(column.odd for topic, column in columns.items() if topic != TRUTH))
    width = len(said.values) // max(1, len(said.cycles))
    ended = {c for c, phase in zip(said.cycles, said.values[::width], strict=True) if phase not in FLOWN}
    return sum(cycle > last for cycle in odd - ended) > MOST_ODD


def _joined(columns: dict[str, _Column]) -> Columns:
    tables = {topic: column.table() for topic, column in columns.items()}
    truth_cycles, truth = tables.pop(TRUTH)
    cycle = tables["tlm/supervisor"][0]
    for own, _ in tables.values():
        cycle = np.intersect1d(cycle, own, assume_unique=True)
    rows = {topic: values[np.searchsorted(own, cycle)] for topic, (own, values) in tables.items()}
    flying = np.isin(rows["tlm/supervisor"][:, 0], FLOWN) if len(cycle) else np.zeros(0, bool)
    told = np.isin(cycle, truth_cycles)
    if 2 * np.sum(told & flying) >= np.sum(flying):  # where it is told, it is one of a cycle's messages
        flying &= told
    cycle = cycle[flying]
    rows = {topic: values[flying] if len(cycle) else np.empty((0, 80)) for topic, values in rows.items()}
    supervisor, navigation = rows["tlm/supervisor"], rows["tlm/navigation"]
    control, allocation = rows["tlm/control"], rows["tlm/allocation"]
    actuators, target, guidance = rows["tlm/actuators"], rows["tlm/target"], rows["tlm/guidance"]
    n_u = actuators.shape[1] // 3
    known = np.full((len(cycle), 25), np.nan)  # truth: wrench, pose, velocity, target, dock
    _, here, there = np.intersect1d(cycle, truth_cycles, assume_unique=True, return_indices=True)
    if len(here):
        known[here] = truth[there]
    return Columns(
        time=supervisor[:, 1],
        cycle=cycle,
        mode=supervisor[:, 2].astype(np.int64),
        kappa=supervisor[:, 3],
        range=supervisor[:, 4],
        depth=navigation[:, 0],
        eta_hat=navigation[:, 1:7],
        nu_hat=navigation[:, 7:13],
        nu_r_hat=navigation[:, 13:16],
        reference=guidance[:, :6],
        cross_track=guidance[:, 6],
        stage=supervisor[:, 5].astype(np.int64),
        tried=supervisor[:, 6].astype(np.int64),
        reason=supervisor[:, 7].astype(np.int64),
        approach=np.radians(supervisor[:, 8]),
        tau_d=control[:, 0:6],
        tau_plus=control[:, 6:12],
        tau_c=control[:, 12:18],
        tau_minus=control[:, 18:24],
        tau=known[:, :6],
        observation_point=target[:, 4:7],
        target=target[:, :4],
        eta=known[:, 6:12],
        nu=known[:, 12:18],
        target_true=known[:, 18:21],
        dock=_dock(supervisor[:, 9].astype(np.int64), known[:, 21:25]),
        u=actuators[:, :n_u],
        du_max=actuators[:, n_u : 2 * n_u],
        u_feedback=actuators[:, 2 * n_u :],
        status=allocation[:, 0].astype(np.int64),
        solve_time=allocation[:, 1],
        lost=bool(len(cycle)) and _is_lost(columns, int(cycle[-1])),
    )


def _dock(captured: np.ndarray, known: np.ndarray) -> DockColumns | None:
    """None where there is no dock to enter: nobody felt one, and no latch closed."""
    if not np.any(known[:, 1] > 0.0) and not captured.any():
        return None
    return DockColumns(captured, known[:, 0], known[:, 1], known[:, 2], known[:, 3])


_DOCKING = ("docking_stage", "docking_tries", "wave_off_reason", "approach_heading_deg", "captured")


def _supervisor(m: pb.Supervisor) -> tuple[float, ...]:
    if m.mode not in MODE_LETTERS:
        raise ValueError(f"there is no mode {m.mode}")
    said = (m.phase, m.stamp.mission_time_s, m.mode, m.kappa, m.range_m)
    return (*said, *(getattr(m, name, 0) for name in _DOCKING))


def _navigation(m: pb.Navigation) -> list[float]:
    through = m.velocity_through_water_body_mps
    return [m.depth_m, *_motion(m), through.x, through.y, through.z]


def _guidance(m: pb.Guidance) -> list[float]:
    a = m.attitude_reference
    degrees = np.radians([a.roll_deg, a.pitch_deg, a.yaw_deg]).tolist()
    speeds = (m.surge_speed_reference_mps, m.sway_speed_reference_mps)
    return [*speeds, m.depth_reference_m, *degrees, m.cross_track_error_m]


def _motion(m: pb.Navigation | pb.TruthState) -> list[float]:
    """Pose and velocity, 6 each."""
    at, v = m.position_ned_m, m.velocity_body_mps
    a, w = m.attitude, m.angular_rate_body_degps
    degrees = np.radians([a.roll_deg, a.pitch_deg, a.yaw_deg, w.x, w.y, w.z]).tolist()
    return [at.x, at.y, at.z, *degrees[:3], v.x, v.y, v.z, *degrees[3:]]


def _target(m: pb.Target) -> list[float]:
    at, point = m.position_ned_m, m.observation_point_ned_m
    return [at.x, at.y, at.z, float(np.radians(m.heading_deg)), point.x, point.y, point.z]


def _truth(m: pb.TruthState) -> list[float]:
    at = m.target_position_ned_m
    dock = (m.contact_force_n, m.contact_force_most_n, m.nose_depth_m, m.nose_offset_m)
    return [*_wrench(m.actuator_wrench), *_motion(m), at.x, at.y, at.z, *dock]


def _control(m: pb.Control) -> list[float]:
    return [n for wrench in (m.demanded, m.demanded_raw, m.achieved, m.frozen) for n in _wrench(wrench)]


def _wrench(w: pb.Wrench) -> tuple[float, ...]:
    return (w.x_n, w.y_n, w.z_n, w.k_nm, w.m_nm, w.n_nm)


def _actuators(m: pb.Actuators) -> list[float]:
    edges = [EDGE_PER_SI[a.unit] for a in m.actuators]
    told = [*(a.command for a in m.actuators), *(a.increment_bound for a in m.actuators)]
    told += [a.feedback for a in m.actuators]
    return [number / edge for number, edge in zip(told, edges * 3, strict=True)]


def _allocation(m: pb.Allocation) -> tuple[float, ...]:
    return (m.status, m.solve_time_us * 1e-6)


_NUMBERS: dict[str, Callable[[Any], Iterable[float]]] = {
    "tlm/supervisor": _supervisor,
    "tlm/navigation": _navigation,
    "tlm/guidance": _guidance,
    "tlm/control": _control,
    "tlm/actuators": _actuators,
    "tlm/allocation": _allocation,
    "tlm/target": _target,
    TRUTH: _truth,
}
