"""Depth by pitch and the drift of a rolled hull, on their own and in flight."""

from math import copysign, radians, sin
from typing import Any

import numpy as np
import pytest

from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import load_vehicle
from bumpless.control.docking.line import aim_aside
from bumpless.control.docking.record import DOCKING_STATE
from bumpless.control.docking.references import look_ahead
from bumpless.control.docking.trim import note_tilt
from bumpless.control.guidance.record import GUIDANCE_SETTINGS
from bumpless.feasibility.reach import docking_settings, plain
from bumpless.physics.model import build_model
from bumpless_paper.study.docks.response import loaded, shifted

TS100 = load_vehicle("ts100")


def drift(vehicle: str, phi: float, force: float, u_r: float) -> float:
    """The drift that is believed after half a minute of this roll, rad, and force in heave, N."""
    state: Any = np.zeros(1, DOCKING_STATE).view(np.recarray)[0]
    model: Any = np.array([build_model(load_vehicle(vehicle))]).view(np.recarray)[0]
    for _ in range(600):
        plain(note_tilt)(0.05, model, phi, force, u_r, state)
    return float(state.tilt)


@pytest.mark.parametrize(("phi", "force", "u_r"), [(2.4, 1.1, 0.0), (-2.4, 1.1, 0.0), (2.0, -0.9, 0.1)])
def test_a_rolled_hull_drifts_until_its_drag_is_the_side_force(phi: float, force: float, u_r: float) -> None:
    """Protects: the verticals of a hull that rolls push it aside, and the speed that comes of it is known."""
    model = build_model(TS100)
    v = drift("ts100", radians(phi), force, u_r)
    pushed = -force * sin(radians(phi))
    linear = model["D_linear"][1, 1] + model["D_lift"][1, 1] * u_r
    assert (linear + model["D_quadratic"][1, 1] * abs(v)) * v == pytest.approx(pushed, rel=1e-3)
    assert copysign(1.0, v) == copysign(1.0, pushed)


def test_a_level_hull_and_one_that_pushes_sideways_are_not_aimed_aside() -> None:
    """Protects: nothing is made up for where nothing drifts, or where sideways thrust holds it."""
    assert drift("ts100", 0.0, 1.1, 0.0) == 0.0
    assert drift("bluerov2_heavy", 0.05, 1.1, 0.0) == 0.0


def test_the_aim_lies_upstream_of_a_known_drift_and_passes_over_noise() -> None:
    """Protects: a little estimated current is noise, a roll is a drift to come."""
    settings = docking_settings(default_parameters(TS100).docking)
    aim = plain(aim_aside)
    assert aim(settings, 0.0, 0.002, 0.0, 1.0) == 0.0
    assert aim(settings, 0.0, 0.0, 0.005, 0.0) == pytest.approx(-0.005 * settings.aim_time)
    assert aim(settings, 0.0, 0.0, -0.005, 0.0) == pytest.approx(0.005 * settings.aim_time)
    assert aim(settings, -0.1, 0.0, 0.005, 1.0) == 0.0  # in flow a crab angle makes it good
    assert aim(settings, 0.0, 0.0, 0.005, 1.0) < aim(settings, 0.0, 0.0, 0.005, 0.3) < -0.05
    assert abs(aim(settings, 0.0, 0.05, 0.005, 1.0)) == settings.aim_most


def test_a_slow_hull_looks_less_far_ahead_in_depth() -> None:
    """Protects: what pitch does to depth takes about as long in R as at cruise."""
    guidance: Any = np.zeros(1, GUIDANCE_SETTINGS).view(np.recarray)[0]
    guidance.pitch_look_ahead, guidance.schedule_speed = 2.0, 0.7
    settings = docking_settings(default_parameters(TS100).docking)
    look = [plain(look_ahead)(settings, guidance, u) for u in (0.0, 0.35, 0.7, 1.0)]
    assert look[0] == pytest.approx(2.0 * settings.pitch_look_slow)
    assert look[0] < look[1] < look[2] == look[3] == 2.0


@pytest.mark.parametrize(("number", "load_n"), [(620, 1.0), (665, 1.0), (681, 1.0), (666, -1.0), (683, -1.0)])
def test_a_newton_more_or_less_docks_though_the_hull_rolls(number: int, load_n: float) -> None:
    """Protects: drawn vehicles that roll by 2 deg and drifted off the line while their screws pushed."""
    assert loaded(number, load_n)


@pytest.mark.parametrize("number", [600, 601, 602, 603])
def test_moved_ballast_docks(number: int) -> None:
    """Protects: 1 % of the mass moved by 5 cm ahead or astern is carried as a trim of the hull."""
    assert shifted(number)
