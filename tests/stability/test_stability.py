"""Proposition 2 on the model: the search against cases worked by hand, the linearisation against flights."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.enums import FORWARD, HOVER
from bumpless.physics.model import build_model
from bumpless.sim.twin import parameters_for
from bumpless.stability import Dwell, check_dwell, dwell_warning
from bumpless.stability.linear import coordinates, difference, read, with_memory
from bumpless.stability.lyapunov import search
from bumpless.stability.operating import settle, thruster_load

MISSIONS = Path(__file__).parents[2] / "missions"


def mission(name: str) -> Mission:
    return parse_mission((MISSIONS / f"{name}.yaml").read_text(encoding="utf-8"), f"{name}.yaml")


@pytest.fixture(scope="module")
def rov() -> Dwell:
    found = mission("rov_docking")
    return check_dwell(found, load_vehicle(found.vehicle))


def test_one_state_needs_the_dwell_worked_by_hand() -> None:
    """Protects: x shrinks by 0.9 a cycle and grows tenfold at a switch: 0.81^N 100 < 1 from N = 22 on."""
    A = {0: np.array([[0.9]]), 1: np.array([[0.9]])}
    found = search(A, {(0, 1): np.array([[10.0]]), (1, 0): np.array([[10.0]])})
    assert found is not None
    assert found.dwell == 22
    assert found.rho[0] == pytest.approx(1 - 0.9 * 0.19)


def test_a_mode_that_does_not_contract_has_no_certificate() -> None:
    """Protects: an integrator that nothing feeds back is never declared stable."""
    A = {0: np.diag([0.9, 1.0]), 1: np.diag([0.9, 0.5])}
    assert search(A, {(0, 1): np.eye(2), (1, 0): np.eye(2)}) is None


def test_the_dwell_found_keeps_every_order_of_switches_stable() -> None:
    """Protects: two stable spirals that are unstable when switched fast: V falls for the dwell found."""
    turn = 0.99 * np.array([[np.cos(0.2), -5 * np.sin(0.2)], [np.sin(0.2) / 5, np.cos(0.2)]])
    A = {0: turn, 1: np.diag([1.0, -1.0]) @ turn.T @ np.diag([1.0, -1.0])}
    jumps = {(0, 1): np.eye(2), (1, 0): np.eye(2)}
    fast = [np.linalg.matrix_power(A[0], n) @ np.linalg.matrix_power(A[1], n) for n in range(1, 16)]
    assert max(np.abs(np.linalg.eigvals(m)).max() for m in fast) > 1.0
    found = search(A, jumps)
    assert found is not None
    rng = np.random.default_rng(0)
    x = np.array([1.0, 0.3])
    for k in range(60):
        x = np.linalg.matrix_power(A[k % 2], found.dwell + int(rng.integers(0, 40))) @ x
    assert np.linalg.norm(x) < 1e-3


def test_the_operating_load_opposes_the_thrusters() -> None:
    """Protects: opposed thrusters of the ROV cancel in the plane; a torpedo's screw counts in hover only."""
    rov = thruster_load(build_model(load_vehicle("bluerov2_heavy")), HOVER)
    assert np.abs(rov[[0, 1, 3, 4, 5]]).max() < 1e-9
    assert rov[2] > 1.0
    torpedo = build_model(load_vehicle("ts100"))
    assert thruster_load(torpedo, HOVER)[0] < -0.3
    assert thruster_load(torpedo, FORWARD)[0] == 0.0


def test_the_linear_map_predicts_the_flight() -> None:
    """Protects: finite differences over one sensor period, raised to a power, give the flown response."""
    found = mission("docking_current")
    vehicle = load_vehicle(found.vehicle)
    point = settle(found, vehicle, parameters_for(vehicle, found), FORWARD)
    where = coordinates(point)
    whole = difference(point, where, point.period)
    keep = with_memory([whole])
    A = whole[np.ix_(keep, keep)]
    kept = [where[k] for k in keep]
    saved, start, ends = point.save(), read(point, kept), []
    for sign in (1.0, -1.0):
        point.restore(saved)
        point.twin.world["plant"]["eta"][4] += sign * 1e-5
        push = sign * (read(point, kept) - start)
        for _ in range(20 * point.period):
            point.step()
        ends.append(read(point, kept))
    flown = (ends[0] - ends[1]) / 2
    expected = np.linalg.matrix_power(A, 20) @ push
    assert np.linalg.norm(flown - expected) < 0.05 * np.linalg.norm(expected)


def test_the_rov_switches_stably_with_the_dwell_it_flies_with(rov: Dwell) -> None:
    """Protects: with thrust in every direction each mode contracts; the shipped dwell is proven."""
    assert max(rov.radius.values()) < 1.0
    assert rov.certificate is not None
    assert max(rov.certificate.gain.values()) < 1.0
    assert rov.ramp < rov.needed <= rov.in_use
    assert dwell_warning(rov) == ""


def test_the_warning_says_what_is_short(rov: Dwell) -> None:
    """Protects: validate names the dwell in use and the one proven enough."""
    short = replace(rov, in_use=10)
    assert not short.enough
    assert "dwell_cycles = 10 is below" in dwell_warning(short)


def test_hover_in_still_water_is_not_declared_stable() -> None:
    """Protects: without flow the fins hold no heading, and the check says so instead of a number."""
    found = mission("docking")
    found = replace(found, environment=replace(found.environment, current_ned_mps=(0.0, 0.0, 0.0)))
    still = check_dwell(found, load_vehicle(found.vehicle))
    assert still.certificate is None
    assert still.radius["H"] > 1.0 - 1e-6
    assert "does not contract" in dwell_warning(still)
    # an estimate of drift that is frozen is no mode of motion: F and R steer, and it is the place across in H
    # that nothing holds
    assert max(still.radius["F"], still.radius["R"]) < 1.0 - 1e-5
    assert "mode H" in dwell_warning(still) and "drift" not in dwell_warning(still)
