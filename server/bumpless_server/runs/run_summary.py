"""What one MCAP file says about its run, read without its messages unless its end is missing."""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mcap.reader import make_reader

COMPLETE, INTERRUPTED, RECORDING = "complete", "interrupted", "recording"
METRICS_ATTACHMENT = "metrics.json"
MAGIC = b"\x89MCAP0\r\n"
CUT_OFF = "the recording was cut off"


@dataclass(frozen=True)
class RunSummary:
    """A finished run. `metrics` is bumpless.Metrics as JSON, None when there are none."""

    id: str
    run_id: str
    mission: str
    mission_sha256: str
    vehicle: str
    started_ns: int  # UNIX time
    duration_s: float
    state: str  # "complete" or "interrupted"
    end_reason: str
    messages: int
    dropped: int
    metrics: dict[str, Any] | None


def is_whole(path: Path) -> bool:
    """True when the file has its end: a cut one lacks the closing magic."""
    with path.open("rb") as file:
        if file.seek(0, 2) < 2 * len(MAGIC):
            return False
        file.seek(-len(MAGIC), 2)
        return file.read() == MAGIC


def summarise(path: Path) -> RunSummary:
    """Read a file's metadata and metrics. A file that cannot be read is listed as interrupted."""
    metadata: dict[str, dict[str, str]] = {}
    metrics: dict[str, Any] | None = None
    messages, seconds, first_ns = 0, 0.0, 0
    reason = CUT_OFF
    try:
        with path.open("rb") as file:
            reader = make_reader(file)
            summary = reader.get_summary()
            if summary is not None and summary.statistics is not None:
                statistics = summary.statistics
                messages, first_ns = statistics.message_count, statistics.message_start_time
                seconds = (statistics.message_end_time - first_ns) * 1e-9
            for record in reader.iter_metadata():
                metadata[record.name] = record.metadata
            for attachment in reader.iter_attachments():
                if attachment.name == METRICS_ATTACHMENT:
                    metrics = json.loads(attachment.data, parse_constant=lambda _: None)
    except Exception as error:  # whatever a damaged file makes of its reader: the other runs stay listed
        reason = f"the file cannot be read: {error or type(error).__name__}"
    info, end = metadata.get("run", {}), metadata.get("end", {})
    state = end.get("state", INTERRUPTED)
    return RunSummary(
        id=path.stem,
        run_id=info.get("run_id", path.stem),
        mission=info.get("mission", ""),
        mission_sha256=info.get("mission_sha256", ""),
        vehicle=info.get("vehicle", ""),
        started_ns=_number(info.get("started_ns"), first_ns),
        duration_s=_duration(end.get("duration_s"), seconds),
        state=state if state in (COMPLETE, INTERRUPTED) else INTERRUPTED,
        end_reason=end.get("reason", reason),
        messages=_number(end.get("messages"), messages),
        dropped=_number(end.get("dropped"), 0),
        metrics=metrics,
    )


def _number(text: str | None, otherwise: int) -> int:
    return int(text) if text and text.lstrip("-").isdigit() else otherwise


def _duration(text: str | None, otherwise: float) -> float:
    try:
        seconds = float(text or "nan")
    except ValueError:
        return otherwise
    return seconds if math.isfinite(seconds) else otherwise
