"""The log of a simulated run: the same messages and the same file as a recorded flight."""

import hashlib
import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from bumpless.contract.version import software_version
from bumpless.metrics import as_dict
from bumpless.telemetry import run_id, run_messages
from bumpless_server.runs.writer import LogWriter

if TYPE_CHECKING:
    from bumpless.contract import bumpless_pb2 as pb
    from bumpless.sim.twin import Result

_SHOW_EVERY = 500  # messages


def identity(result: "Result") -> dict[str, str]:
    """What identifies a run: hashes of mission, vehicle and parameters, seed, software, start."""
    now = time.time_ns()
    name = run_id(result.mission.name, now)
    return {
        "id": name,
        "run_id": name,
        "mission": result.mission.name,
        "mission_sha256": result.mission.sha256,
        "vehicle": result.vehicle.id,
        "vehicle_sha256": result.vehicle.sha256,
        "parameters_sha256": hashlib.sha256(_parameters(result).encode()).hexdigest(),
        "seed": str(result.seed),
        "started_ns": str(now),
        "software_version": software_version(),
    }


def write_log(
    path: Path,
    result: "Result",
    info: dict[str, str],
    metrics: "pb.Metrics",
    progress: Callable[[float], None],
) -> None:
    """Write the whole run; mission time 0 is the moment in `info`. Half a file is never left behind."""
    start = int(info["started_ns"])
    partial = path.with_name(path.name + ".part")
    messages, end = 0, max(float(result.log["time"][-1]), 1e-9)
    try:
        with LogWriter(partial, info) as log:
            log.attach(result.mission.source, "application/yaml", result.mission.text.encode())
            log.attach(f"{result.vehicle.id}.toml", "application/toml", result.vehicle.text.encode())
            log.attach("parameters.json", "application/json", _parameters(result).encode())
            for time_ns, topic, message in run_messages(result, info["run_id"], start, software_version()):
                schema = message.DESCRIPTOR.full_name
                log.write(topic, schema, message.SerializeToString(), time_ns, time_ns)
                messages += 1
                if messages % _SHOW_EVERY == 0:
                    progress((time_ns - start) * 1e-9 / end)
            log.attach("metrics.json", "application/json", json.dumps(as_dict(metrics), indent=2).encode())
            duration = f"{metrics.duration_s:.3f}"
            log.metadata("end", {"state": "complete", "reason": "simulated", "duration_s": duration})
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def _parameters(result: "Result") -> str:
    from bumpless.config.parameters import as_dict

    return json.dumps(as_dict(result.parameters), indent=2)
