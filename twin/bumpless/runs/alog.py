"""A run as an `.alog` for MOOS-IvP's tools: what the vehicle believed, wanted and said, in their words.

MOOS counts x to the east, y to the north and headings from 0 to 360; times are seconds since the log's start.
"""

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, TextIO

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.modes import LOOKS
from bumpless.runs.cut import Range
from bumpless.runs.run import Run

SOURCE = "bumpless"
Line = tuple[str, float | str]


def write_alog(run: Run, path: Path, part: Range) -> int:
    """Write it; returns how many lines of values that are. Raises ValueError when there are none."""
    count, mode = 0, ""
    started_s = run.info.started_ns * 1e-9
    with path.open("w", encoding="utf-8", newline="\n") as file:
        _head(file, path.name.removesuffix(".part"), started_s)
        for _, message in run.messages():
            at = message.stamp.mission_time_s  # type: ignore[attr-defined]
            if not part.holds(at):
                continue
            for name, value in _lines(message):
                if name == "BUMPLESS_MODE":
                    if value == mode:
                        continue
                    mode = str(value)
                told = _one_line(value) if isinstance(value, str) else f"{value:.6f}"
                file.write(f"{at:<15.5f} {name:<22} {SOURCE:<12} {told}\n")
                count += 1
    if not count:
        raise ValueError(f"the log has nothing in the range {part}")
    return count


def _head(file: TextIO, name: str, started_s: float) -> None:
    opened = datetime.fromtimestamp(max(0.0, started_s), UTC).strftime("%a %b %d %H:%M:%S %Y")
    rule = "%" * 80
    file.write(f"{rule}\n%% LOG FILE:       {name}\n%% FILE OPENED ON  {opened}\n")
    file.write(f"%% LOGSTART        {started_s:.3f}\n{rule}\n")


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _lines(message: Any) -> Iterator[Line]:
    match message:
        case pb.Navigation():
            at, yaw = message.position_ned_m, message.attitude.yaw_deg
            yield "NAV_X", at.y
            yield "NAV_Y", at.x
            yield "NAV_DEPTH", at.z
            yield "NAV_HEADING", yaw % 360.0
            yield "NAV_SPEED", message.speed_over_ground_mps
        case pb.Guidance():
            yield "DESIRED_SPEED", message.surge_speed_reference_mps
            yield "DESIRED_HEADING", message.attitude_reference.yaw_deg % 360.0
            yield "DESIRED_DEPTH", message.depth_reference_m
        case pb.Actuators():
            for actuator in message.actuators:
                yield f"ACTUATOR_{actuator.name.upper()}", actuator.feedback
        case pb.Supervisor():
            look = LOOKS.get(message.mode)
            yield "BUMPLESS_MODE", look.name.upper() if look else "NONE"
        case pb.Event():
            yield "BUMPLESS_EVENT", f"{message.code}: {message.text}"
