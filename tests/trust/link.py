"""Cuts of the link in a mission: how soon is it said, how soon live again, and what is missing afterwards?"""

import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import stamp_of
from bumpless.runs.read import log_messages
from tests.node.cut import cuttable
from tests.ports import free_port
from tests.trust.figure import Figure, at_most, exactly
from tests.trust.running import ROOT, await_true, events, light, seeing, settings, start

STALE_S, RESUMED_S = 1.0, 2.0
QUIET = (pb.LINK_STATE_STALE, pb.LINK_STATE_LOST)


def figures(cuts: tuple[float, ...] = (1.0, 5.0, 30.0)) -> Iterator[Figure]:
    """Cut for each of these times, s, with a pause asked for meanwhile; then read the log."""
    port = free_port()
    with tempfile.TemporaryDirectory() as folder, cuttable(port) as link:
        of = settings(Path(folder), f"tcp/127.0.0.1:{port}", manage_node=False, command_timeout_s=2.0)
        node = subprocess.Popen(light(f"tcp/127.0.0.1:{link.port}"), cwd=ROOT, stderr=subprocess.DEVNULL)
        try:
            with seeing(of) as (running, seen):
                run = start(running)
                stale, resumed = [], []
                for cut_s in cuts:
                    time.sleep(2.0)
                    at = time.monotonic()
                    link.cut(silently=True)
                    stale.append(seen.until_link(*QUIET, since=at))
                    assert running.http.post("/api/mission/pause").status_code == 503
                    time.sleep(max(0.0, at + cut_s - time.monotonic()))
                    joined = time.monotonic()
                    link.join()
                    resumed.append(seen.until_link(pb.LINK_STATE_LIVE, since=joined))
                time.sleep(3.0)
                missed = running.console.tally.of("missed")
                paused = len(events(running, "mission_paused"))
                assert running.http.post("/api/mission/abort").json()["accepted"]
                await_true(lambda: running.console.recorder.recording is None, "the end of the recording")
                (path,) = (Path(folder) / "data" / "runs").glob("*.mcap")
                assert path.stem == run
                stamps = [stamp_of(record.data) for _, record in log_messages(path, {"tlm/navigation"})]
                cycles = [stamp.cycle for stamp in stamps if stamp is not None]
        finally:
            node.kill()
            node.wait()
    gaps = cycles[-1] - cycles[0] + 1 - len(set(cycles))
    said = "/".join(f"{cut:g}" for cut in cuts)
    yield at_most("link", f"cuts of {said} s: longest until said to be stale", max(stale), "s", STALE_S)
    yield at_most("link", "longest until live again", max(resumed), "s", RESUMED_S)
    yield exactly("link", f"cycles that are missing of {len(cycles)} in the one log", gaps, "", 0)
    yield exactly("link", "messages that nobody has any more", missed, "", 0)
    yield exactly("link", "commands of meanwhile carried out late", paused, "", 0)
