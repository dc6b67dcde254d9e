"""A docking flight as telemetry, in closed form: what the console is shown in its tests.

No physics: each value is a plain function of mission time, so that a test knows what the screen must say.
"""

import math
from collections.abc import Sequence
from typing import Any

from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb

PERIOD_S = 0.05
START_NS = 1_760_000_000_000_000_000
TO_REVERSE_S = 24.0
TO_HOVER_S = 46.0
RAMP_S = 1.0
DURATION_S = 90.0
ACTUATORS = ("delta_1", "delta_2", "delta_3", "delta_4", "n_p", "n_v1", "n_v2")
Messages = list[tuple[str, Message]]


def stamp(time_s: float) -> pb.Stamp:
    """Stamp at a mission time."""
    cycle = round(time_s / PERIOD_S)
    return pb.Stamp(time_ns=START_NS + round(time_s * 1e9), mission_time_s=max(0.0, time_s), cycle=cycle)


def mode_at(time_s: float) -> tuple[pb.Mode, pb.Mode, float]:
    """Mode, the mode before, and when it was entered, s."""
    if time_s < TO_REVERSE_S:
        return pb.MODE_FORWARD, pb.MODE_UNSPECIFIED, 0.0
    if time_s < TO_HOVER_S:
        return pb.MODE_REVERSE, pb.MODE_FORWARD, TO_REVERSE_S
    return pb.MODE_HOVER, pb.MODE_REVERSE, TO_HOVER_S


def cycle(time_s: float, phase: pb.MissionPhase = pb.MISSION_PHASE_RUNNING) -> Messages:
    """What a vehicle says in one control cycle."""
    at = stamp(time_s)
    mode, before, since = mode_at(time_s)
    wave = math.sin(0.7 * time_s)
    speed = {pb.MODE_FORWARD: 0.7, pb.MODE_REVERSE: 0.3, pb.MODE_HOVER: 0.0}[mode]
    range_m = (
        max(0.3, 24.0 - 0.7 * time_s) if mode == pb.MODE_FORWARD else max(0.2, 7.2 - 0.25 * (time_s - 24))
    )
    navigation = pb.Navigation(
        stamp=at,
        position_ned_m=pb.Vector3(
            x=0.7 * min(time_s, 24) + 0.25 * max(0.0, time_s - 24), y=0.2 * wave, z=3.0
        ),
        attitude=pb.Attitude(roll_deg=0.6 * wave, pitch_deg=-1.2 * wave, yaw_deg=359.5 + 1.5 * wave),
        velocity_body_mps=pb.Vector3(x=speed + 0.02 * wave),
        depth_m=3.0 + 0.05 * wave,
        speed_over_ground_mps=abs(speed + 0.02 * wave),
        current_estimate_ned_mps=pb.Vector3(x=-0.05, y=0.02),
    )
    guidance = pb.Guidance(
        stamp=at,
        surge_speed_reference_mps=speed,
        depth_reference_m=3.0,
        attitude_reference=pb.Attitude(yaw_deg=0.0),
        cross_track_error_m=0.2 * wave,
        leg=0,
        leg_count=2,
    )
    seen = time_s > 18
    supervisor = pb.Supervisor(
        stamp=at,
        phase=phase,
        mode=mode,
        previous_mode=before,
        range_m=range_m,
        detection_raw=seen and round(time_s * 20) % 37 != 0,
        detection=seen,
        kappa=min(1.0, (time_s - since) / RAMP_S) if since else 1.0,
        time_in_mode_s=time_s - since,
        dwell_remaining_s=max(0.0, 2.0 - (time_s - since)) if since else 0.0,
        range_rh_lower_m=2.0,
        range_rh_upper_m=3.0,
        range_fr_lower_m=7.5,
        range_fr_upper_m=9.0,
        range_hf_upper_m=12.0,
    )
    demanded = pb.Wrench(
        x_n=2.4 * (speed - 0.2) + 0.3 * wave, z_n=0.4 * wave, k_nm=0.1 * wave, m_nm=-0.5 * wave, n_nm=0.8
    )
    share = 0.97 if mode != pb.MODE_HOVER else 0.7
    achieved = pb.Wrench(
        x_n=demanded.x_n * share,
        z_n=demanded.z_n,
        k_nm=demanded.k_nm,
        m_nm=demanded.m_nm * share,
        n_nm=0.8 * share,
    )
    residual = pb.Wrench(
        x_n=demanded.x_n - achieved.x_n,
        m_nm=demanded.m_nm - achieved.m_nm,
        n_nm=demanded.n_nm - achieved.n_nm,
    )
    return [
        ("tlm/navigation", navigation),
        ("tlm/guidance", guidance),
        ("tlm/supervisor", supervisor),
        ("tlm/control", pb.Control(stamp=at, demanded=demanded, achieved=achieved, residual=residual)),
        ("tlm/allocation", _allocation(at, wave)),
        ("tlm/actuators", pb.Actuators(stamp=at, actuators=[_actuator(i, time_s) for i in range(7)])),
        ("tlm/target", pb.Target(stamp=at, detected=seen, measured_range_m=range_m + 2.0)),
    ]


def _allocation(at: pb.Stamp, wave: float) -> pb.Allocation:
    return pb.Allocation(
        stamp=at,
        status=pb.SOLVE_STATUS_SOLVED,
        sqp_iterations=2,
        kkt_residual=3.2e-9 * (1.5 + wave),
        residual_norm=0.012 * (1.5 + wave),
        cost=0.004,
        solve_time_us=14.0 + 5.0 * wave,
        saturated_count=1,
        solver="osqp",
    )


def _actuator(index: int, time_s: float) -> pb.Actuator:
    """Rudders in degrees, then propeller and verticals in rpm; delta_2 saturates, n_v1 is rate-limited."""
    bound, step, unit = (15.0, 1.5, "deg") if index < 4 else (200.0, 10.0, "rpm")
    command = bound * 0.6 * math.sin(0.5 * time_s + index)
    if index == 1:
        command = bound
    return pb.Actuator(
        name=ACTUATORS[index],
        unit=unit,
        command=command,
        feedback=0.93 * command,
        lower=max(-bound, command - step),
        upper=min(bound, command + step),
        amplitude_lower=-bound,
        amplitude_upper=bound,
        saturated=index == 1,
        rate_limited=index == 5,
        increment_bound=step,
    )


def mission_status(time_s: float, phase: pb.MissionPhase = pb.MISSION_PHASE_RUNNING) -> Messages:
    """Mission status at a mission time."""
    status = pb.MissionStatus(
        stamp=stamp(time_s),
        phase=phase,
        run_id="" if phase == pb.MISSION_PHASE_IDLE else "20260101T000000Z-docking-ab12",
        mission_name="" if phase == pb.MISSION_PHASE_IDLE else "docking",
        duration_s=DURATION_S,
        elapsed_s=time_s,
        seed=7,
    )
    return [("tlm/mission", status)]


def description() -> Messages:
    """Who flies."""
    about = pb.VehicleDescription(
        stamp=stamp(0),
        vehicle_id="ts100",
        vehicle_name="TS-100",
        software_version="0.1.0",
        control_period_s=PERIOD_S,
        actuator_names=ACTUATORS,
        session_id="one",
        sha256="0" * 64,
    )
    health = pb.Health(stamp=stamp(0), cycles=1000, lateness_p99_ms=0.4)
    return [("tlm/description", about), ("tlm/health", health)]


def parameters() -> pb.Parameters:
    """A full set of parameters."""

    def mode(q: Sequence[float], r: float, price: float, ramp: int) -> pb.ModeParameters:
        return pb.ModeParameters(q_diagonal=q, r_diagonal=[r] * 7, ramp_cycles=ramp, **{"lambda": price})

    return pb.Parameters(
        forward=mode((1.0, 0.0, 0.5, 2.0, 4.0, 4.0), 1.0, 0.001, 20),
        reverse=mode((2.0, 0.0, 1.0, 2.0, 3.0, 3.0), 1.0, 0.002, 20),
        hover=mode((1.5, 0.0, 4.0, 2.0, 2.0, 2.5), 0.5, 0.002, 40),
        supervisor=pb.SupervisorParameters(
            range_rh_lower_m=2.0,
            range_rh_upper_m=3.0,
            range_fr_lower_m=7.5,
            range_fr_upper_m=9.0,
            range_hf_upper_m=12.0,
            dwell_cycles=40,
            detection_hits=3,
            detection_window=5,
            detection_hold_cycles=20,
        ),
        bumpless=pb.BumplessParameters(ramp=True, integrator_alignment=True, warm_start_projection=True),
    )


def parameters_status(active: pb.Parameters, revision: int) -> Messages:
    """What the vehicle says it flies with."""
    status = pb.ParametersStatus(stamp=stamp(0), active=active, revision=revision, defaults=parameters())
    return [("tlm/parameters", status)]


def server_status(
    link: pb.LinkState = pb.LINK_STATE_LIVE, recording: bool = False, trouble: str = ""
) -> Messages:
    """What the server says of the link and the recorder."""
    status = pb.ServerStatus(
        vehicle_id="ts100",
        link=link,
        recording=recording,
        recording_run_id="20260101T000000Z-docking-ab12" if recording else "",
        recorder_trouble=trouble,
        recorded_bytes=2_345_678 if recording else 0,
        server_version="0.1.0",
        node_managed=True,
    )
    return [("server/status", status)]


def event(time_s: float, severity: pb.Severity, code: str, text: str, **details: str) -> Messages:
    """One event."""
    return [
        ("event", pb.Event(stamp=stamp(time_s), severity=severity, code=code, text=text, details=details))
    ]


def held_by(holder: str = "0123456789ab", name: str = "Browser 0123", **more: Any) -> Messages:
    """Who holds control: by default the browser that looks."""
    return [("server/control", pb.ControlHolder(holder=holder, holder_name=name, since_ns=START_NS, **more))]


def hello(phase: pb.MissionPhase = pb.MISSION_PHASE_IDLE) -> Messages:
    """All that a browser is told on connecting to a vehicle that waits for a mission."""
    return [
        *description(),
        *server_status(),
        *held_by(),
        *mission_status(0.0, phase),
        *parameters_status(parameters(), 1),
        *cycle(0.0, phase),
    ]
