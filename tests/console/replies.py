"""What the contract server answers when nothing has gone wrong."""

from pathlib import Path
from typing import Any

from google.protobuf.json_format import MessageToDict

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.alarms.limits import Limits
from bumpless_server.live.tally import KINDS
from tests.console import flight
from tests.console.contract_server import ContractServer

MISSIONS = Path(__file__).parents[2] / "missions"
RUN_ID = "20260101T000000Z-docking-ab12"
CLIENT = "0123456789ab"
OLD_RUN_ID = "20251231T100000Z-docking_current-77aa"


def as_json(message: Any) -> dict[str, Any]:
    """A message in the contract's JSON: field names as in the schema, nothing left out."""
    return MessageToDict(message, preserving_proto_field_name=True, always_print_fields_with_no_presence=True)


def metrics() -> pb.Metrics:
    """Metrics of a finished run."""
    return pb.Metrics(
        run_id=OLD_RUN_ID,
        duration_s=90.0,
        cycles=1800,
        residual_rms=0.1234,
        saturation_ratio=0.217,
        d_u_fr=0.0456,
        d_u_rh=0.0321,
        switches=[
            pb.SwitchMetrics(
                from_mode=pb.MODE_FORWARD,
                to_mode=pb.MODE_REVERSE,
                time_s=24.05,
                command_step_normalised=0.0456,
                command_step_raw=9.1,
                settling_s=19.0,
                command_step_settling=0.0767,
                force_step_n=0.144,
                moment_step_nm=0.008,
                angular_acceleration_step_degps2=0.82,
            ),
            pb.SwitchMetrics(
                from_mode=pb.MODE_REVERSE,
                to_mode=pb.MODE_HOVER,
                time_s=46.2,
                command_step_normalised=0.0321,
                command_step_raw=6.4,
            ),
        ],
        modes=[
            pb.ModeMetrics(
                mode=mode,
                duration_s=22.0,
                depth_rms_m=0.05,
                depth_peak_to_peak_m=0.21,
                roll_rms_deg=0.4,
                pitch_rms_deg=0.8,
                yaw_rms_deg=1.1,
                surge_speed_mean_mps=speed,
                residual_rms=0.1,
                depth_error_rms_m=0.187,
                depth_error_max_m=0.31,
                heading_error_rms_deg=1.2,
                heading_error_max_deg=3.4,
            )
            for mode, speed in ((pb.MODE_FORWARD, 0.7), (pb.MODE_REVERSE, 0.3), (pb.MODE_HOVER, 0.0))
        ],
        solve_time_mean_us=15.2,
        solve_time_std_us=3.1,
        solve_time_p95_us=21.0,
        solve_time_max_us=112.0,
        final_range_m=0.21,
        d_u_fr_settling=0.0767,
        d_u_rh_settling=0.0405,
        shaft_energy_j=16.6,
        fin_travel_deg=56.9,
        screw_reversals=15,
        outcome=pb.Outcome(
            ending=pb.ENDING_HELD,
            reason="in hover, truly 0.21 m from the observation point.",
            basis="true",
            mode=pb.MODE_HOVER,
            closest_m=0.532,
            closest_s=89.9,
            true_errors=pb.EndErrors(
                position_m=0.213, horizontal_m=0.21, depth_m=-0.04, heading_deg=9.41, speed_mps=0.022
            ),
            believed_errors=pb.EndErrors(
                position_m=0.205, horizontal_m=0.2, depth_m=-0.045, heading_deg=9.3, speed_mps=0.02
            ),
        ),
        solved_ratio=0.998,
    )


def mission(name: str, title: str, summary: str, duration_s: float) -> dict[str, Any]:
    """One entry of the mission list."""
    return {
        "name": name,
        "file": name,
        "title": title,
        "summary": summary,
        "vehicle": "ts100",
        "duration_s": duration_s,
        "seed": 1,
        "sha256": "5f2a9c" + "0" * 58,
        "builtin": True,
        "valid": True,
        "problems": [],
        "modified": "2026-01-01T00:00:00Z",
        "size": 1024,
        "tags": [],
        "archived": False,
    }


def me(role: str = "engineer", accounts: bool = False, name: str = "") -> dict[str, Any]:
    """Who the browser is: of the console's own tests always `CLIENT`."""
    shown = name or f"Browser {CLIENT[:4]}"
    return {"accounts": accounts, "name": name, "shown": shown, "role": role, "client": CLIENT}


def default_replies(server: ContractServer) -> None:
    """Missions, ranges, presets and runs of a server in use."""
    docking = mission("docking.yaml", "Docking flight", "Cruise, brake and hover before the target.", 90.0)
    current = mission("docking_current.yaml", "Docking in a current", "The same with a cross current.", 120.0)
    server.reply("GET", "me", me())
    server.reply("GET", "missions", [docking, current])
    geometry = {
        "path_ned_m": [[0, 0, 2.0], [10, 0, 2.0], [20, 4, 2.3], [24.5, 6, 2.3]],
        "target": {
            "position_ned_m": [26, 6.6, 2.3],
            "heading_deg": 20,
            "observation_point_ned_m": [24.5, 6, 2.3],
        },
        "current_ned_mps": [-0.05, 0.08, 0.0],
    }
    for entry in (docking, current):
        text = (MISSIONS / entry["name"]).read_text()
        server.reply("GET", f"missions/{entry['name']}", {**entry, **geometry, "yaml": text})
    server.reply("GET", "vehicle", vehicle("ts100", "TS-100", ["X", "Z", "K", "M", "N"]))
    server.reply("GET", "vehicle/reach", reach())
    server.reply("GET", "alarms/limits", Limits().model_dump())
    server.reply("GET", "alarms", {"open": [], "history": []})
    server.reply("GET", "fields/parameters", [])
    active = as_json(flight.parameters())
    confirmed = {"active": active, "defaults": active, "revision": 1, "sha256": "0" * 64, "ranges": ranges()}
    server.reply("GET", "parameters", confirmed)
    gentle = flight.parameters()
    gentle.hover.ramp_cycles = 80
    gentle.forward.q_diagonal[0] = 1.25
    calm = {"name": "calm-sea", "modified": "2026-01-01T00:00:00Z", "parameters": as_json(gentle)}
    server.reply("GET", "presets", [calm])
    server.reply("GET", "presets/calm-sea", calm)
    server.reply("GET", "runs", [run(OLD_RUN_ID, "docking_current", "complete", "duration reached", "held")])
    server.reply("GET", f"runs/{OLD_RUN_ID}/metrics", as_json(metrics()))
    server.reply("GET", f"runs/{OLD_RUN_ID}/flight", whole(OLD_RUN_ID))
    server.reply("GET", "run-views", [])
    server.reply("GET", f"runs/{OLD_RUN_ID}/log.mcap", b"\x89MCAP0\r\n")
    server.reply("GET", "diagnostics", diagnostics())
    server.reply("GET", "audit", audit())
    for people in ("users", "sessions", "tokens"):
        server.reply("GET", people, [])
    server.reply("POST", "scene/camera", {"view": "top", "viewers": 1})


def diagnostics() -> dict[str, Any]:
    """Some messages were odd, one file is left out."""
    kinds = [("undecodable", 3, "2026-01-01T00:00:00Z", "tlm/control"), ("late_command", 0, None, "")]
    return {
        "counted": [
            {"kind": kind, "meaning": KINDS[kind], "count": count, "last": last, "example": example}
            for kind, count, last, example in kinds
        ],
        "topics": [{"topic": "tlm/navigation", "age_s": 0.1, "fresh_for_s": 0.5, "late": False}],
        "left_out": [{"folder": "runs", "name": "odd.mcap", "reason": "is a folder"}],
        "clock_offset_s": 0.012,
        "vehicle_session": "ab12",
        "bus_notice": "",
        "audit_trouble": "",
    }


def audit() -> list[dict[str, Any]]:
    """Ada tuned and started."""
    common = {"author": "ada", "address": "10.0.0.1", "answer": "accepted", "said": "", "took_s": 0.1}
    start = {
        "time": "2026-01-01T00:00:02Z",
        "id": "2",
        "verb": "start",
        "details": {"mission": "docking.yaml"},
    }
    changes = {"changes": {"hover.lambda": [0.1, 0.2]}}
    tune = {"time": "2026-01-01T00:00:01Z", "id": "1", "verb": "set_parameters", "details": changes}
    return [{**common, **start}, {**common, **tune}]


REACH = (4.0, 0.0, 2.0, 1.0, 1.2, 1.6)  # along X Y Z K M N: boxes, so that a test knows the margin


def reach() -> dict[str, Any]:
    """Attainable sets: what /api/vehicle/reach tells."""

    def rows(half: tuple[float, ...]) -> list[list[float]]:
        axes = [i for i, most in enumerate(half) if most]
        return [[sign / half[i] if i == k else 0.0 for i in range(3)] for k in axes for sign in (1.0, -1.0)]

    return {
        "sha256": "0" * 64,
        "surge_mps": 0.3,
        "force": rows(REACH[:3]),
        "moment": rows(REACH[3:]),
        "low": [-most for most in REACH],
        "high": list(REACH),
        "most": list(REACH),
    }


def vehicle(vehicle_id: str, name: str, controllable: list[str]) -> dict[str, Any]:
    """What a vehicle's file says, as far as the console looks."""
    return {
        "id": vehicle_id,
        "name": name,
        "sha256": "0" * 64,
        "control_period_s": flight.PERIOD_S,
        "controllable": controllable,
        "length_m": 2.2,
        "diameter_m": 0.3,
        "actuators": [],
        "failsafe": [],
        "depth_rating_m": None,
    }


def run(run_id: str, name: str, state: str, end_reason: str, outcome: str | None = None) -> dict[str, Any]:
    """One entry of the list of runs."""
    return {
        "id": run_id,
        "run_id": run_id,
        "piece": 1,
        "mission": name,
        "mission_sha256": "0" * 64,
        "vehicle": "ts100",
        "started": "2025-12-31T10:00:00Z",
        "duration_s": 90.0,
        "bytes": 3_456_789,
        "messages": 21_600,
        "dropped": 0,
        "metrics": None,
        "state": state,
        "end_reason": end_reason,
        "outcome": outcome,
        "recorded": _when(run_id),
        "title": "",
        "tags": [],
        "note": "",
        "seed": 7,
        "parameters_sha256": "ab" * 32,
        "software_version": "0.1.0",
        "outcome_reason": "in hover, truly 0.21 m from the observation point." if outcome else "",
    }


def whole(run_id: str) -> dict[str, Any]:
    """A flight in one file, with its figures."""
    return {
        "id": run_id,
        "pieces": [{"id": run_id, "first_s": 0.0, "last_s": 90.0, "pace_s": 0.05}],
        "gaps": [],
        "outcome": "held",
        "outcome_reason": "in hover, truly 0.21 m from the observation point.",
        "metrics": as_json(metrics()),
    }


def _when(run_id: str) -> str:
    """The time in a run's id."""
    return f"{run_id[:4]}-{run_id[4:6]}-{run_id[6:8]}T{run_id[9:11]}:{run_id[11:13]}:{run_id[13:15]}Z"


def ranges() -> list[dict[str, Any]]:
    """Ranges of the parameters that the tests edit."""
    per_mode = [
        ("q_diagonal", 0.0, 1e6),
        ("r_diagonal", 1e-6, 1e6),
        ("lambda", 1e-9, 1e3),
        ("ramp_cycles", 1, 1000),
    ]
    listed = [
        {"path": f"{mode}.{key}", "unit": "1", "min": low, "max": high, "label": key, "count": 0}
        for mode in ("forward", "reverse", "hover")
        for key, low, high in per_mode
    ]
    return [
        *listed,
        {
            "path": "supervisor.dwell_cycles",
            "unit": "cycles",
            "min": 0,
            "max": 10000,
            "label": "dwell",
            "count": 0,
        },
    ]
