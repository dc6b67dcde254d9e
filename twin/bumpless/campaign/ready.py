"""Compiled code in a worker: one process of a machine compiles, the others wait for it and load."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache

from bumpless.config.mission.shipped import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.jit.decorator import cache_folder
from bumpless.sim.twin import simulate

try:
    import fcntl
except ImportError:  # no such locks on this system: then every worker compiles for itself
    fcntl = None


@cache
def ready() -> bool:
    """Load or make the compiled code, once per process."""
    mission = replace(shipped_mission("docking"), duration_s=1.0)
    with _one_at_a_time():
        simulate(mission, load_vehicle(mission.vehicle))
    return True


@contextmanager
def _one_at_a_time() -> Iterator[None]:
    if fcntl is None:
        yield
        return
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "compiling").open("a") as mark:
        fcntl.flock(mark, fcntl.LOCK_EX)
        yield
