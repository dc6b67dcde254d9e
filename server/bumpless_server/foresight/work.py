"""What a worker does with a task."""

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from bumpless.campaign.flight import Hangar
from bumpless.campaign.ready import ready
from bumpless.config.mission import missions_folder
from bumpless.config.problems import Problem, ProblemsError
from bumpless.config.vehicle import Vehicle, VehicleError, parse_vehicle
from bumpless.feasibility import station_of
from bumpless_server.foresight import fan, held
from bumpless_server.foresight.findings import findings_of, floor_below
from bumpless_server.foresight.forecast import nominal
from bumpless_server.foresight.plan import Plan, plan_of
from bumpless_server.foresight.tasks import GivenUp, Task, Told
from bumpless_server.foresight.told import ForesightFindings, ForesightProblem, ForesightProblems, HeldStation
from bumpless_server.foresight.wanted import ForesightRequest
from bumpless_server.plan.charts.store import Charts

LONGEST_S = 3600.0  # of a mission: its log must fit into memory
Answer = tuple[Told, str]  # kind and body


class TooLong(ValueError):
    """The mission may last longer than foresight can hold."""


class Work:
    """One worker's tasks. `newer()` tells whether another line waits."""

    def __init__(self, newer: Callable[[], bool], charts: Path | None = None) -> None:
        self._newer, self._hangar = newer, Hangar()
        self._charts = Charts(charts) if charts is not None else None
        self._plan: tuple[str, Plan] | None = None

    def read(self, line: bytes) -> Task:
        """The task of a line."""
        return Task.model_validate_json(line)

    def answers(self, task: Task) -> Iterator[Answer]:
        """The task's answers. Raises GivenUp between two flights when something newer waits."""
        begun = time.perf_counter()
        ready()
        if task.kind == "warm" or task.request is None:
            self._warm()
            return
        try:
            plan = self._planned(task)
        except ProblemsError as error:
            if task.kind == "nominal":
                yield "problems", _problems(task.request.id, error)
            return
        if task.kind == "findings":
            found = ForesightFindings(
                id=task.request.id,
                findings=findings_of(plan.mission, plan.vehicle),
                floor=floor_below(plan.mission, plan.vehicle),
                station=_station(plan),
            )
            yield "findings", found.model_dump_json()
            return
        if plan.mission.duration_s > LONGEST_S:
            raise TooLong(
                f"the mission may last {plan.mission.duration_s:g} s; up to {LONGEST_S:g} s can be foreseen"
            )
        if task.kind == "nominal":
            self._look()
            told = nominal(plan, task.request.id)
            told.elapsed_ms = round((time.perf_counter() - begun) * 1e3, 1)
            yield "nominal", told.model_dump_json(by_alias=True)
            return
        yield "flights", self._flights(task, plan)

    def _warm(self) -> None:
        """Go once over all that a planner asks for: what is loaded late is loaded now."""
        text = (missions_folder() / "docking.yaml").read_text(encoding="utf-8")
        plan = plan_of(ForesightRequest.model_validate({"id": 0, "text": text}))
        findings_of(plan.mission, plan.vehicle)
        nominal(plan, 0)
        list(fan.fly(fan.prepared(plan), 0, 1, self._hangar))

    def _flights(self, task: Task, plan: Plan) -> str:
        assert task.request is not None
        flown = []
        drawn = fan.prepared(plan)
        for number in range(task.first, task.first + task.count):
            self._look()
            flown += [one.model_dump_json() for one in fan.fly(drawn, number, 1, self._hangar)]
        return f"[{','.join(flown)}]"

    def _look(self) -> None:
        if self._newer():
            raise GivenUp

    def _planned(self, task: Task) -> Plan:
        """The plan of a task; the same object for the same text, so that a fan keeps its twin."""
        assert task.request is not None
        key = task.request.model_dump_json(exclude={"id", "flights"}) + task.present + task.tuned
        if self._plan is None or self._plan[0] != key:
            self._plan = key, plan_of(task.request, _present(task.present), bytes.fromhex(task.tuned))
        return self._laid(self._plan[1])

    def _laid(self, plan: Plan) -> Plan:
        """The plan over its sea floor as it is stored now."""
        mission = self._charts.laid(plan.mission) if self._charts is not None else plan.mission
        return plan if mission is plan.mission else replace(plan, mission=mission)


def _station(plan: Plan) -> HeldStation | None:
    station = station_of(plan.mission, plan.vehicle)
    return held.told(station, plan.mission.environment.current_ned_mps) if station is not None else None


@lru_cache(maxsize=4)
def _present(toml: str) -> Vehicle | None:
    try:
        return parse_vehicle(toml, "vehicle.toml") if toml else None
    except VehicleError:
        return None


def _problems(request_id: int, error: ProblemsError) -> str:
    found = [_problem(one) for one in error.problems]
    return ForesightProblems(id=request_id, problems=found).model_dump_json()


def _problem(one: Problem) -> ForesightProblem:
    told = one.as_dict()
    return ForesightProblem(message=str(one), **{k: v for k, v in told.items() if k != "file"})
