"""A ring round the target: on which headings station is held, by the rule of the check, as in the plan and
in Operate. A heading is drawn where the hull lies with it, its bow to the dock.

Whole and double where it holds, broken where it may not, thin with teeth where it can't; a head inside marks
the heading that was taken. One node of constant shape; a segment that is not needed collapses into a point.
"""

from collections.abc import Callable, Sequence
from typing import Any, Protocol

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import MOVING
from bumpless_server.scene import palette
from bumpless_server.scene.water import WORLD

RADIUS_M = 2.6
OUTER, TOOTH = 1.025, 1.05  # of the radius
STEP_DEG = 2  # a segment
DASH = 3  # segments drawn and left out in turn where it may not hold
TOOTH_DEG = 8
SEGMENTS = 2 * 360 // STEP_DEG + 360 // TOOTH_DEG + 3
INKS = {"accepted": palette.HOLDS, "warned": palette.MAY_NOT_HOLD, "refused": palette.CANT_HOLD}
WORDS = {"accepted": "holds", "warned": "may not hold", "refused": "can't hold"}
EACH_S = 1.5  # asked for again at most so often,
STEP_MPS = 0.005  # and once the estimate has moved by so much


class Arc(Protocol):
    """Headings that hold station alike, from the first clockwise to the last, deg."""

    @property
    def zone(self) -> str: ...
    @property
    def from_deg(self) -> float: ...
    @property
    def to_deg(self) -> float: ...


class Held(Protocol):
    """On which headings station is held, and whether the one that was taken, deg, does."""

    @property
    def arcs(self) -> Sequence[Arc]: ...
    @property
    def heading_deg(self) -> float: ...
    @property
    def zone(self) -> str: ...


def along(heading_deg: Any, share: Any = 1.0) -> np.ndarray:
    """Where the hull lies with these headings, at a share of the radius: NED from the target, m."""
    turn = np.radians(np.asarray(heading_deg, float) + 180.0)
    return RADIUS_M * np.stack([share * np.cos(turn), share * np.sin(turn), 0.0 * turn], axis=-1)


def zones(held: Held) -> list[str]:
    """The zone of each heading, 0 to 359."""
    found = [""] * 360
    for arc in held.arcs:
        first, last = round(arc.from_deg), round(arc.to_deg)
        for heading in range(first, first + (last - first) % 360 + 1):
            found[heading % 360] = arc.zone
    return found


def ring(held: Held) -> tuple[np.ndarray, np.ndarray]:
    """Segments (n, 2, 3), NED from the target in m, and their colours (n, 2, 3)."""
    zone = zones(held)
    starts = np.arange(0, 360, STEP_DEG)
    ends, of = starts + STEP_DEG, [zone[k + STEP_DEG // 2] for k in starts]
    drawn = np.array([z != "warned" or (k // DASH) % 2 == 0 for k, z in enumerate(of)])
    whole = np.array([z == "accepted" for z in of])
    teeth = np.arange(TOOTH_DEG // 2, 360, TOOTH_DEG)
    refused = np.array([zone[k] == "refused" for k in teeth])
    taken = held.heading_deg
    head = [(taken - 3.0, 0.87), (taken, 0.97), (taken + 3.0, 0.87)]
    corners = [along(*corner) for corner in head]
    segments = np.concatenate(
        [
            np.stack([along(starts), along(np.where(drawn, ends, starts))], axis=1),
            np.stack([along(starts, OUTER), along(np.where(whole, ends, starts), OUTER)], axis=1),
            np.stack([along(teeth), along(teeth, np.where(refused, TOOTH, 1.0))], axis=1),
            np.stack([corners, corners[1:] + corners[:1]], axis=1),
        ]
    )
    inks = [INKS.get(z, palette.STALE) for z in (*of, *of, *(zone[k] for k in teeth))] + [palette.TARGET] * 3
    colours = np.array([palette.vertex_colour(ink) for ink in inks], np.uint8)
    return segments.astype(np.float32), np.repeat(colours[:, None, :], 2, axis=1)


class HeldWatch:
    """What holds now, asked for again only when what it depends on has changed."""

    def __init__(self, state: Any, ask: Callable[[], Held | None]) -> None:
        self._state, self._ask = state, ask
        self._asked: tuple[object, ...] = ()
        self._asked_s = float("-inf")
        self._told: Held | None = None

    def now(self, now_s: float) -> Held | None:
        """By the estimate of now; None where nothing flies that is heard."""
        about = self._about()
        if about is None:
            self._asked, self._asked_s, self._told = (), float("-inf"), None
        elif about != self._asked and now_s - self._asked_s >= EACH_S:
            self._asked, self._asked_s, self._told = about, now_s, None
            self._told = self._ask()
        return self._told

    def _about(self) -> tuple[object, ...] | None:
        topics = ("navigation", "target", "mission", "parameters", "description", "supervisor")
        navigation, target, mission, parameters, description, supervisor = (
            self._state.latest(topic) for topic in topics
        )
        if self._state.link != pb.LINK_STATE_LIVE or None in (navigation, target, mission):
            return None
        if mission.phase not in MOVING:
            return None
        flow = navigation.current_estimate_ned_mps
        return (
            *(round(part / STEP_MPS) for part in (flow.x, flow.y)),
            round(target.heading_deg),
            mission.run_id,
            supervisor.docking_stage if supervisor is not None else 0,
            parameters.revision if parameters is not None else 0,
            description.sha256 if description is not None else "",
        )


class HeldView:
    """Draws it about the target."""

    def __init__(self, scene: Any) -> None:
        self._shown: Held | None = None
        self.node = scene.add_line_segments(
            f"{WORLD}/holds",
            np.zeros((SEGMENTS, 2, 3), np.float32),
            np.zeros((SEGMENTS, 2, 3), np.uint8),
            thickness=1.6,
            thickness_units="screen",
            visible=False,
        )

    def show(self, held: Held | None, target_ned_m: np.ndarray | None) -> None:
        """The ring at the target's depth; nothing where either is not known."""
        visible = False
        if held is not None and target_ned_m is not None:
            visible = True
            if held is not self._shown:
                self.node.points, self.node.colors = ring(held)
                self._shown = held
            if not np.array_equal(self.node.position, target_ned_m):
                self.node.position = target_ned_m
        if self.node.visible != visible:
            self.node.visible = visible
