"""One vehicle node process: started by us in its own session, or found alive and adopted."""

import contextlib
import json
import os
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import psutil

from bumpless_server.data_dir import write_whole

LOG_LIMIT_BYTES = 5_000_000


@dataclass(frozen=True)
class NodeProcess:
    """A process that outlives us if we are killed; identified by its id and its time of creation."""

    pid: int
    created: float
    child: subprocess.Popen[bytes] | None = None  # None: adopted

    @property
    def adopted(self) -> bool:
        """True when an earlier server started it."""
        return self.child is None

    def wait(self, timeout_s: float | None = None) -> int | None:
        """Wait for its end; its exit code when known. Raises TimeoutError."""
        try:
            if self.child is not None:
                return self.child.wait(timeout_s)
            return psutil.Process(self.pid).wait(timeout_s) if self.alive() else None
        except (subprocess.TimeoutExpired, psutil.TimeoutExpired) as error:
            raise TimeoutError(f"process {self.pid} did not end") from error
        except psutil.NoSuchProcess:
            return None

    def alive(self) -> bool:
        """True while this very process runs: another one with its recycled id does not count."""
        if self.child is not None:
            return self.child.poll() is None
        return _is_same(self.pid, self.created)

    def signal(self, number: signal.Signals) -> None:
        """Send a signal to it and all that it started."""
        if self.alive():
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self.pid, number)


def spawn(command: tuple[str, ...], log_file: Path, record: Path) -> NodeProcess:
    """Start the node in a session of its own, so that neither Ctrl-C nor our death reaches it.

    Its output goes to a file: a pipe to us would break it when we are killed. `record` remembers it; a node
    that cannot be remembered is ended again, for nobody would find it. Raises OSError.
    """
    if log_file.exists() and log_file.stat().st_size > LOG_LIMIT_BYTES:
        log_file.replace(log_file.with_suffix(".log.1"))
    with log_file.open("ab") as output:
        child = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            close_fds=True,
        )
    try:
        created = psutil.Process(child.pid).create_time()
    except psutil.NoSuchProcess:
        created = 0.0
    try:
        write_whole(record, json.dumps({"pid": child.pid, "created": created}).encode())
    except BaseException:
        child.kill()
        child.wait()
        raise
    return NodeProcess(child.pid, created, child)


def adopt(record: Path) -> NodeProcess | None:
    """The node that an earlier server left running, or None."""
    try:
        told = json.loads(record.read_bytes())
        pid, created = int(told["pid"]), float(told["created"])
    except (OSError, ValueError, KeyError, TypeError):
        return None
    return NodeProcess(pid, created) if _is_same(pid, created) else None


def _is_same(pid: int, created: float) -> bool:
    try:
        process = psutil.Process(pid)
        return abs(process.create_time() - created) < 0.05 and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False
