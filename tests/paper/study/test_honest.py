"""The table of allocator and ramp: fair, judged by the mission, with honest intervals."""

import numpy as np
import pytest

from bumpless.config.parameters import as_dict
from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.physics.actuators import FIN
from bumpless.physics.model import build_model
from bumpless.sim.twin import Twin
from bumpless_paper.study.fly import Job, parameters_for
from bumpless_paper.study.honest import judge, judged, summed
from bumpless_paper.study.plants import DISTRIBUTION, WIDE, draw
from bumpless_paper.study.scenarios import HONEST, SCENARIOS, mission_of


def test_rows_differ_in_allocator_and_switching_only() -> None:
    """Protects: a fair table. Each allocator is there hard and with the ramp, on the same gains."""
    trees = {name: as_dict(parameters_for(Job(name))) for name in HONEST}
    for section, keys in trees["S4"].items():
        for key, value in keys.items():
            if section != "bumpless" and (section, key) not in (
                ("allocation", "allocator"),
                ("allocation", "direct_map"),
            ):
                assert all(tree[section][key] == value for tree in trees.values()), f"{section}.{key}"
    table = {(t["allocation"]["allocator"], t["bumpless"]["ramp"]) for t in trees.values()}
    assert table == {(name, ramp) for name in ("pid_direct", "wls", "mdca") for ramp in (False, True)}
    direct = [t["allocation"] for t in trees.values() if t["allocation"]["allocator"] == "pid_direct"]
    assert {allocation["direct_map"] for allocation in direct} == {"thrust_in_flow"}


def test_knowing_its_inflow_makes_s1_deliver_what_is_asked() -> None:
    """Protects: the baseline. At cruise the screw's inflow takes most of what S1's residual was."""
    without, knowing = (judged(Job(name))["e_tau_true"] for name in ("S1", "S1-flow"))
    assert knowing < 0.5 * without


def test_the_wider_plants_are_the_published_ones_and_more() -> None:
    """Protects: published goals stay comparable; what both distributions name is drawn alike."""
    for number in (0, 7, 203):
        narrow, wide = draw(number), draw(number, WIDE)
        assert all(getattr(narrow, name) == getattr(wide, name) for name in DISTRIBUTION)
        assert all(
            getattr(narrow, name) == getattr(draw(1), name) for name in WIDE.keys() - DISTRIBUTION.keys()
        )
    plants = [draw(i, WIDE) for i in range(200)]
    for name, spread in WIDE.items():
        values = np.array([getattr(p, name) for p in plants])
        assert spread.low <= values.min() and values.max() <= spread.high
        assert 0.4 < np.mean(values < spread.at(0.5)) < 0.6, name


def test_the_autopilot_is_told_nothing_of_a_wider_plant() -> None:
    """Protects: the allocator's map stays nominal while fins, screws and sensors are others."""
    vehicle, plant = load_vehicle("ts100"), draw(5, WIDE)
    twin, nominal = Twin(vehicle), build_model(vehicle)
    twin.start(mission_of(SCENARIOS["S4"]), 1, alter=plant)
    fin = nominal["kind"] == FIN
    for name in ("C_La", "command_rate", "T_nn"):
        assert np.array_equal(twin.onboard["model"][name], nominal[name])
    assert twin.world["model"]["C_La"][fin] == pytest.approx(nominal["C_La"][fin] * plant.fin_lift)
    assert twin.world["model"]["command_rate"][fin] == pytest.approx(
        nominal["command_rate"][fin] * plant.fin_slew
    )
    errors, own = twin.world["truth"]["errors"], Twin(vehicle)
    own.start(mission_of(SCENARIOS["S4"]), 1)
    drawn = own.world["truth"]["errors"]
    added = (errors["heading_bias"] - drawn["heading_bias"]) * plant.noise
    assert added == pytest.approx(plant.heading_bias)


def test_a_row_counts_every_ending_once_and_what_is_missing_as_not_gentle() -> None:
    """Protects: shares add up to one; a flight that never switched has not switched gently."""
    row = summed(
        [
            {"outcome": float(pb.ENDING_DOCKED), "settling_FR": 0.01, "settling_RH": 0.06, "energy_j": 1.0},
            {"outcome": float(pb.ENDING_COLLIDED), "settling_FR": np.nan, "settling_RH": np.nan},
        ]
    )
    assert (
        sum(row[name.removeprefix("ENDING_").lower()] for name in pb.Ending.keys() if "UNSP" not in name) == 1
    )
    assert (row["docked"], row["collided"], row["gentle_FR"], row["gentle_RH"]) == (0.5, 0.5, 0.5, 0.0)
    assert row["median"]["energy_j"] == 1.0


def test_the_same_plants_give_the_same_row() -> None:
    """Protects: the figures are of the plants' numbers, not of the day."""
    one, other = (judge(2, workers=1, names=("S4",)) for _ in range(2))
    assert one == other
    assert one["rows"]["S4"]["title"] == HONEST["S4"].title
