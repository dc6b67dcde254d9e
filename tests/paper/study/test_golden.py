"""Every scenario against its golden summary, and Proposition 1 on all of them.

`BUMPLESS_REFRESH_GOLDEN=1 pytest tests/paper/study/test_golden.py` writes them anew: do so only when a flight
was meant to change, and say in the commit why.
"""

from collections.abc import Callable

import pytest

from bumpless.sim.twin import Result
from bumpless_paper.study.figures import figures_of
from bumpless_paper.study.golden import summary_of
from bumpless_paper.study.scenarios import SCENARIOS, VARIANTS
from tests.paper.study.golden_file import hold_against

ALL = [*SCENARIOS, *VARIANTS]

Flight = Callable[[str], Result]


@pytest.mark.parametrize("name", ALL)
def test_scenario_flies_as_it_did(name: str, flight: Flight) -> None:
    """Protects: a change in plant, autopilot or allocator that moves a published scenario is seen."""
    got = summary_of(flight(name))
    wanted = hold_against(name.lower(), got)
    for figure, value in wanted["figures"].items():
        expected = None if value is None else pytest.approx(value, rel=5e-3, abs=1e-5)
        assert got["figures"][figure] == expected, figure


@pytest.mark.parametrize("name", ALL)
def test_proposition_1_increments(name: str, flight: Flight) -> None:
    """Protects: no allocator, however it switches, leaves its amplitude or increment bounds in any cycle."""
    assert figures_of(flight(name))["increment_violations"] == 0


@pytest.mark.parametrize("name", ["S4", "S5", "S6", "S7"])
def test_proposition_1_demand_is_continuous(name: str, flight: Flight) -> None:
    """Protects: with the ramp on, tau_d never steps further than one cycle of the ramp allows."""
    assert figures_of(flight(name))["demand_step_violations"] == 0


@pytest.mark.parametrize("name", ["S1", "S2", "S3"])
def test_hard_switches_break_continuity(name: str, flight: Flight) -> None:
    """Protects: the baselines do switch hard, once at each of their switches and nowhere else."""
    figures = figures_of(flight(name))
    assert figures["demand_step_violations"] == figures["switches"] == 2
