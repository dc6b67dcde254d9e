"""Replay of a long log: opening, seeking and memory, in a process of its own. `python -m tests.bench.replay`.

    python -m tests.bench.replay [--hours 2] [--seeks 200] [--log FILE]

Without --log a flight of that length is flown and logged first, which takes minutes. Goals are issue 11's.
"""

import argparse
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil

from tests.bench.figure import Figure, figure

OVERVIEW = 900  # cycles, as the console asks for the whole run
DETAIL_S, DETAIL = 150.0, 1500


def figures(log: Path, seeks: int) -> Iterator[Figure]:
    """Wall-clock times, as a person waits for them, and what memory grew by."""
    from bumpless.runs.replay import Replay

    process = psutil.Process()
    opening = []
    for _ in range(5):
        begun = time.perf_counter()
        replay = Replay(log)
        replay.events()
        opening.append(time.perf_counter() - begun)
        replay.close()
    yield figure("replay_open", "replay: opening, with all events", opening, "s", at_most=1.0)
    replay = Replay(log)
    chance, taken, near = random.Random(1), [], []
    before = process.memory_info().rss
    for _ in range(seeks):
        at = chance.uniform(replay.first_s, replay.last_s)
        begun = time.perf_counter()
        frame = replay.at(at).SerializeToString()
        taken.append((time.perf_counter() - begun) * 1e3)
        begun = time.perf_counter()
        list(replay.frames(at, at + 10.0, 4000))
        near.append((time.perf_counter() - begun) * 1e3)
        assert frame
    yield figure("replay_seek", "replay: seek to any moment", taken, "ms", at_most=150.0)
    yield figure("replay_seek_worst", "replay: slowest of all seeks", [max(taken)], "ms", at_most=150.0)
    yield figure("replay_block", "replay: 10 s of every cycle", near, "ms")
    begun = time.perf_counter()
    list(replay.frames(replay.first_s, replay.last_s, OVERVIEW))
    whole = time.perf_counter() - begun
    yield figure("replay_overview", f"replay: the whole run in {OVERVIEW} cycles", [whole], "s")
    grown = (process.memory_info().rss - before) / 1e6
    title = f"replay: memory after {seeks} seeks and an overview"
    yield figure("replay_memory", title, [grown], "MB", at_most=100.0)
    replay.close()


def fly(target: Path, hours: float) -> None:
    """The docking mission, then hover to the end of a long duration."""
    import bumpless

    text = bumpless.load_mission("docking").text.replace("duration_s: 90", f"duration_s: {hours * 3600:.0f}")
    mission = target.with_suffix(".yaml")
    mission.write_text(text, encoding="utf-8")
    bumpless.fly(mission).save(target)


def main() -> None:
    """Command line; the log is made by a child, whose memory would otherwise count."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--hours", type=float, default=2.0)
    parser.add_argument("--seeks", type=int, default=200)
    parser.add_argument("--log", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        log = options.log or Path(folder) / "long.mcap"
        if not log.exists():
            made = f"from tests.bench.replay import fly, Path; fly(Path({str(log)!r}), {options.hours!r})"
            subprocess.run([sys.executable, "-c", made], check=True)
        print(f"{log.stat().st_size / 1e6:.0f} MB")
        for row in figures(log, options.seeks):
            mark = {True: "met", False: "NOT MET", None: ""}[row.met]
            print(f"{row.title:56s} {row.value:9.3f} {row.unit:4s} {row.goal:8s} {mark}")


if __name__ == "__main__":
    main()
