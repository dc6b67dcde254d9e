"""The whole picture: takes the newest messages, updates what changed. One thread calls it."""

import logging
import time
from collections.abc import Callable
from math import radians
from typing import Any, TypeVar, cast

import numpy as np
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import MOVING
from bumpless_server.scene import palette, pose
from bumpless_server.scene.attainable import AttainableSets
from bumpless_server.scene.cameras import turned
from bumpless_server.scene.current import CurrentView
from bumpless_server.scene.envelopes import SetView
from bumpless_server.scene.error_line import ErrorView, reference_from
from bumpless_server.scene.ghost_view import GhostView
from bumpless_server.scene.ghosts import Ghosts
from bumpless_server.scene.held_ring import WORDS, Held, HeldView, HeldWatch
from bumpless_server.scene.labels import Labelled
from bumpless_server.scene.places import Places
from bumpless_server.scene.plan import PlanView
from bumpless_server.scene.status import body_text, flown_mode, trail_mode
from bumpless_server.scene.target import TargetView
from bumpless_server.scene.trail import Track, TrailView
from bumpless_server.scene.vehicle_view import VehicleView
from bumpless_server.scene.water import WaterView, plane_depth

log = logging.getLogger(__name__)

FORCE_INSET = np.array([1.1, 0.0, -1.45])  # levelled body axes, m
MOMENT_INSET = np.array([-1.1, 0.0, -1.45])
M = TypeVar("M", bound=Message)


class Picture:
    """Draws `state` into a viser server's scene."""

    def __init__(
        self,
        state: Any,
        server: Any,
        track: Track,
        sets: AttainableSets,
        parse: Callable[[str], Any],
        light: bool,
        ghosts: Ghosts | None = None,
        holds: Callable[[], Held | None] = lambda: None,
    ) -> None:
        self._state, self._server, self._sets, self._parse, self._light = state, server, sets, parse, light
        self.labels = scene = Labelled(server.scene)
        scene.set_up_direction("-z")
        scene.configure_environment_map(None)
        scene.configure_default_lights(enabled=False)
        scene.add_light_directional("/sun", intensity=1.7, position=(-3.0, 4.0, -10.0))
        scene.add_light_hemisphere(
            "/light", sky_color=(235, 245, 255), ground_color=(120, 140, 160), intensity=1.1
        )
        self.places = Places()
        self.water = WaterView(scene)
        self.plan = PlanView(scene)
        self.target = TargetView(scene)
        self.held = HeldView(scene)
        self._held = HeldWatch(state, holds)
        self.current = CurrentView(scene)
        self.trail = TrailView(scene, track)
        self.force = SetView(scene, "force", "attainable force", "XYZ", "N", palette.FORCE_SET)
        self.moment = SetView(scene, "moment", "attainable moment", "KMN", "N·m", palette.MOMENT_SET)
        self.label = scene.add_label("/view/status", "", position=(0.0, 0.0, -0.32), anchor="bottom-center")
        self.error = ErrorView(scene)
        self.ghosts = GhostView(scene, ghosts or Ghosts())
        self.vehicle: VehicleView | None = None
        self._described = ""
        self._drawn: dict[str, Message] = {}
        self._beat = scene.add_frame("/view/beat", show_axes=False, visible=False)

    def update(self) -> None:
        """One picture out of the newest state."""
        live = self._state.link == pb.LINK_STATE_LIVE
        self._describe()
        with self._server.atomic():
            self._surroundings(live)
            self._body(live)
            self._wrench(live)
            self.trail.draw()
            # something always changes, so a browser can tell a quiet vehicle from a dead link
            self._beat.position = (time.monotonic() % 1000.0, 0.0, 0.0)

    def _fresh(self, topic: str, kind: type[M]) -> M | None:
        """The newest message of a topic unless it was drawn already."""
        message = self._state.latest(topic)
        if message is None or self._drawn.get(topic) is message:
            return None
        self._drawn[topic] = message
        return cast(M, message)

    def _last(self, topic: str, kind: type[M]) -> M:
        """The newest message of a topic, or an empty one."""
        return cast(M, self._state.latest(topic) or self._drawn.get(topic) or kind())

    def _describe(self) -> None:
        description = self._fresh("description", pb.VehicleDescription)
        if description is None or description.sha256 == self._described:
            return
        self._described = description.sha256
        try:
            vehicle = self._parse(description.vehicle_toml)
        except ValueError:
            log.exception("the vehicle's description cannot be drawn")
            if self.vehicle is not None:  # another vehicle's hull would be a lie
                self.vehicle.remove()
                self.vehicle = None
            return
        with self._server.atomic():
            if self.vehicle is not None:
                self.vehicle.remove()
            self.vehicle = VehicleView(self._server.scene, vehicle, self._light)
            self.ghosts.describe(vehicle)
        self._sets.vehicle(vehicle)

    def _surroundings(self, live: bool) -> None:
        if (plan := self._fresh("plan", pb.Plan)) is not None and self.plan.show(plan):
            self.places.path = self.plan.points
        planned = bool(self._last("mission", pb.MissionStatus).run_id)  # before a run it is all zeros
        if not planned:
            self.target.hide()
        elif (target := self._fresh("target", pb.Target)) is not None:
            self.target.show(target)
            self.places.target = pose.vector(target.position_ned_m)
            self.places.target_heading = radians(target.heading_deg)
            self.places.observation = pose.vector(target.observation_point_ned_m)
        phase = self._last("mission", pb.MissionStatus).phase
        held = self._held.now(time.monotonic()) if planned else None
        self.held.show(held, self.places.target)
        holds = WORDS[held.zone] if held is not None else ""
        self.target.name(self._last("target", pb.Target), live, phase in MOVING, holds)
        if (supervisor := self._fresh("supervisor", pb.Supervisor)) is not None:
            self.target.thresholds(supervisor)
        deepest = plane_depth(
            self.places.vehicle[2],
            *(p[2] for p in self.places.path),
            *(p[2] for p in (self.places.target, self.places.observation) if p is not None),
        )
        if deepest > self.water.depth_m or deepest < self.water.depth_m - 4.0:
            self.water.sink(deepest)

    def _body(self, live: bool) -> None:
        mission = self._last("mission", pb.MissionStatus)
        supervisor = self._last("supervisor", pb.Supervisor)
        if (navigation := self._fresh("navigation", pb.Navigation)) is not None:
            position = pose.vector(navigation.position_ned_m)
            heading = radians(navigation.attitude.yaw_deg)
            self.places.vehicle, self.places.heading = position, heading
            attitude = pose.of_attitude(navigation.attitude)
            self.water.follow(position)
            self.force.place(turned(FORCE_INSET, heading), attitude)
            self.moment.place(turned(MOMENT_INSET, heading), attitude)
            if self.vehicle is not None:
                self.vehicle.turn(navigation.attitude)
        navigation = self._last("navigation", pb.Navigation)
        self.ghosts.update(mission.run_id, navigation.stamp.mission_time_s)
        self.current.show(navigation, live)
        self.error.show(self._reference(supervisor, navigation.depth_m) if live else None)
        if self.vehicle is not None:
            if (actuators := self._fresh("actuators", pb.Actuators)) is not None:
                self.vehicle.move_actuators(actuators)
            self.vehicle.show(trail_mode(mission.phase, flown_mode(mission.phase, supervisor)), live)
        text = body_text(self._state.link, self._state.telemetry_age_s, mission.phase, supervisor, navigation)
        if text != self.label.text:
            self.label.text = text

    def _reference(self, supervisor: pb.Supervisor, depth_m: float) -> np.ndarray | None:
        guidance = self._state.latest("guidance")
        if guidance is None:
            return None
        return reference_from(guidance, supervisor, depth_m, self.places.path, self.places.observation)

    def _wrench(self, live: bool) -> None:
        speed = self._last("navigation", pb.Navigation).velocity_through_water_body_mps.x
        if (sets := self._sets.near(speed, time.monotonic())) is not None:
            at = f"u = {sets.speed_mps:.2f} m/s"
            self.force.show_set(sets.force, f"attainable force · {at}")
            self.moment.show_set(sets.moment, f"attainable moment · {at}")
        self.force.show_live(live, palette.FORCE_SET)
        self.moment.show_live(live, palette.MOMENT_SET)
        control = self._last("control", pb.Control)
        if live:
            d, c = control.demanded, control.achieved
            self.force.show_wrench(np.array([d.x_n, d.y_n, d.z_n]), np.array([c.x_n, c.y_n, c.z_n]))
            self.moment.show_wrench(np.array([d.k_nm, d.m_nm, d.n_nm]), np.array([c.k_nm, c.m_nm, c.n_nm]))
