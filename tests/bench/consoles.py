"""Twenty consoles at 25 Hz, two of which have stalled: does anybody miss anything, and does anything grow?

    python -m tests.bench.consoles --minutes 15 --consoles 20 --stalled 2

Starts `bumpless serve` with its vehicle at a control period of 0.04 s, keeps missions flying, reads the
stream as so many browsers would, and prints missed control cycles, the least share of cycles that a console
saw, and how much memory of server and vehicle grew after the warm-up. Exit code 1 when a target is missed.
"""

import argparse
import asyncio
import contextlib
import os
import re
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import httpx
import psutil
import websockets
from websockets.typing import Origin

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from tests.bench import live_node

PERIOD_S = 0.04
WARM_SHARE = 0.2  # of the time, but not less than a mission's start
LEAST_SHARE, MOST_GROWTH = 0.999, 0.02


@dataclass
class Console:
    """What one browser saw after the warm-up."""

    first: int = 0
    last: int = 0
    seen: int = 0

    @property
    def share(self) -> float:
        """Of the cycles that there were."""
        return self.seen / (self.last - self.first + 1) if self.first else 0.0


@dataclass
class Watched:
    """The consoles, what the vehicle says of itself, and memory, MB."""

    consoles: list[Console] = field(default_factory=list)
    missed: int = 0
    memory: dict[str, tuple[float, float]] = field(default_factory=dict)


async def console(address: str, cookie: str, console: Console, started: asyncio.Event) -> None:
    """One browser: counts the control cycles it sees once the warm-up is over."""
    url = address.replace("http", "ws", 1) + "/api/stream"
    async with websockets.connect(
        url, additional_headers={"Cookie": cookie}, origin=Origin(address), compression=None
    ) as socket:
        async for data in socket:
            if not started.is_set():
                continue
            for message in pb.StreamFrame.FromString(data).messages:  # type: ignore[arg-type]
                if message.topic == "tlm/navigation":
                    cycle = pb.Navigation.FromString(message.payload).stamp.cycle
                    console.first = console.first or cycle
                    console.seen += cycle != console.last
                    console.last = cycle


async def stalled(address: str, cookie: str) -> None:
    """A browser that has opened the stream and reads nothing of it."""
    url = address.replace("http", "ws", 1) + "/api/stream"
    async with websockets.connect(
        url, additional_headers={"Cookie": cookie}, origin=Origin(address), compression=None, max_queue=1,
        ping_interval=None,
    ):  # fmt: skip
        await asyncio.Event().wait()


def vehicle_file(folder: Path) -> Path:
    """The shipped vehicle with another control period."""
    text = bumpless.load_vehicle("ts100").text
    changed = re.sub(r"(?m)^control_period_s = [\d.]+", f"control_period_s = {PERIOD_S}", text)
    path = folder / "ts100.toml"
    path.write_text(changed)
    return path


def memory_mb(server_pid: int, seen: live_node.Seen) -> dict[str, float]:
    """Resident memory now."""
    pids = {"server": server_pid, "vehicle": seen.health.process_id if seen.health else server_pid}
    return {name: psutil.Process(pid).memory_info().rss / 1e6 for name, pid in pids.items()}


async def watch(minutes: float, count: int, stalling: int) -> Watched:
    """Run it."""
    seen, watched, started = live_node.Seen(), Watched(), asyncio.Event()
    with tempfile.TemporaryDirectory() as data:
        os.environ["BUMPLESS_VEHICLE"] = str(vehicle_file(Path(data)))
        async with (
            live_node.server(data, "off") as (process, address),
            httpx.AsyncClient(base_url=address) as http,
            asyncio.TaskGroup() as group,
        ):
            await http.get("/")
            cookie = "; ".join(f"{name}={value}" for name, value in http.cookies.items())
            watched.consoles = [Console() for _ in range(count - stalling)]
            tasks = [group.create_task(live_node.stream(address, cookie, seen))]
            tasks += [group.create_task(console(address, cookie, one, started)) for one in watched.consoles]
            tasks += [group.create_task(stalled(address, cookie)) for _ in range(stalling)]
            while seen.health is None:
                await asyncio.sleep(0.5)
            tasks.append(group.create_task(live_node.keep_flying(http, seen, "docking")))
            await asyncio.sleep(WARM_SHARE * minutes * 60.0)
            before, missed = memory_mb(process.pid, seen), seen.health.missed_cycles
            started.set()
            await asyncio.sleep((1.0 - WARM_SHARE) * minutes * 60.0)
            after = memory_mb(process.pid, seen)
            watched.memory = {name: (before[name], after[name]) for name in before}
            watched.missed = seen.health.missed_cycles - missed
            for task in tasks:
                task.cancel()
    return watched


def report(watched: Watched, minutes: float, stalling: int) -> int:
    """Print the figures; the exit code."""
    least = min(one.share for one in watched.consoles)
    growth = {name: after / before - 1.0 for name, (before, after) in watched.memory.items()}
    print(
        f"{len(watched.consoles)} consoles and {stalling} stalled ones, {minutes:g} min at "
        f"{1 / PERIOD_S:g} Hz, {os.cpu_count()} CPUs, load average {os.getloadavg()[0]:.1f}"
    )
    print(f"  missed cycles  {watched.missed}")
    print(f"  cycles seen    {least:.2%} by the console that saw least (target {LEAST_SHARE:.1%})")
    for name, (before, after) in watched.memory.items():
        print(f"  {name:<13}  {before:.1f} MB, then {after:.1f} MB: {growth[name]:+.2%} after the warm-up")
    met = not watched.missed and least >= LEAST_SHARE and max(growth.values()) < MOST_GROWTH
    return 0 if met else 1


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--minutes", type=float, default=15.0)
    parser.add_argument("--consoles", type=int, default=20, help="those that stall among them")
    parser.add_argument("--stalled", type=int, default=2)
    given = parser.parse_args()
    with contextlib.suppress(KeyboardInterrupt):
        return report(
            asyncio.run(watch(given.minutes, given.consoles, given.stalled)), given.minutes, given.stalled
        )
    return 130


if __name__ == "__main__":
    sys.exit(main())
