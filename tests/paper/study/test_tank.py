"""The tank study: one mission, one set of gains, golden flights, and a steadier hover with allocation."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import as_dict
from bumpless.config.vehicle import load_vehicle
from bumpless.sim.twin import Result, parameters_for, simulate
from bumpless_paper.study.figures import figures_of
from bumpless_paper.study.golden import summary_of
from bumpless_paper.study.tank import GOALS, MISSIONS, hover_row
from bumpless_paper.study.tank_alternatives import ALTERNATIVES, AS_FLOWN, changes, hover_figures
from tests.paper.study.golden_file import hold_against

FOLDER = Path(__file__).parents[3] / "missions"
VEHICLE = load_vehicle("ts100")
SEEDS = (1, 2, 3)

Flights = Callable[[str, int], Result]


def mission(label: str) -> Mission:
    path = FOLDER / f"{MISSIONS[label]}.yaml"
    return parse_mission(path.read_text(encoding="utf-8"), path.name)


@pytest.fixture(scope="module")
def flown() -> Flights:
    @cache
    def once(label: str, seed: int) -> Result:
        return simulate(mission(label), VEHICLE, seed=seed)

    return once


def test_scenarios_share_mission_plant_and_gains() -> None:
    """Protects: the baseline is honest; only allocator, switching and S1's coasting without surge differ."""
    one, *others = (mission(label) for label in MISSIONS)
    for other in others:
        for part in ("duration_s", "start", "legs", "target", "environment", "sensors", "faults", "end"):
            assert getattr(other, part) == getattr(one, part), part
    base, *trees = (as_dict(parameters_for(VEHICLE, mission(label))) for label in MISSIONS)
    coasting = base["reverse"].pop("demand_limit")
    for tree in trees:
        limit = tree["reverse"].pop("demand_limit")
        assert coasting[0] == 0.0 and tuple(coasting[1:]) == tuple(limit[1:])
        assert {k for k in base if base[k] != tree[k]} <= {"allocation", "bumpless"}
        changed = {k for k in base["allocation"] if base["allocation"][k] != tree["allocation"][k]}
        assert changed == {"allocator"}
        assert not tree["allocation"]["fault_tolerant"]


@pytest.mark.parametrize("label", MISSIONS)
def test_tank_flies_as_it_did(label: str, flown: Flights) -> None:
    """Protects: a change in plant, autopilot or allocator that moves a tank flight is seen."""
    run = flown(label, 1)
    got = summary_of(run)
    got["hover"] = [float(f"{value:.6g}") for value in hover_row(run)]
    wanted = hold_against(MISSIONS[label], got)
    assert got["hover"] == pytest.approx(wanted["hover"], rel=5e-3, abs=1e-4)


@pytest.mark.parametrize("label", MISSIONS)
def test_tank_stays_in_its_bounds_and_reaches_hover_once(label: str, flown: Flights) -> None:
    """Protects: Proposition 1 with noise, dropouts and worn actuators; no chatter between modes."""
    for seed in SEEDS:
        figures = figures_of(flown(label, seed))
        assert figures["increment_violations"] == 0
        assert figures["switches"] == 2
        assert figures["demand_step_violations"] == (0 if label == "S3" else 2)


@pytest.mark.parametrize("goal", GOALS)
def test_hover_is_steadier_with_allocation(goal: str, flown: Flights) -> None:
    """Protects: the goals of the tank study, each by a tenth of S1's figure at least, on three seeds."""
    k = GOALS[goal]
    none, bumpless = (np.mean([hover_row(flown(label, s))[k] for s in SEEDS]) for label in ("S1", "S3"))
    assert bumpless < 0.9 * none


def test_an_alternative_changes_what_it_says_and_nothing_else() -> None:
    """Protects: the table of choices made otherwise; without a change it is the study itself."""
    missions = {label: mission(label) for label in ("S1", "S3")}
    same = hover_figures(AS_FLOWN, missions, VEHICLE, (1,))
    rows = {label: hover_row(simulate(m, VEHICLE, seed=1)) for label, m in missions.items()}
    for label, row in rows.items():
        assert same[label][0, :-1] == pytest.approx([row[k] for k in GOALS.values()])
    assert changes(same)["depth_rms_m"]["S3"] == pytest.approx(rows["S3"][0] / rows["S1"][0] - 1.0)
    told = next(a for a in ALTERNATIVES if a.allocators)
    other = hover_figures(told, missions, VEHICLE, (1,))
    assert other["S1"] == pytest.approx(same["S1"])
    assert other["S3"] != pytest.approx(same["S3"])
