"""The update loop: wakes with the vehicle's telemetry, draws the newest state, idles when nobody watches."""

import logging
import threading
import time
from collections.abc import Callable
from typing import Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import pose
from bumpless_server.scene.cameras import Cameras
from bumpless_server.scene.picture import Picture
from bumpless_server.scene.status import flown_mode, trail_mode
from bumpless_server.scene.trail import Track

log = logging.getLogger(__name__)

WAKES_ON = "tlm/navigation"
SHORTEST_TICK_S = 0.04  # a faster vehicle is drawn at 25 pictures a second
LONGEST_TICK_S = 1.0  # pictures go out at least this often, so that silence is a fault
LABELS_EACH = 5  # pictures: labels make way for each other a few times a second
UNWATCHED_SHARE = 4  # with nobody watching, every fourth position still goes into the track


class Recorder:
    """Feeds the track from the state, watched or not; a new run or a restarted vehicle starts a new one."""

    def __init__(self, state: Any, track: Track) -> None:
        self._state, self.track = state, track
        self._run = ("", "")
        self._seen: Any = None

    def step(self) -> None:
        """Take in the newest position."""
        mission: Any = self._state.latest("mission") or pb.MissionStatus()
        description: Any = self._state.latest("description") or pb.VehicleDescription()
        run = (mission.run_id or self._run[0], description.session_id or self._run[1])
        if run != self._run:
            self._run = run
            self.track.clear()
        navigation: Any = self._state.latest("navigation")
        if navigation is None or navigation is self._seen:
            return
        self._seen = navigation
        supervisor: Any = self._state.latest("supervisor") or pb.Supervisor()
        self.track.add(
            pose.vector(navigation.position_ned_m),
            trail_mode(mission.phase, flown_mode(mission.phase, supervisor)),
        )


class Live(threading.Thread):
    """The scene's own thread."""

    def __init__(
        self, state: Any, cameras: Cameras, track: Track, make_picture: Callable[[], Picture]
    ) -> None:
        super().__init__(name="scene", daemon=True)
        self._state, self._cameras, self._make_picture = state, cameras, make_picture
        self._recorder = Recorder(state, track)
        self._wake, self._stopping = threading.Event(), threading.Event()
        self._count = 0
        self.pictures = 0  # drawn since the start
        self.cpu_s = 0.0  # spent on them
        self.picture: Picture | None = None  # once the thread runs
        self._unsubscribe = state.subscribe(self._heard)

    def _heard(self, sample: Any) -> None:
        """On the dispatcher's thread: only note that there is something new."""
        if sample.topic != WAKES_ON:
            return
        self._count += 1
        if len(self._cameras) or self._count % UNWATCHED_SHARE == 0:
            self._wake.set()

    def wake(self) -> None:
        """Somebody came to watch."""
        self._wake.set()

    def stop(self) -> None:
        """End the thread and wait for it."""
        self._unsubscribe()
        self._stopping.set()
        self._wake.set()
        self.join(timeout=5.0)

    def run(self) -> None:
        """Until stopped: wait for news, record, draw."""
        self.picture = picture = self._make_picture()
        while True:
            self._wake.wait(self._patience())
            self._wake.clear()
            if self._stopping.is_set():
                return
            begun = time.monotonic()
            try:
                self._recorder.step()
                if len(self._cameras):
                    self._draw(picture)
            except Exception:
                log.exception("a picture failed")
            self._stopping.wait(
                max(0.0, SHORTEST_TICK_S - (time.monotonic() - begun)) if len(self._cameras) else 0
            )

    def _draw(self, picture: Picture) -> None:
        cpu = time.thread_time()
        picture.update()
        self._cameras.carry(picture.places)
        if self.pictures % LABELS_EACH == 0:
            self._cameras.make_way(picture.labels)
        self.cpu_s += time.thread_time() - cpu
        self.pictures += 1

    def _patience(self) -> float | None:
        """How long to wait for telemetry; for ever when nobody watches."""
        if not len(self._cameras):
            return None
        change = self._state.next_link_change_s()
        return LONGEST_TICK_S if change is None else min(LONGEST_TICK_S, max(change, 0.01))
