"""Writes the file of one run, live or at once: see the package for the format."""

import contextlib
import logging
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from google.protobuf import json_format
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import MESSAGES, decoded, encoded, stamp_of
from bumpless.metrics import Figures, as_dict
from bumpless.runs import names
from bumpless.runs.columns import figures_of_file
from bumpless.runs.figures import json_bytes, outcome_event
from bumpless.runs.info import elapsed_ns, run_info
from bumpless.runs.mcap_file import McapFile
from bumpless.runs.names import CONTEXT, DESCRIPTION, PARAMETERS_STATUS, PLAN
from bumpless.runs.view import View, Views

log = logging.getLogger(__name__)

Beside = Callable[[pb.Plan], bytes | None]  # the depth grid that a plan names, where it is known
_Held = tuple[str, str, bytes, int, int, Message | None]


class RunWriter:
    """An open recording of the run that `status` tells of. Not thread-safe.

    The file's first record identifies the run by what the vehicle says of itself, its parameters and its
    plan. Until all three are heard, or until the first `flush`, messages are held back. `durable`: see
    `McapFile`. `depths` finds the depth grid that the plan names: the vehicle has no charts.
    """

    def __init__(
        self,
        path: Path,
        status: pb.MissionStatus,
        run: str | None = None,
        views: Sequence[View] = (),
        durable: bool = True,
        depths: Beside = lambda plan: None,
    ) -> None:
        self.id = run or status.run_id
        self.run_id = status.run_id
        self.path = path
        self.status = status  # the newest that the vehicle said
        self.messages = 0  # of the bus
        self.flushed_bytes = 0
        self.outcome: pb.Event | None = None  # once finished, where the run could be judged
        self._first_status = status
        self._views, self._depths = Views(views), depths
        self._grid: bytes | None = None
        self._said: dict[str, Message] = {}  # CONTEXT by topic
        self._held: list[_Held] | None = []
        self._end_ns = 0
        names.record_name(names.RUN_RECORD, self.id)  # a bad id is refused before there is a file
        self._file = McapFile(path, durable)
        try:
            self._flush()
        except BaseException:
            self.abandon()
            raise

    def write(
        self, topic: str, schema: str, payload: bytes, log_ns: int, message: Message | None = None
    ) -> None:
        """Add a message of the bus, byte by byte, and what views make of it.

        `schema` is the full message name; one that the contract does not know is kept without its schema.
        `log_ns` is the UNIX time at which it was received. `message` is what `payload` holds, if known.
        """
        stamp = stamp_of(payload) if message is None else getattr(message, "stamp", None)
        publish_ns = stamp.time_ns if stamp is not None and stamp.time_ns else log_ns
        self.messages += 1
        held = (topic, schema, payload, log_ns, publish_ns, message)
        if self._held is None:
            self._add(*held)
            return
        self._held.append(held)
        self._listen(topic, schema, payload, message)
        if len(self._said) == len(CONTEXT):
            self.flush()

    def attach(self, name: str, media_type: str, data: bytes) -> None:
        """Put a whole file into the log, once its first record is there."""
        self.flush()
        self._file.attach(name, media_type, data, self._end_ns)

    def flush(self) -> None:
        """Bring what was written to the disk; a killed process loses nothing older."""
        if self._held is not None:
            self._open()
        self._flush()

    def finish(self, state: str, reason: str, dropped: int = 0, figures: Figures | None = None) -> None:
        """Write how the run ended, and close the file.

        The outcome as its last event, the figures (computed from the file when None) and the end's record.
        """
        try:
            self.flush()
            if figures is None:
                figures = _figures(self.path, self.run_id, state, self.status, reason, self._grid)
            if figures is not None:
                self.outcome = outcome_event(figures[1], self.status)
                payload, kind = encoded(self.outcome), self.outcome.DESCRIPTOR.full_name
                self.write(names.EVENT, kind, payload, self._end_ns, self.outcome)
            end = {
                "state": state,
                "reason": reason,
                "ended_ns": str(self._end_ns),
                "duration_s": f"{elapsed_ns(self.status) * 1e-9:.3f}",
                "messages": str(self.messages),
                "dropped": str(dropped),
            }
            if figures is not None:
                metrics, outcome = figures
                self._file.attach(names.METRICS, names.JSON, json_bytes(as_dict(metrics)), self._end_ns)
                end |= outcome.record()
            self._file.metadata(names.record_name(names.END_RECORD, self.id), end)
        finally:
            self._file.close()

    def abandon(self) -> None:
        """Close the file after a failure, as well as the disk allows. What never began leaves nothing."""
        with contextlib.suppress(Exception):
            self._file.close()
        if self._held is not None:
            self.path.unlink(missing_ok=True)

    def _flush(self) -> None:
        self._file.flush()
        self.flushed_bytes = self.path.stat().st_size

    def _open(self) -> None:
        held, self._held = self._held or [], None
        description, parameters = self._said.get(DESCRIPTION), self._said.get(PARAMETERS_STATUS)
        info = run_info(self.id, self._first_status, description, parameters)  # type: ignore[arg-type]
        self._file.metadata(names.record_name(names.RUN_RECORD, self.id), info.record())
        began_ns = max(0, info.started_ns)
        for topic in self._said:
            self._attach(topic, began_ns)
        for one in held:
            self._add(*one, listen=False)

    def _add(
        self,
        topic: str,
        schema: str,
        payload: bytes,
        log_ns: int,
        publish_ns: int,
        message: Message | None,
        listen: bool = True,
    ) -> None:
        # a log's times go one way, whatever a clock does meanwhile
        log_ns = self._end_ns = max(self._end_ns, log_ns)
        self._file.message(topic, schema, MESSAGES.get(schema), payload, log_ns, publish_ns)
        for name, seen in self._views.see(schema, payload, message):
            kind = type(seen)
            self._file.message(name, kind.DESCRIPTOR.full_name, kind, encoded(seen), log_ns, publish_ns)
        if listen and self._listen(topic, schema, payload, message):
            self._attach(topic, log_ns)

    def _listen(self, topic: str, schema: str, payload: bytes, message: Message | None) -> bool:
        """True when this is the first word of a context topic."""
        if topic not in CONTEXT or topic in self._said:
            return False
        message = message if message is not None else decoded(schema, payload)
        if message is None or _is_other_plan(message, self._first_status):
            return False
        self._said[topic] = message
        return True

    def _attach(self, topic: str, log_ns: int) -> None:
        said: Any = self._said[topic]
        if topic == PLAN:
            name = Path(said.file_name or "mission.yaml").name
            self._file.attach(name, names.YAML, said.mission_yaml.encode(), log_ns)
            self._grid = self._depths(said)
            if self._grid is not None:
                self._file.attach(names.SEA_FLOOR, names.BYTES, self._grid, log_ns)
        elif topic == DESCRIPTION:
            self._file.attach(f"{said.vehicle_id}.toml", names.TOML, said.vehicle_toml.encode(), log_ns)
        elif topic == PARAMETERS_STATUS:
            text = said.parameters_json or json_format.MessageToJson(
                said.active, preserving_proto_field_name=True
            )
            self._file.attach(names.PARAMETERS, names.JSON, text.encode(), log_ns)


def _is_other_plan(said: Message, status: pb.MissionStatus) -> bool:
    return isinstance(said, pb.Plan) and said.sha256 != status.mission_sha256


def _figures(
    path: Path, run_id: str, state: str, status: pb.MissionStatus, reason: str, grid: bytes | None
) -> Figures | None:
    """The figures of a file; None without. A run is worth keeping without its figures."""
    try:
        return figures_of_file(path, run_id, state, status, reason, grid)
    except Exception:
        log.exception("the metrics of %s could not be computed", path)
        return None
