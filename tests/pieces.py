"""A flight whose recording a crash cut, which was taken up again and went on as a hold: three files."""

from pathlib import Path
from typing import Any

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import encoded
from bumpless.runs.flown import Flown
from bumpless.runs.info import ending_of
from bumpless.runs.names import CONTEXT, MISSION
from bumpless.runs.pieces import piece_name
from bumpless.runs.writer import RunWriter

Told = tuple[int, str, Any]  # time, topic, message


def in_pieces(
    run: bumpless.Run, folder: Path, cut_s: float, again_s: float, held_s: float = 0.0, clock_ns: int = 0
) -> list[Path]:
    """The flight's files: up to `cut_s`, where the server was killed; from `again_s` on; a hold of `held_s`.

    clock_ns: by how much the server's clock was set forward in between.
    """
    source = run._source
    assert isinstance(source, Flown)
    told: list[Told] = list(source.timed())
    start_ns = source.started_ns
    context = [one for one in told if one[1] in CONTEXT][:3]
    before = [one for one in told if one[0] < start_ns + cut_s * 1e9]
    after = [one for one in told if one[0] >= start_ns + again_s * 1e9]
    first, second, third = (folder / f"{piece_name(run.info.run_id, k)}.mcap" for k in (1, 2, 3))
    _write(first, before, killed=True)
    _write(second, [*((after[0][0], *one[1:]) for one in context), *after], clock_ns)
    if not held_s:
        return [first, second]
    _write(third, [*((after[-1][0], *one[1:]) for one in context), *_hold(after, held_s)], clock_ns)
    return [first, second, third]


def _write(path: Path, told: list[Told], clock_ns: int = 0, killed: bool = False) -> None:
    status = next(message for _, topic, message in told if topic == MISSION)
    growing = path.with_name(f"growing-{path.name}") if killed else path
    writer = RunWriter(growing, status, path.stem, durable=False)
    for time_ns, topic, message in told:
        writer.write(topic, message.DESCRIPTOR.full_name, encoded(message), time_ns + clock_ns, message)
        if topic == MISSION:
            writer.status = message
    if not killed:
        writer.finish(*ending_of(writer.status))
        return
    writer.flush()
    path.write_bytes(growing.read_bytes())  # as a kill leaves it: no end, no figures
    writer.abandon()
    growing.unlink()


def _hold(flown: list[Told], seconds: float) -> list[Told]:
    """The last cycle again, once a second, after the mission's end."""
    newest = {topic: (time_ns, message) for time_ns, topic, message in flown if hasattr(message, "stamp")}
    last = max(message.stamp.mission_time_s for _, message in newest.values())
    made: list[Told] = []
    for k in range(1, int(seconds) + 1):
        for topic, (time_ns, message) in newest.items():
            if topic in CONTEXT or topic == "event":
                continue
            again = type(message).FromString(message.SerializeToString())
            again.stamp.mission_time_s = last + k
            again.stamp.time_ns = message.stamp.time_ns + k * 1_000_000_000
            again.stamp.cycle = message.stamp.cycle + 20 * k
            if isinstance(again, pb.Supervisor | pb.MissionStatus):
                again.phase = pb.MISSION_PHASE_COMPLETED
            made.append((time_ns + k * 1_000_000_000, topic, again))
    return sorted(made, key=lambda one: one[0])
