"""Compiled code in a worker: one process of a machine compiles, the others wait for it and load."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
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
    with ExitStack() as held:
        with suppress(OSError):  # a folder that is not ours to write to: then nobody waits
            folder = cache_folder()
            folder.mkdir(parents=True, exist_ok=True)
            fcntl.flock(held.enter_context((folder / "compiling").open("a")), fcntl.LOCK_EX)
        yield
