"""A flown run to its file, by the writer of live recordings."""

from collections.abc import Sequence
from itertools import chain
from pathlib import Path

from bumpless.chart import to_bytes
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import encoded
from bumpless.metrics import Figures
from bumpless.runs.flown import Flown
from bumpless.runs.info import ending_of
from bumpless.runs.names import BYTES, MISSION, SEA_FLOOR
from bumpless.runs.view import View
from bumpless.runs.writer import RunWriter

_SHOW_EVERY = 500  # messages


def write_flown(flown: Flown, figures: Figures, path: Path, views: Sequence[View], progress: object) -> None:
    """Write what the bus would have carried, received the moment it was said."""
    said = flown.timed()
    first = next(said)
    status = first[2]
    assert first[1] == MISSION and isinstance(status, pb.MissionStatus)
    span_ns = max(1.0, 1e9 * float(flown.result.log["time"][-1]))
    writer = RunWriter(path, status, flown.info.id, views, durable=False)
    try:
        for time_ns, topic, message in chain([first], said):
            writer.write(topic, message.DESCRIPTOR.full_name, encoded(message), time_ns, message)
            if isinstance(message, pb.MissionStatus):
                writer.status = message
            if callable(progress) and writer.messages % _SHOW_EVERY == 0:
                progress((time_ns - flown.started_ns) / span_ns)
        grid = flown.result.mission.depth_grid
        if grid is not None:
            writer.attach(SEA_FLOOR, BYTES, to_bytes(grid))
        writer.finish(*ending_of(writer.status), figures=figures)
    except BaseException:
        writer.abandon()
        raise
