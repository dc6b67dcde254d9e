"""Missions as the API tells them."""

from datetime import UTC, datetime
from typing import Any

from bumpless.config.mission import Mission
from bumpless_server.plan.marks import Mark
from bumpless_server.plan.missions import MissionFile
from bumpless_server.web.answers.contract import Answer, Problem

_UNMARKED = Mark()
Position = tuple[float, float, float]  # NED, m


class MissionSummary(Answer):
    """A stored mission in the list. `valid` false: the file breaks a rule and cannot be flown."""

    name: str
    file: str
    title: str
    summary: str
    vehicle: str
    duration_s: float | None
    seed: int | None
    sha256: str
    builtin: bool
    size: int
    tags: list[str]
    archived: bool
    valid: bool
    problems: list[Problem]
    modified: datetime

    @classmethod
    def of(cls, file: MissionFile, mark: Mark = _UNMARKED) -> "MissionSummary":
        """What a file says."""
        mission = file.mission
        return cls(
            name=file.name,
            file=file.path.name,
            title=(mission.title or mission.name) if mission else file.name,
            summary=mission.summary if mission else "",
            vehicle=mission.vehicle if mission else "",
            duration_s=mission.duration_s if mission else None,
            seed=mission.seed if mission else None,
            sha256=file.sha256,
            builtin=file.builtin,
            size=len(file.data),
            tags=list(mark.tags),
            archived=mark.archived,
            valid=mission is not None,
            problems=[Problem(**problem.as_dict()) for problem in file.problems],
            modified=datetime.fromtimestamp(int(file.path.stat().st_mtime), UTC),
        )


class Target(Answer):
    """Where a mission docks."""

    position_ned_m: Position
    heading_deg: float
    observation_point_ned_m: Position


class MissionDetail(MissionSummary):
    """A mission with its text, and what a sketch of its plan needs when the text is valid."""

    yaml: str
    path_ned_m: list[Position] | None = None  # the start first
    target: Target | None = None
    current_ned_mps: Position | None = None

    @classmethod
    def of(cls, file: MissionFile, mark: Mark = _UNMARKED) -> "MissionDetail":
        """What a file says, whole."""
        told = cls(**MissionSummary.of(file, mark).model_dump(), yaml=file.text)
        return told.model_copy(update=_plan(file.mission)) if file.mission else told


def _plan(mission: Mission) -> dict[str, Any]:
    target = mission.target
    return {
        "path_ned_m": list(mission.path_ned_m),
        "target": Target(
            position_ned_m=target.position_ned_m,
            heading_deg=target.heading_deg,
            observation_point_ned_m=target.observation_point_ned_m,
        ),
        "current_ned_mps": mission.environment.current_ned_mps,
    }
