"""Everything behind the web: bus, state, recorder, catalogue and supervision, started and stopped as one.

It has threads of its own and knows no event loop: a stalled web server cannot hold it up.
"""

import contextlib
import json
import logging
import secrets
import threading
import time
from pathlib import Path
from typing import Any

from bumpless.chart import DepthGrid, to_bytes
from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import Vehicle, VehicleError, parse_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.version import software_version
from bumpless.runs.names import DESCRIPTION
from bumpless.runs.view import View
from bumpless_server.access.accounts import Accounts, AccountsError
from bumpless_server.access.lease import Lease
from bumpless_server.access.sessions import Sessions
from bumpless_server.alarms.limits import read_limits
from bumpless_server.alarms.watch import Watch
from bumpless_server.audit import Audit
from bumpless_server.data_dir import DataDir
from bumpless_server.foresight.checked import Findings
from bumpless_server.foresight.foresight import Foresight
from bumpless_server.foresight.job import Present
from bumpless_server.live.ask import NoAnswer
from bumpless_server.live.bus import Bus
from bumpless_server.live.clock import VehicleClock
from bumpless_server.live.desk import Desk
from bumpless_server.live.dispatch import Dispatcher
from bumpless_server.live.freshness import freshness
from bumpless_server.live.heart import Heart
from bumpless_server.live.intake import Intake
from bumpless_server.live.rivals import Rivals
from bumpless_server.live.sample import AUDIT, CONTROL, EVENT, Sample
from bumpless_server.live.speaker import Speaker
from bumpless_server.live.state import State
from bumpless_server.live.stream import Stream
from bumpless_server.live.tally import KINDS, Tally, printable
from bumpless_server.live.tune_again import tune_again
from bumpless_server.live.tuned import Tuned
from bumpless_server.plan.charts.store import Charts
from bumpless_server.plan.library import Library
from bumpless_server.plan.missions import Missions
from bumpless_server.plan.presets import Presets
from bumpless_server.runs.catalogue import Catalogue
from bumpless_server.runs.disk_budget import DiskBudget
from bumpless_server.runs.errands import Errands
from bumpless_server.runs.flights import Flights
from bumpless_server.runs.keeper import Keeper
from bumpless_server.runs.recorder import Recorder
from bumpless_server.runs.replays import Replays
from bumpless_server.runs.run_views import RunViews
from bumpless_server.runs.shelf import Shelf
from bumpless_server.runs.watch import FolderWatch
from bumpless_server.scene.ghosts import Ghosts
from bumpless_server.settings import Settings
from bumpless_server.vehicle_process.node_command import node_command
from bumpless_server.vehicle_process.supervise import Supervisor
from bumpless_server.views.foxglove import Foxglove
from bumpless_server.views.ready import envelopes_ready
from bumpless_server.what_if.desk import WhatIfDesk
from bumpless_server.what_if.revisions import Revisions

log = logging.getLogger(__name__)

_LEVELS = {pb.SEVERITY_WARNING: logging.WARNING, pb.SEVERITY_ALARM: logging.ERROR}


class Console:
    """One vehicle's console. `start` raises DataDirError, BusError or AccountsError with one line to read."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.version = software_version()
        self.data = DataDir(settings.data_dir)
        self.state = State(settings.vehicle_id)
        self.missions = Missions(self.data.missions, vehicle=self.vehicle)
        self.library = Library(self.missions, self.data)
        self.presets = Presets(self.data.presets)
        self.charts = Charts(self.data.charts)
        self.findings = Findings(self.charts)
        self.foresight = Foresight(self._present, charts=self.data.charts)  # on the web's loop, which ends it
        self.catalogue = Catalogue(self.data.runs, self.data.index)
        self.replays = Replays()
        self.flights = Flights()
        self.errands = Errands(self.data.scratch)
        self.what_if = WhatIfDesk()  # on the web's loop, which ends it
        self.ghosts = Ghosts()  # for the scene
        self.revisions = Revisions(self.data.revisions)
        self.run_views = RunViews(self.data.run_views)
        self.shelf = Shelf(self.data.words, self.data.run_bin)
        self.budget = DiskBudget(
            self.data.runs,
            settings.runs_max_bytes,
            settings.disk_free_bytes,
            *([self._prune] if settings.runs_prune else []),
        )
        self.keeper = Keeper(self.data.runs, self.catalogue, self._busy, self.say)
        self.recorder = Recorder(
            self.data.runs,
            self.say,
            self.keeper.recorded,
            _views,
            settings.recorder_queue_messages,
            settings.recorder_queue_bytes,
            self.budget,
            depths=self._depths_of,
        )
        self.alarms = Watch(
            lambda: read_limits(self.data.limits / f"{settings.vehicle_id}.toml"),
            self.data.alarms,
            self._tell,
            self.data.runs,
        )
        self.stream = Stream(self.state)
        self.lease = Lease(self._control, self.say)
        self.accounts = Accounts(self.data.access)
        self.sessions = Sessions(
            self.data.access / "sessions.json", self.accounts, settings.session_hours * 3600.0
        )
        self.tally, self.clock, self.speaker = Tally(self._set_aside), VehicleClock(), Speaker()
        rivals = Rivals(self.state.vehicle_id, self.say)
        self.dispatcher = Dispatcher(
            self.state,
            self._on_time,
            self._on_link,
            Intake(self.tally, self.speaker, self.clock, rivals),
            self.recorder.offer,
        )
        self.bus = Bus(
            self.state.vehicle_id,
            settings.zenoh_listen,
            settings.zenoh_connect,
            self.dispatcher.sample,
            self.dispatcher.alive,
            self.speaker,
            self.tally,
            rivals,
            settings.zenoh_config,
        )
        self.audit = Audit(self.data.audit, self._audited)
        self.desk = Desk(
            self.bus.command,
            lambda: self.speaker.session,
            self.clock,
            settings.command_timeout_s,
            self.audit,
            self.tally,
        )
        self.tuned = Tuned(self.state)
        self.state.subscribe(self._heard)
        self.supervisor = Supervisor(
            node_command(settings), self.data.node_log, self.data.node_record, self.say, self._ask_node_to_end
        )
        self.started = False
        self._stopping = False  # losing the node is then no alarm
        self._vehicle: tuple[str, Vehicle] | None = None
        self._unread = ""
        self._stop = contextlib.ExitStack()

    def start(self) -> None:
        """Open and start everything, or nothing."""
        if self.started:
            return
        with contextlib.ExitStack() as stack:
            self.data.open()
            stack.callback(self.data.close)
            self._let_somebody_in()
            self.audit.open()
            self.shelf.open()
            self.errands.open()
            self.revisions.open()
            self.catalogue.open()
            stack.callback(self.catalogue.close)
            stack.callback(self.replays.close)
            self.state.subscribe(self.recorder.offer)
            self.recorder.start()
            stack.callback(self.recorder.stop)
            self.dispatcher.start()
            stack.callback(self.dispatcher.stop)
            stack.callback(self.desk.close)
            self.state.subscribe(self.alarms.offer)
            self.alarms.start()
            stack.callback(self.alarms.stop)
            stack.callback(self.bus.close)
            self.bus.open()
            heart = Heart(self._beat)
            heart.start()
            stack.callback(heart.stop)
            indexing = threading.Thread(
                target=self.keeper.index, args=(self._tell_left_out,), name="catalogue", daemon=True
            )
            indexing.start()
            stack.callback(indexing.join)
            watch = FolderWatch(self.data.runs, self.keeper.found)
            watch.start()
            stack.callback(watch.stop)
            if self.settings.manage_node:
                stack.callback(self.supervisor.stop)
                self.supervisor.start()
            if self.bus.notice:
                self.say(pb.SEVERITY_WARNING, "bus_open", self.bus.notice, {})
            self._stop = stack.pop_all()
        self.started = True

    def _let_somebody_in(self) -> None:
        """The first account, where a file has its password; without any, nobody could log in."""
        path = self.settings.first_password_file
        if not self.accounts.any() and path is not None:
            try:
                password = path.read_text(encoding="utf-8").strip()
                self.accounts.add("engineer", "engineer", password)
            except (OSError, ValueError) as error:
                raise AccountsError(f"no first account by {path}: {error}") from error
        if self.accounts.trouble:
            raise AccountsError(self.accounts.trouble)
        if self.settings.accounts_needed and not self.accounts.any():
            raise AccountsError(
                "nobody could log in: make an account with `bumpless user add NAME --role engineer "
                f"--data-dir {self.settings.data_dir}`"
            )

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
            topics=freshness(self.state),
            clock_offset_s=self.clock.offset_s,
            bus_notice=self.bus.notice,
            set_aside=self.tally.total,
        )

    def vehicle(self) -> Vehicle | None:
        """The vehicle as it describes itself on the bus; None when it has not, or not in our terms."""
        description = self.state.latest("description")
        if not isinstance(description, pb.VehicleDescription):
            return None
        if self._vehicle is None or self._vehicle[0] != description.vehicle_toml:
            try:
                vehicle = parse_vehicle(description.vehicle_toml, f"{description.vehicle_id}.toml")
            except VehicleError as error:
                if self._unread != description.vehicle_toml:
                    log.warning("the vehicle's description cannot be read: %s", printable(str(error)))
                self._unread = description.vehicle_toml
                return None
            self._vehicle = (description.vehicle_toml, vehicle)
        return self._vehicle[1]

    def left_out(self) -> list[tuple[str, str, str]]:
        """(folder, name, reason) of what lies in the data folder and stands in no list."""
        folders = {
            "runs": self.catalogue,
            "missions": self.missions,
            "presets": self.presets,
            "charts": self.charts,
        }
        return [
            (folder, name, reason)
            for folder, kept in folders.items()
            for name, reason in kept.left_out().items()
        ]

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

    def _set_aside(self, kind: str, example: str) -> None:
        """Tell once of each kind that something is not taken as it comes."""
        self.say(
            pb.SEVERITY_WARNING, "set_aside", f"{KINDS[kind]} ({example})", {"kind": kind, "last": example}
        )

    def _heard(self, sample: Sample) -> None:
        if sample.topic == DESCRIPTION and self.settings.manage_node:
            tune_again(self.tuned, self.desk, self.say)

    def _on_time(self) -> pb.ServerStatus:
        """Twice a second, on the dispatcher's thread."""
        self.lease.tick()
        return self.status()

    def _beat(self) -> None:
        self.bus.beat(self.lease.present())

    def _control(self, state: pb.ControlHolder) -> None:
        payload = state.SerializeToString()
        self._tell(Sample(CONTROL, state.DESCRIPTOR.full_name, payload, from_vehicle=False))
        self._beat()  # who takes control and starts at once is known to the vehicle before the start

    def _audited(self, entry: dict[str, Any]) -> None:
        """Each line of the audit also goes into the log of the run that it is about."""
        told = pb.AuditEntry(
            time_ns=time.time_ns(),
            details_json=json.dumps(entry["details"]),
            **{name: entry[name] for name in ("id", "verb", "author", "address", "answer", "said", "took_s")},
        )
        self.recorder.note(
            Sample(AUDIT, told.DESCRIPTOR.full_name, told.SerializeToString(), from_vehicle=False)
        )

    def _tell(self, sample: Sample) -> None:
        self.dispatcher.sample(sample)

    def _on_link(self, link: pb.LinkState) -> None:
        log.info("link to %s: %s", self.state.vehicle_id, pb.LinkState.Name(link).removeprefix("LINK_STATE_"))
        self.supervisor.on_link(link)
        if link == pb.LINK_STATE_LOST and not self._stopping:
            self.recorder.link_lost()
            self.say(pb.SEVERITY_ALARM, "link_lost", f"The link to {self.state.vehicle_id} is lost", {})

    def _depths_of(self, plan: pb.Plan) -> bytes | None:
        """The depth grid that a mission being flown names, as it is stored now: the vehicle has no charts."""
        try:
            mission = self.charts.laid(parse_mission(plan.mission_yaml, plan.file_name, self.vehicle()))
        except Exception as error:  # a run is recorded with or without a floor
            log.warning("the depths under %s cannot be read: %s", printable(plan.file_name), error)
            return None
        return to_bytes(mission.depth_grid) if isinstance(mission.depth_grid, DepthGrid) else None

    def _prune(self) -> bool:
        return self.keeper.prune(self.settings.runs_max_bytes)

    def _tell_left_out(self) -> None:
        for folder, name, reason in self.left_out():
            self.tally.note("bad_file", f"{folder}/{name}: {reason}")

    def _busy(self) -> Path | None:
        run = self.recorder.recording
        return run.path if run is not None else None

    def _present(self) -> Present:
        tuned = self.tuned.present()
        return Present(self.vehicle(), tuned.SerializeToString() if tuned is not None else b"")

    def _ask_node_to_end(self) -> None:
        now = self.clock.to_vehicle(time.time_ns())
        header = pb.RequestHeader(id=secrets.token_hex(8), expires_ns=now + 1_500_000_000, author="server")
        try:
            self.bus.command("shutdown", pb.Empty(), header, timeout_s=1.5)
        except NoAnswer as error:
            log.info("the node did not confirm its shutdown: %s", error)


def _views() -> tuple[View, ...]:
    """What a recorded run holds beside the bus."""
    return (Foxglove(envelopes_ready),)
