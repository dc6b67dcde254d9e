"""kill -9 of the vehicle node, again and again: is it back, tuned, and does it what was declared?"""

import os
import signal
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil

from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from tests.trust.figure import Figure, at_most, exactly
from tests.trust.running import await_true, events, seeing, settings, start

BACK_S = 2.5


def figures(count: int, of: str = "ts100") -> Iterator[Figure]:
    """Kill the server's own node `count` times in flight; it declares to hold after a crash."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"{of}.toml"
        file.write_text(load_vehicle(of).text + '\n[failsafe]\nafter_crash = "hold"\n')
        with seeing(settings(Path(folder), vehicle=str(file))) as (running, seen):
            told = running.http.get("/api/parameters").json()["active"]
            told["hover"]["ramp_cycles"] = tuned = told["hover"]["ramp_cycles"] + 5
            assert running.http.put("/api/parameters", json=told).status_code == 200
            back, cpu, kept, held = [], [], 0, 0
            state = running.console.state
            for kill in range(1, count + 1):
                if kill == 1:
                    start(running)
                else:
                    running.http.post("/api/mission/resume")
                await_true(lambda: (Path(folder) / "data" / "flight.json").exists(), "a flight")
                pid, at = running.console.supervisor.pid or 0, time.monotonic()
                os.kill(pid, signal.SIGKILL)
                lost = seen.until_link(pb.LINK_STATE_LOST, since=at)
                back.append(seen.until_link(pb.LINK_STATE_LIVE, since=at + lost) + lost)
                used = psutil.Process(running.console.supervisor.pid).cpu_times()
                cpu.append(used.user + used.system)
                crashes = await_true(
                    lambda kill=kill: events(running, "failsafe")[kill - 1 : kill],
                    "the reaction",
                )
                held += crashes[0]["details"]["cause"] == "after_crash"
                await_true(
                    lambda kill=kill: len(events(running, "parameters_restored")) == kill, "parameters"
                )

                def flown_with() -> int:
                    status = state.latest("parameters")
                    return status.active.hover.ramp_cycles if isinstance(status, pb.ParametersStatus) else 0

                kept += bool(await_true(lambda: flown_with() == tuned, "the tuned parameters"))
    yield at_most("node", f"of {count} kills in a row, longest until live again", max(back), "s", BACK_S)
    yield at_most("node", "most of its own work until then", max(cpu), "s CPU", BACK_S)
    yield exactly("node", "times it came back tuned as before", kept, "", count)
    yield exactly("node", "times it held station as its file declares for a crash", held, "", count)
