"""How punctual is the control loop beside a loaded server? Lateness, missed cycles, memory.

    python -m tests.bench.live_node --minutes 10 --streams 5 [--dragging]

Starts `bumpless serve` with its vehicle node and the full scene in a folder of its own, reads the stream
as N browsers would, keeps missions flying, and prints what the node says about itself in topic "health".
With --dragging a planner edits all the time: a new request for a nominal flight and a fan every 50 ms.
"""

import argparse
import asyncio
import contextlib
import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator
from dataclasses import dataclass, field
from pathlib import Path

import httpx
import psutil
import websockets
from websockets.typing import Origin, Subprotocol

from bumpless.config.mission import missions_folder
from bumpless.contract import bumpless_pb2 as pb
from tests.ports import free_port

ROOT = Path(__file__).parents[2]
OVER = (pb.MISSION_PHASE_IDLE, pb.MISSION_PHASE_COMPLETED, pb.MISSION_PHASE_ABORTED)


@dataclass
class Seen:
    """What the streams brought."""

    health: pb.Health | None = None
    phase: int = pb.MISSION_PHASE_UNSPECIFIED
    bytes: int = 0
    frames: int = 0
    peaks: dict[str, int] = field(default_factory=dict)


@contextlib.asynccontextmanager
async def server(data: str, scene: str) -> AsyncIterator[tuple[asyncio.subprocess.Process, str]]:
    """A server with its node; the address it printed."""
    environment = {**os.environ, "BUMPLESS_DATA_DIR": data, "BUMPLESS_SCENE": scene, "PYTHONPATH": str(ROOT)}
    environment["BUMPLESS_ZENOH_LISTEN"] = f"tcp/127.0.0.1:{free_port()}"
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", "bumpless_server.cli.main", "serve", "--port", "0",
        cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    assert process.stdout is not None
    try:
        while line := (await process.stdout.readline()).decode():
            if found := re.search(r"http://\S+:\d+", line):
                break
        else:
            raise SystemExit("the server ended before it printed its address")
        yield process, found[0]
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.terminate()
        await process.wait()


async def stream(address: str, cookie: str, seen: Seen) -> None:
    """One browser's worth of /api/stream."""
    url = address.replace("http", "ws", 1) + "/api/stream"
    headers, origin = {"Cookie": cookie}, Origin(address)
    async with websockets.connect(url, additional_headers=headers, origin=origin, compression=None) as socket:
        async for data in socket:
            seen.bytes += len(data)
            seen.frames += 1
            for message in pb.StreamFrame.FromString(data).messages:  # type: ignore[arg-type]
                if message.topic == "tlm/health":
                    seen.health = pb.Health.FromString(message.payload)
                elif message.topic == "tlm/mission":
                    seen.phase = pb.MissionStatus.FromString(message.payload).phase


async def viewer(address: str, cookie: str) -> None:
    """One viser client's worth of the scene."""
    import viser

    url = address.replace("http", "ws", 1) + "/scene"
    async with websockets.connect(
        url,
        additional_headers={"Cookie": cookie},
        origin=Origin(address),
        subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
        compression=None,
        max_size=None,
    ) as socket:
        async for _ in socket:
            pass


async def planner(address: str, cookie: str, mission: str) -> None:
    """Somebody who drags a handle and never lets go."""
    text = (missions_folder() / f"{mission}.yaml").read_text(encoding="utf-8")
    url = address.replace("http", "ws", 1) + "/ws/foresight"
    headers, origin = {"Cookie": cookie}, Origin(address)
    async with websockets.connect(url, additional_headers=headers, origin=origin) as socket:

        async def edit() -> None:
            for number in itertools.count(1):
                edited = text.replace("  heading_deg: 0", f"  heading_deg: {number % 100 / 100}", 1)
                await socket.send(json.dumps({"id": number, "text": edited, "seed": 1, "flights": 200}))
                await asyncio.sleep(0.05)

        editing = asyncio.create_task(edit())
        try:
            async for _ in socket:
                pass
        finally:
            editing.cancel()


async def keep_flying(http: httpx.AsyncClient, seen: Seen, mission: str) -> None:
    """Start the mission again whenever it is over."""
    while True:
        if seen.phase in OVER:
            await http.post("/api/mission/start", json={"name": mission})
        await asyncio.sleep(1.0)


def note_memory(process_id: int, seen: Seen) -> None:
    """Peak memory of the server, from the system's own account."""
    status = Path(f"/proc/{process_id}/status").read_text()
    seen.peaks["server"] = int(re.search(r"VmHWM:\s+(\d+)", status)[1])  # type: ignore[index]
    if seen.health is not None and psutil.pid_exists(seen.health.process_id):
        status = Path(f"/proc/{seen.health.process_id}/status").read_text()
        seen.peaks["node"] = int(re.search(r"VmHWM:\s+(\d+)", status)[1])  # type: ignore[index]


async def observe(minutes: float, streams: int, scene: str, mission: str, dragging: bool = False) -> Seen:
    """Run it and return what was seen."""
    seen = Seen()
    with tempfile.TemporaryDirectory() as data:
        async with server(data, scene) as (process, address), httpx.AsyncClient(base_url=address) as http:
            await http.get("/")
            cookie = "; ".join(f"{name}={value}" for name, value in http.cookies.items())
            tasks = [asyncio.create_task(stream(address, cookie, seen)) for _ in range(streams)]
            if scene != "off":
                tasks.append(asyncio.create_task(viewer(address, cookie)))
            began = time.monotonic()
            while seen.health is None and time.monotonic() - began < 300:
                await asyncio.sleep(0.5)
            if seen.health is None:
                raise SystemExit("no vehicle came to life")
            tasks.append(asyncio.create_task(keep_flying(http, seen, mission)))
            if dragging:
                tasks.append(asyncio.create_task(planner(address, cookie, mission)))
            await asyncio.wait(tasks, timeout=minutes * 60.0, return_when=asyncio.FIRST_EXCEPTION)
            note_memory(process.pid, seen)
            for task in tasks:
                if task.done() and (fault := task.exception()):
                    raise fault
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
    return seen


def report(seen: Seen, minutes: float, streams: int, scene: str) -> int:
    """Print the figures; 1 when a cycle was missed."""
    h = seen.health
    assert h is not None
    cpus, load = os.cpu_count(), os.getloadavg()[0]
    server_mb, node_mb = (seen.peaks[name] / 1024 for name in ("server", "node"))
    print(
        f"live node, {minutes:g} min, {streams} streams, scene {scene}, {cpus} CPUs, load average {load:.1f}"
    )
    print(f"  cycles        {h.cycles} flown, {h.missed_cycles} missed, {h.dropped_rows} not published")
    print(f"  lateness      p99 {h.lateness_p99_ms:.3f} ms, max {h.lateness_max_ms:.3f} ms")
    print(f"  cycle time    p50 {h.cycle_time_p50_us:.0f} us, p99 {h.cycle_time_p99_us:.0f} us")
    print(f"  streams       {seen.frames} frames, {seen.bytes / 1e6:.1f} MB")
    print(f"  peak memory   server {server_mb:.0f} MB, node {node_mb:.0f} MB")
    return 1 if h.missed_cycles else 0


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--streams", type=int, default=5)
    parser.add_argument("--scene", choices=("full", "light", "off"), default="full")
    parser.add_argument("--mission", default="docking")
    parser.add_argument("--dragging", action="store_true", help="beside a planner who edits all the time")
    options = parser.parse_args()
    seen = asyncio.run(
        observe(options.minutes, options.streams, options.scene, options.mission, options.dragging)
    )
    return report(seen, options.minutes, options.streams, options.scene)


if __name__ == "__main__":
    sys.exit(main())
