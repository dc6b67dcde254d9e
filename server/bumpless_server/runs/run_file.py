"""One run being recorded: its MCAP file from the first message to the metrics at its end."""

import contextlib
import json
import logging
import time
from pathlib import Path

from google.protobuf import json_format

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import as_dict
from bumpless_server.live.sample import Sample, stamp_of
from bumpless_server.runs.envelopes_ready import envelopes_ready
from bumpless_server.runs.run_metrics import metrics_of_file
from bumpless_server.runs.run_summary import METRICS_ATTACHMENT
from bumpless_server.runs.writer import LogWriter

log = logging.getLogger(__name__)


def free_id(folder: Path, run_id: str) -> str:
    """`run_id`, or `run_id.2`, `.3` ... when an earlier part of the same run is there already."""
    name, part = run_id, 1
    while (folder / f"{name}.mcap").exists():
        part += 1
        name = f"{run_id}.{part}"
    return name


class RunFile:
    """An open recording. Not thread-safe: the recorder's thread alone uses it."""

    def __init__(
        self, folder: Path, status: pb.MissionStatus, context: dict[str, Sample], version: str
    ) -> None:
        self.run_id = status.run_id
        self.id = free_id(folder, status.run_id)
        self.path = folder / f"{self.id}.mcap"
        self.status = status
        self.flushed_bytes = 0
        self.messages = 0
        self._attached: set[str] = set()
        info = _run_info(self.id, status, context, version)
        writer = None
        try:
            self._writer = writer = LogWriter(self.path, info, ready=envelopes_ready)
            began = status.stamp.time_ns - round(status.elapsed_s * 1e9)
            for sample in context.values():
                if not _is_other_plan(sample, status):
                    self.write(sample, max(sample.receive_ns, began))
            self.flush()
        except BaseException:
            with contextlib.suppress(Exception):
                if writer is not None:
                    writer.close()
            self.path.unlink(missing_ok=True)  # nothing of the run itself is in it
            raise

    def write(self, sample: Sample, log_ns: int | None = None) -> None:
        """Write the message's own bytes with its arrival as log time and its stamp as publish time."""
        stamp = stamp_of(sample.payload)
        logged = sample.receive_ns if log_ns is None else log_ns
        published = stamp.time_ns if stamp is not None and stamp.time_ns else logged
        self._writer.write(sample.topic, sample.schema, sample.payload, logged, published)
        self.messages += 1
        if sample.topic in ("tlm/plan", "tlm/parameters") and sample.topic not in self._attached:
            self._attach(sample)

    def flush(self) -> None:
        """Bring what was written to the disk; a killed server loses nothing older."""
        self._writer.flush()
        self.flushed_bytes = self.path.stat().st_size

    def finish(self, state: str, reason: str, dropped: int) -> pb.Metrics | None:
        """Compute the metrics from the file itself, store them in it and close it."""
        metrics = None
        try:
            self.flush()
            metrics = figures_of(self.path, self.run_id)
            if metrics is not None:
                text = json.dumps(as_dict(metrics), indent=1)
                self._writer.attach(METRICS_ATTACHMENT, "application/json", text.encode())
            self._writer.metadata(
                "end",
                {
                    "state": state,
                    "reason": reason,
                    "ended_ns": str(time.time_ns()),
                    "duration_s": f"{self.status.elapsed_s:.3f}",
                    "messages": str(self.messages),
                    "dropped": str(dropped),
                },
            )
        finally:
            self._writer.close()
        return metrics

    def abandon(self) -> None:
        """Close the file after a failure, as well as the disk allows."""
        with contextlib.suppress(Exception):
            self._writer.close()

    def _attach(self, sample: Sample) -> None:
        """Keep mission and parameters as files of their own, as soon as the vehicle has told them."""
        message = sample.decode()
        if isinstance(message, pb.Plan) and message.sha256 == self.status.mission_sha256:
            name = Path(message.file_name or "mission.yaml").name
            self._writer.attach(name, "application/yaml", message.mission_yaml.encode())
        elif isinstance(message, pb.ParametersStatus):
            text = json_format.MessageToJson(message.active, preserving_proto_field_name=True)
            self._writer.attach("parameters.json", "application/json", text.encode())
        else:
            return
        self._attached.add(sample.topic)


def figures_of(path: Path, run_id: str) -> pb.Metrics | None:
    """The run's metrics from its file; None without. A run is worth keeping without its figures."""
    try:
        return metrics_of_file(path, run_id)
    except Exception:
        log.exception("the metrics of %s could not be computed", path)
        return None


def _is_other_plan(sample: Sample, status: pb.MissionStatus) -> bool:
    plan = sample.decode() if sample.topic == "tlm/plan" else None
    return isinstance(plan, pb.Plan) and plan.sha256 != status.mission_sha256


def _run_info(run: str, status: pb.MissionStatus, context: dict[str, Sample], version: str) -> dict[str, str]:
    """What identifies a run: hashes of mission, vehicle and parameters, and the software."""
    said = {topic: sample.decode() for topic, sample in context.items()}
    description, parameters = said.get("tlm/description"), said.get("tlm/parameters")
    info = {
        "id": run,
        "run_id": status.run_id,
        "mission": status.mission_name,
        "mission_sha256": status.mission_sha256,
        "seed": str(status.seed),
        "started_ns": str(status.stamp.time_ns - round(status.elapsed_s * 1e9)),
        "server_version": version,
    }
    if isinstance(description, pb.VehicleDescription):
        info |= {
            "vehicle": description.vehicle_id,
            "vehicle_sha256": description.sha256,
            "software_version": description.software_version,
            "session": description.session_id,
        }
    if isinstance(parameters, pb.ParametersStatus):
        info["parameters_sha256"] = parameters.sha256
    return info
