"""A mission's bytes checked: what keeps them from being read, and what stands against the plan."""

import hashlib
import threading
from collections import OrderedDict
from collections.abc import Callable
from typing import Any

from bumpless.config.mission import Mission
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import Vehicle
from bumpless_server.foresight.findings import findings_of
from bumpless_server.foresight.told import ForesightFinding
from bumpless_server.plan.charts.store import Charts
from bumpless_server.plan.missions import parse_planned

MOST_KEPT = 64


def bare(mission: Mission) -> Mission:
    """The mission without a depth grid."""
    return mission


def checked(
    data: bytes, source: str, present: Vehicle | None = None, lay: Callable[[Mission], Mission] = bare
) -> dict[str, Any]:
    """{file, sha256, ok, problems, findings} of a mission file, as `bumpless validate --json` prints it.

    present: the vehicle on the bus, which stands in for the file of its name. lay: finds the depth grid that
    the mission names.
    """
    told: dict[str, Any] = {"file": source, "sha256": hashlib.sha256(data).hexdigest()}
    try:
        mission = lay(parse_planned(data, source, present))
        findings = findings_of(mission, flying(mission, present))
    except ProblemsError as error:
        problems = [problem.as_dict() for problem in error.problems]
        return {**told, "ok": False, "problems": problems, "findings": []}
    ok = not any(finding.severity == "hard" for finding in findings)
    return {**told, "ok": ok, "problems": [], "findings": [one.model_dump() for one in findings]}


def flying(mission: Mission, present: Vehicle | None) -> Vehicle | None:
    """The vehicle on the bus where it is the mission's; None: the one of the mission's name."""
    return present if present is not None and present.id == mission.vehicle else None


class Findings:
    """Findings of missions as they stand, worked out once for each text and vehicle."""

    def __init__(self, charts: Charts) -> None:
        self._charts = charts
        self._kept: OrderedDict[tuple[str, str, str], list[ForesightFinding]] = OrderedDict()
        self._lock = threading.Lock()

    def of(self, mission: Mission, present: Vehicle | None) -> list[ForesightFinding]:
        """The findings, hard ones first. Takes tens of milliseconds of Python the first time."""
        vehicle, mission = flying(mission, present), self._charts.laid(mission)
        grid = mission.depth_grid
        key = (mission.sha256, vehicle.sha256 if vehicle else "", grid.sha256 if grid is not None else "")
        with self._lock:
            if key not in self._kept:
                self._kept[key] = findings_of(mission, vehicle)
            self._kept.move_to_end(key)
            while len(self._kept) > MOST_KEPT:
                self._kept.popitem(last=False)
            return self._kept[key]
