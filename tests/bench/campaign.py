"""Rows about campaigns: many docking missions on two workers, and two workers beside one."""

import os
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from bumpless.campaign.cluster import opened as cluster
from bumpless.campaign.fly import fly_missing
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import load_campaign
from bumpless.campaign.report import write_report
from bumpless.campaign.store import opened as store
from bumpless.config.mission import missions_folder
from tests.bench.figure import Figure, figure

FILE = missions_folder() / "campaigns" / "docking_currents.yaml"
SHORT = missions_folder() / "campaigns" / "foresight.yaml"  # the first example: 90 s, straight in


@dataclass(frozen=True)
class Flown:
    """One campaign: seconds from nothing to the page, and of them flying."""

    wall_s: float
    flying_s: float


def figures(count: int) -> Iterator[Figure]:
    """Rows of `count` docking missions in drawn currents, on two workers and on one; and of short ones."""
    two, one = (_flown(_many(FILE, count), workers) for workers in (2, 1))
    short = _flown(_many(SHORT, count), 2)
    wall, title = (90.0, f"{count:,} docking missions, drawn currents, two workers, start to page")
    goal = wall * count / 10_000
    yield figure("campaign_s", title, [two.wall_s], "s", at_most=goal)
    title = f"{count:,} docking missions of 90 s, straight in, two workers, start to page"
    yield figure("campaign_short_s", title, [short.wall_s], "s", at_most=goal)
    title = f"{count:,} docking missions, drawn currents, one worker"
    yield figure("campaign_one_s", title, [one.wall_s], "s")
    yield figure(
        "campaign_two_vs_one",
        "missions a second, two workers against one",
        [one.flying_s / two.flying_s],
        "×",
        at_least=1.8,
    )
    load = os.getloadavg()[0]
    yield figure("campaign_load", "load of the machine at the end, ours included", [load], "processes")


def _many(file: Path, count: int) -> Prepared:
    loaded = load_campaign(file)
    return Prepared(replace(loaded.campaign, count=count), loaded.setups)


def _flown(prepared: Prepared, workers: int) -> Flown:
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        with store(Path(folder), prepared, False) as kept:
            with cluster(workers=workers) as client:
                flying = _timed(lambda: fly_missing(prepared, kept, client))
            write_report(prepared, kept, FILE.name)
        return Flown(time.perf_counter() - begin, flying)


def _timed(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin
