"""Keeps one vehicle node running: starts it, adopts it, starts it again when it dies, ends it.

An actor on its own thread: everything that happens (an exit, a change of the link, a stop) arrives in
one queue, so no decision waits for the web server and no two decisions cross.
"""

import logging
import math
import queue
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.exits import TAKEN
from bumpless_server.vehicle_process.process import NodeProcess, adopt, spawn

log = logging.getLogger(__name__)

HUNG_AFTER_S = 10.0  # without liveliness, though the process runs
YOUNG_S = 10.0  # a node that dies younger is not started again at once
BACK_OFF_S = (0.0, 1.0, 2.0, 5.0, 10.0, 30.0)
ASKED_S, TERMINATED_S = 4.0, 3.0  # patience before terminate, before kill

Say = Callable[[pb.Severity, str, str, dict[str, str]], None]


@dataclass(frozen=True)
class _Exit:
    process: NodeProcess
    code: int | None


@dataclass
class Supervisor:
    """Starts `command` as the vehicle node. `ask_to_end` sends it the shutdown command."""

    command: tuple[str, ...]
    log_file: Path
    record: Path
    say: Say
    ask_to_end: Callable[[], None]
    restarts: int = 0
    _inbox: "queue.SimpleQueue[_Exit | int | None]" = field(default_factory=queue.SimpleQueue)
    _thread: threading.Thread | None = None
    _process: NodeProcess | None = None
    _link: int = pb.LINK_STATE_WAITING
    _started_at: float = 0.0
    _early_deaths: int = 0
    _was_live: bool = False  # the present node was: it works, so a crash is mended at once
    _spawn_at: float | None = None
    _hung_at: float | None = None

    def start(self) -> None:
        """Adopt the node that is left from before, or start one."""
        process = adopt(self.record)
        if process is None:
            self._spawn()
        else:
            self._watch(process)
            self.say(
                pb.SEVERITY_INFO,
                "node_adopted",
                f"The vehicle node (process {process.pid}) was already running and goes on",
                {"pid": str(process.pid)},
            )
        self._thread = threading.Thread(target=self._run, name="supervise", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End the node, kindly first; returns when it is gone."""
        if self._thread is not None:
            self._inbox.put(None)
            self._thread.join()
        process, self._process = self._process, None
        if process is None:
            return
        if process.alive():
            self.ask_to_end()
        if not _ends(process, ASKED_S):
            process.signal(signal.SIGTERM)
        if not _ends(process, TERMINATED_S):
            process.signal(signal.SIGKILL)
            _ends(process, TERMINATED_S)
        self.record.unlink(missing_ok=True)

    def on_link(self, link: int) -> None:
        """Tell of a change of the link; callable from any thread, never waits."""
        self._inbox.put(link)

    @property
    def pid(self) -> int | None:
        """Process id of the managed node, if there is one."""
        process = self._process
        return None if process is None else process.pid

    def _run(self) -> None:
        while True:
            try:
                item = self._inbox.get(timeout=self._patience_s())
            except queue.Empty:
                self._on_time()
                continue
            if item is None:
                return
            if isinstance(item, _Exit):
                self._on_exit(item)
            else:
                self._on_link(item)
            self._on_time()

    def _patience_s(self) -> float | None:
        due = [at for at in (self._spawn_at if self._free() else None, self._hung_at) if at is not None]
        return max(0.0, min(due) - time.monotonic()) if due else None

    def _free(self) -> bool:
        """No node speaks for our vehicle: a second one would refuse to start."""
        return self._link not in (pb.LINK_STATE_LIVE, pb.LINK_STATE_STALE)

    def _on_time(self) -> None:
        now = time.monotonic()
        if self._hung_at is not None and now >= self._hung_at and self._process is not None:
            self._hung_at = None
            self.say(pb.SEVERITY_ALARM, "node_hung", "The vehicle node does not respond and is ended", {})
            self._process.signal(signal.SIGKILL)
        if self._spawn_at is not None and now >= self._spawn_at and self._free():
            self._spawn_at = None
            self._spawn()

    def _on_link(self, link: int) -> None:
        self._link = link
        self._hung_at = None
        self._was_live = self._was_live or (link == pb.LINK_STATE_LIVE and self._process is not None)
        if link == pb.LINK_STATE_LOST and self._process is not None:
            self._hung_at = time.monotonic() + HUNG_AFTER_S
        if link == pb.LINK_STATE_LOST and self._process is None:
            self._spawn_at = min(self._spawn_at or math.inf, time.monotonic())

    def _on_exit(self, ended: _Exit) -> None:
        if ended.process is not self._process:
            return
        self._process, self._hung_at = None, None
        self.record.unlink(missing_ok=True)
        young = time.monotonic() - self._started_at < YOUNG_S and not self._was_live
        self._early_deaths = self._early_deaths + 1 if young and not ended.process.adopted else 0
        wait_s = BACK_OFF_S[min(self._early_deaths, len(BACK_OFF_S) - 1)]
        self._spawn_at = time.monotonic() + wait_s
        if ended.code == TAKEN:
            text = "Another node speaks for this vehicle already; the console uses that one"
            self.say(pb.SEVERITY_WARNING, "node_elsewhere", text, {})
            return
        self.restarts += 1
        again = "it is started again" if wait_s == 0 else f"it is started again in {wait_s:g} s"
        self.say(
            pb.SEVERITY_ALARM,
            "node_died",
            f"The vehicle node ended unexpectedly ({_how(ended.code)}); {again}",
            {"pid": str(ended.process.pid), "exit": _how(ended.code), "restarts": str(self.restarts)},
        )

    def _spawn(self) -> None:
        try:
            process = spawn(self.command, self.log_file, self.record)
        except OSError as error:
            self._early_deaths += 1
            wait_s = BACK_OFF_S[min(self._early_deaths, len(BACK_OFF_S) - 1)]
            self._spawn_at = time.monotonic() + wait_s
            text = f"The vehicle node cannot be started: {error}"
            self.say(pb.SEVERITY_ALARM, "node_not_started", text, {})
            return
        self._watch(process)
        self.say(
            pb.SEVERITY_INFO,
            "node_started",
            f"The vehicle node was started (process {process.pid})",
            {"pid": str(process.pid)},
        )

    def _watch(self, process: NodeProcess) -> None:
        self._process, self._was_live = process, False
        self._started_at = time.monotonic()
        threading.Thread(
            target=lambda: self._inbox.put(_Exit(process, process.wait())), name="node-exit", daemon=True
        ).start()


def _ends(process: NodeProcess, patience_s: float) -> bool:
    try:
        process.wait(patience_s)
    except TimeoutError:
        log.warning("process %d has not ended within %g s", process.pid, patience_s)
        return False
    return True


def _how(code: int | None) -> str:
    if code is None:
        return "exit code not known"
    if code < 0:
        try:
            return f"signal {signal.Signals(-code).name}"
        except ValueError:
            return f"signal {-code}"
    return f"exit code {code}"
