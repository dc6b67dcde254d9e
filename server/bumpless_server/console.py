"""Everything behind the web: bus, state, recorder, catalogue and supervision, started and stopped as one.

It has threads of its own and knows no event loop: a stalled web server cannot hold it up.
"""

import contextlib
import logging
import threading
import time
from pathlib import Path

from google.protobuf.message import Message

from bumpless.config.vehicle import Vehicle, VehicleError, parse_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.version import software_version
from bumpless.runs.names import COMPLETE
from bumpless.runs.view import View
from bumpless_server.alarms.limits import read_limits
from bumpless_server.alarms.watch import Watch
from bumpless_server.data_dir import DataDir
from bumpless_server.live.bus import Bus, NoAnswer
from bumpless_server.live.dispatch import Dispatcher
from bumpless_server.live.sample import EVENT, Sample
from bumpless_server.live.state import State
from bumpless_server.live.stream import Stream
from bumpless_server.plan.missions import Missions
from bumpless_server.plan.presets import Presets
from bumpless_server.runs.catalogue import Catalogue
from bumpless_server.runs.disk_budget import DiskBudget
from bumpless_server.runs.recorder import Recorder
from bumpless_server.runs.replays import Replays
from bumpless_server.runs.shelf import Shelf
from bumpless_server.settings import Settings
from bumpless_server.vehicle_process.node_command import node_command
from bumpless_server.vehicle_process.supervise import Supervisor
from bumpless_server.views.foxglove import Foxglove
from bumpless_server.views.ready import envelopes_ready

log = logging.getLogger(__name__)

_LEVELS = {pb.SEVERITY_WARNING: logging.WARNING, pb.SEVERITY_ALARM: logging.ERROR}


class Console:
    """One vehicle's console. `start` raises DataDirError or BusError with one line for the operator."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.version = software_version()
        self.data = DataDir(settings.data_dir)
        self.state = State(settings.vehicle_id)
        self.missions = Missions(self.data.missions, vehicle=self.vehicle)
        self.presets = Presets(self.data.presets)
        self.catalogue = Catalogue(self.data.runs, self.data.index)
        self.replays = Replays()
        self.shelf = Shelf(self.data.words, self.data.bin)
        self.recorder = Recorder(
            self.data.runs,
            self.say,
            self._recorded,
            _views,
            settings.recorder_queue_messages,
            settings.recorder_queue_bytes,
            DiskBudget(
                self.data.runs,
                settings.runs_max_bytes,
                settings.disk_free_bytes,
                *([self._prune] if settings.runs_prune else []),
            ),
        )
        self.alarms = Watch(
            lambda: read_limits(self.data.limits / f"{settings.vehicle_id}.toml"),
            self.data.alarms,
            self._tell,
        )
        self.stream = Stream(self.state)
        self.dispatcher = Dispatcher(self.state, self.status, self._on_link)
        self.bus = Bus(
            self.state.vehicle_id,
            settings.zenoh_listen,
            settings.zenoh_connect,
            self.dispatcher.sample,
            self.dispatcher.alive,
        )
        self.supervisor = Supervisor(
            node_command(settings), self.data.node_log, self.data.node_record, self.say, self._ask_node_to_end
        )
        self.indexed = threading.Event()  # set when the catalogue has seen every file
        self.started = False
        self._stopping = False  # losing the node is then no alarm
        self._vehicle: tuple[str, Vehicle] | None = None
        self._stop = contextlib.ExitStack()

    def start(self) -> None:
        """Open and start everything, or nothing."""
        if self.started:
            return
        with contextlib.ExitStack() as stack:
            self.data.open()
            stack.callback(self.data.close)
            self.shelf.open()
            self.catalogue.open()
            stack.callback(self.catalogue.close)
            stack.callback(self.replays.close)
            self.state.subscribe(self.recorder.offer)
            self.recorder.start()
            stack.callback(self.recorder.stop)
            self.dispatcher.start()
            stack.callback(self.dispatcher.stop)
            self.state.subscribe(self.alarms.offer)
            self.alarms.start()
            stack.callback(self.alarms.stop)
            self.bus.open()
            stack.callback(self.bus.close)
            indexing = threading.Thread(target=self._index, name="catalogue", daemon=True)
            indexing.start()
            stack.callback(indexing.join)
            if self.settings.manage_node:
                self.supervisor.start()
                stack.callback(self.supervisor.stop)
            self._stop = stack.pop_all()
        self.started = True

    def stop(self) -> None:
        """End the managed node, close the file being written and leave the bus."""
        self.started, self._stopping = False, True
        self._stop.close()

    def status(self) -> pb.ServerStatus:
        """The server's own state now. `telemetry_age_s` is negative when nothing was ever heard."""
        run = self.recorder.recording
        age = self.state.telemetry_age_s
        return pb.ServerStatus(
            time_ns=time.time_ns(),
            vehicle_id=self.state.vehicle_id,
            link=self.state.link,
            telemetry_age_s=age if age != float("inf") else -1.0,
            recording=run is not None,
            recording_run_id=run.id if run is not None else "",
            recorded_bytes=run.flushed_bytes if run is not None else 0,
            recorder_trouble=self.recorder.trouble,
            recorder_dropped=self.recorder.dropped + self.dispatcher.dropped,
            node_restarts=self.supervisor.restarts,
            stream_clients=len(self.stream),
            server_version=self.version,
            node_managed=self.settings.manage_node,
        )

    def command(self, verb: str, request: Message) -> pb.CommandReply:
        """Ask the vehicle. Blocks; raises NoAnswer."""
        return self.bus.command(verb, request, self.settings.command_timeout_s)

    def vehicle(self) -> Vehicle | None:
        """The vehicle as it describes itself on the bus; None when it has not, or not in our terms."""
        description = self.state.latest("description")
        if not isinstance(description, pb.VehicleDescription):
            return None
        if self._vehicle is None or self._vehicle[0] != description.vehicle_toml:
            try:
                vehicle = parse_vehicle(description.vehicle_toml, f"{description.vehicle_id}.toml")
            except VehicleError as error:
                log.warning("the vehicle's description cannot be read: %s", error)
                return None
            self._vehicle = (description.vehicle_toml, vehicle)
        return self._vehicle[1]

    def say(self, severity: pb.Severity, code: str, text: str, details: dict[str, str]) -> None:
        """Tell the operator something of the server's own, as an event beside the vehicle's."""
        log.log(_LEVELS.get(severity, logging.INFO), "%s", text)
        event = pb.Event(
            stamp=pb.Stamp(time_ns=time.time_ns()),
            severity=severity,
            code=code,
            text=text,
            details={**details, "source": "server"},
        )
        payload = event.SerializeToString()
        self.dispatcher.sample(Sample(EVENT, event.DESCRIPTOR.full_name, payload, from_vehicle=False))

    def _tell(self, sample: Sample) -> None:
        self.dispatcher.sample(sample)

    def _on_link(self, link: pb.LinkState) -> None:
        log.info("link to %s: %s", self.state.vehicle_id, pb.LinkState.Name(link).removeprefix("LINK_STATE_"))
        self.supervisor.on_link(link)
        if link == pb.LINK_STATE_LOST and not self._stopping:
            self.recorder.link_lost()
            self.say(pb.SEVERITY_ALARM, "link_lost", f"The link to {self.state.vehicle_id} is lost", {})

    def _recorded(self, path: Path) -> None:
        try:
            self.catalogue.add(path)
        except Exception:
            log.exception("%s could not be indexed", path)

    def _prune(self) -> bool:
        """Delete the oldest complete run; what was interrupted may be all there is of an accident."""
        complete = [row.summary for row in self.catalogue.rows() if row.summary.state == COMPLETE]
        if not complete or not self.catalogue.delete(complete[-1].id):
            return False
        text = f"Run {complete[-1].id} was deleted: runs may take {self.settings.runs_max_bytes} bytes"
        self.say(pb.SEVERITY_WARNING, "run_deleted", text, {"run": complete[-1].id})
        return True

    def _index(self) -> None:
        try:
            for path in self.catalogue.refresh(busy=self._busy):
                text = f"Run {path.stem} had been cut off and was repaired"
                self.say(pb.SEVERITY_INFO, "run_repaired", text, {"run": path.stem})
        except Exception:
            log.exception("the runs could not be indexed")
        finally:
            self.indexed.set()

    def _busy(self) -> Path | None:
        run = self.recorder.recording
        return run.path if run is not None else None

    def _ask_node_to_end(self) -> None:
        try:
            self.bus.command("shutdown", pb.Empty(), timeout_s=1.5)
        except NoAnswer as error:
            log.info("the node did not confirm its shutdown: %s", error)


def _views() -> tuple[View, ...]:
    """What a recorded run holds beside the bus."""
    return (Foxglove(envelopes_ready),)
