"""The attainable sets at the present speed, worked out beside the update loop.

The first call compiles and every call takes milliseconds, so it has a thread of its own; the loop asks and
later collects. Asked at most at 10 Hz and only when the speed changed.
"""

import logging
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

from bumpless_server.scene.hull_mesh import HullMesh, hull_mesh

log = logging.getLogger(__name__)

SPEED_STEP_MPS = 0.01
INTERVAL_S = 0.1
DIRECTIONS = 240  # of the support function: each gives a corner


@dataclass(frozen=True)
class Sets:
    """Both sets in body axes at a surge speed: force in N, moment in N m."""

    speed_mps: float
    force: HullMesh
    moment: HullMesh


def sets_of(vehicle: Any) -> Callable[[float], Sets]:
    """A function from surge speed through the water to the vehicle's sets."""
    from bumpless.physics.envelope import attainable_sets
    from bumpless.physics.model import build_model

    model = build_model(vehicle)

    def at(speed_mps: float) -> Sets:
        envelope = attainable_sets(model, speed_mps, DIRECTIONS)
        return Sets(speed_mps, hull_mesh(envelope.force.vertices), hull_mesh(envelope.moment.vertices))

    return at


class AttainableSets:
    """Keeps the sets of one vehicle near its present speed."""

    def __init__(self, make: Callable[[Any], Callable[[float], Sets]] = sets_of) -> None:
        self._make = make
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="scene-sets")
        self._vehicle: Any = None
        self._function: Callable[[float], Sets] | None = None
        self._pending: Future[Sets] | None = None
        self._asked_mps = float("nan")
        self._asked_at_s = float("-inf")

    def vehicle(self, vehicle: Any) -> None:
        """Another vehicle, or another version of it."""
        self._vehicle, self._function, self._asked_mps = vehicle, None, float("nan")

    def near(self, speed_mps: float, now_s: float) -> Sets | None:
        """New sets when some are ready; asks for others when the speed has moved on."""
        ready = None
        if self._pending is not None and self._pending.done():
            future, self._pending = self._pending, None
            error = future.exception()
            if error is None:
                ready = future.result()
            else:
                log.error("attainable sets failed", exc_info=error)
        moved = not abs(speed_mps - self._asked_mps) <= SPEED_STEP_MPS
        due = now_s - self._asked_at_s >= INTERVAL_S
        if self._vehicle is not None and self._pending is None and moved and due:
            self._asked_mps, self._asked_at_s = speed_mps, now_s
            self._pending = self._worker.submit(self._compute, self._vehicle, speed_mps)
        return ready

    def _compute(self, vehicle: Any, speed_mps: float) -> Sets:
        if self._function is None or vehicle is not self._vehicle:
            self._function = self._make(vehicle)
        return self._function(speed_mps)

    def stop(self) -> None:
        """End the thread."""
        self._worker.shutdown(wait=True, cancel_futures=True)
