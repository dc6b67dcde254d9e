"""Flow at screws and fins: four quadrants, deduction, wash, cross-flow and dead-band, by closed form."""

from math import exp, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.mission import parse_mission
from bumpless.config.vehicle import VehicleError, load_vehicle, parse_vehicle
from bumpless.physics.actuators import lag_rate, total_wrench
from bumpless.physics.actuators.screw_flow import driven, wash
from bumpless.physics.actuators.thruster import thrust_and_torque
from bumpless.physics.model import build_model, fill_flow
from bumpless.sim.twin import Twin
from tests.flights import MISSIONS

TS100 = load_vehicle("ts100")
SCREW, VERTICAL, FIN = 4, 5, 0
RHO, D, W = 1000.0, 0.18, 0.3


def in_flow() -> np.record:
    model = build_model(TS100)
    fill_flow(model, TS100)
    return model


MODEL = in_flow()
DISC = pi * D * D / 4.0
ZERO_THRUST = float(MODEL["T_nn"][SCREW] / MODEL["T_nv"][SCREW])  # V_0 over n, m


def nu(u=0.0, v=0.0, w=0.0) -> np.ndarray:
    return np.array([u, v, w, 0.0, 0.0, 0.0])


def wrench_of(slot: int, command: float, velocity: np.ndarray, model=MODEL) -> np.ndarray:
    """Of one actuator alone, but for the drag of the others at rest."""
    share, u, tau = np.zeros(8), np.zeros(8), np.zeros(6)
    share[slot], u[slot] = 1.0, command
    total_wrench(model, u, share, velocity, tau)
    return tau


@pytest.mark.parametrize("V", [0.7, -0.4])
def test_stopped_screw_drags_as_a_plate(V: float):
    """Protects: a stopped screw is no hole in the water: C rho/2 A ((1 - w) V)^2 against the flow."""
    T, Q = driven(MODEL, SCREW, 0.0, V)
    drag = 0.4 * 0.5 * RHO * DISC * ((1.0 - W) * V) ** 2
    assert pytest.approx(-np.sign(V) * drag) == T
    assert abs(Q) == pytest.approx(0.05 / 0.4 * drag * D)
    assert wrench_of(SCREW, 0.0, nu(V))[0] == pytest.approx(T)


@given(st.floats(0.05, 3.4), st.floats(0.0, 1.0))
def test_driving_screw_is_the_published_one(n: float, share: float):
    """Protects: where the screw drives, up to no thrust, nothing but the deduction is new."""
    V = share * ZERO_THRUST * n
    assert driven(MODEL, SCREW, n, V)[0] == pytest.approx(thrust_and_torque(MODEL, SCREW, n, V)[0], abs=1e-12)
    assert driven(MODEL, SCREW, -n, -V) == pytest.approx([-x for x in driven(MODEL, SCREW, n, V)])


@given(st.floats(0.0, 2.0 * pi))
def test_thrust_has_no_jump_between_quadrants(beta: float):
    """Protects: through zero speed, zero flow and zero thrust the force goes without a step, and from zero
    thrust on without a corner."""

    def at(angle: float) -> float:
        return driven(MODEL, SCREW, 3.0 * np.cos(angle), 0.7 * np.sin(angle))[0]

    assert abs(at(beta + 1e-6) - at(beta - 1e-6)) < 1e-4
    n, h = 1.5, 1e-5
    V = ZERO_THRUST * n
    before = (driven(MODEL, SCREW, n, V)[0] - driven(MODEL, SCREW, n, V - h)[0]) / h
    after = (driven(MODEL, SCREW, n, V + h)[0] - driven(MODEL, SCREW, n, V)[0]) / h
    assert after == pytest.approx(before, rel=1e-3)


def test_thrust_rises_with_shaft_speed_from_stopped_to_driving():
    """Protects: windmilling lies between the stopped screw's drag and zero thrust."""
    speeds = np.linspace(0.0, 3.4, 60)
    thrust = [driven(MODEL, SCREW, float(n), 0.7)[0] for n in speeds]
    assert np.all(np.diff(thrust) > 0.0)


@given(st.floats(0.0, 1.0), st.floats(0.1, 2.0))
def test_driven_screw_gives_no_more_power_than_the_flow_loses(share: float, V: float):
    """Protects: a windmill makes no energy: shaft power taken out is at most drag times flow."""
    n = share * V / ZERO_THRUST
    T, Q = driven(MODEL, SCREW, n, V)
    shaft = 2.0 * pi * n * Q * np.sign(MODEL["Q_nn"][SCREW])  # what the motor gives; negative: taken out
    assert -shaft <= -T * (1.0 - W) * V + 1e-12


def test_crash_back_is_bollard_and_drag():
    """Protects: against the flow the line of the driving screw is not extrapolated, to 149 % of bollard."""
    bollard = driven(MODEL, SCREW, -200.0 / 60.0, 0.0)[0]
    T = driven(MODEL, SCREW, -200.0 / 60.0, 0.7)[0]
    assert pytest.approx(bollard + driven(MODEL, SCREW, 0.0, 0.7)[0]) == T
    assert bollard == pytest.approx(-4.56, abs=0.01) and 1.2 < T / bollard < 1.3


def test_hull_loses_the_deduction():
    """Protects: 10 % of the thrust ahead and 15 % astern, none of a drag."""
    for n, left in ((3.0, 0.90), (-3.0, 0.85)):
        assert wrench_of(SCREW, n, nu())[0] == pytest.approx(left * driven(MODEL, SCREW, n, 0.0)[0])


def test_a_vertical_loses_half_of_its_thrust_at_cruise():
    """Protects: exp(-c U^2) of the flow across, and none of the flow along."""
    still = wrench_of(VERTICAL, 3.0, nu())[2]
    assert wrench_of(VERTICAL, 3.0, nu(0.7))[2] == pytest.approx(exp(-1.4 * 0.49) * still)
    assert wrench_of(VERTICAL, 3.0, nu(0.7))[2] == pytest.approx(0.5 * still, rel=0.02)
    along = wrench_of(VERTICAL, 3.0, nu(w=0.2))[2]
    assert along == pytest.approx(thrust_and_torque(MODEL, VERTICAL, 3.0, 0.2)[0])


@pytest.mark.parametrize("n", [2.0, -2.0])
def test_wash_is_the_momentum_theorys(n: float):
    """Protects: suction ahead of the screw, jet behind: both ways, with the sense of the water."""
    T = abs(driven(MODEL, SCREW, n, 0.0)[0])
    w = sqrt(T / (2.0 * RHO * DISC))
    s = (
        0.087 if n < 0.0 else -0.087
    )  # fins are 0.087 m ahead of the disc: in the jet astern, the suction ahead
    expected = np.sign(n) * w * (1.0 + s / sqrt(s * s + (D / 2.0) ** 2))
    assert wash(MODEL, FIN, SCREW, n, nu()) == pytest.approx(expected, rel=1e-6)
    far = MODEL.copy()
    far["position"][FIN, 0] = MODEL["position"][SCREW, 0] + 50.0
    assert abs(wash(far, FIN, SCREW, n, nu())) == pytest.approx(2.0 * w if n < 0.0 else 0.0, abs=1e-4)


@given(st.floats(0.3, 3.3), st.floats(0.0, 0.6))
def test_wash_gives_the_jet_the_momentum_of_the_thrust(n: float, V: float):
    """Protects: T = rho A (V_A + w) 2 w in any flow ahead."""
    T = driven(MODEL, SCREW, n, V)[0]
    jet = MODEL.copy()
    jet["position"][FIN, 0] = MODEL["position"][SCREW, 0] - 1e4  # far behind: 2 w
    w = 0.5 * wash(jet, FIN, SCREW, n, nu(V))
    if T > 0.0:
        assert RHO * DISC * ((1.0 - W) * V + w) * 2.0 * w == pytest.approx(T, rel=1e-5)
    else:
        assert w == 0.0


def test_fins_at_rest_steer_with_the_screw_running():
    """Protects: with wash a deflected fin has force in still water, with the sign of the stream."""

    def lift(n: float) -> float:
        u, tau = np.zeros(8), np.zeros(6)
        u[FIN], u[SCREW] = 0.2, n
        share = np.zeros(8)
        share[FIN] = 1.0
        total_wrench(MODEL, u, share, nu(), tau)
        return float(tau[3])

    assert lift(0.0) == 0.0
    assert lift(3.0) != 0.0 and np.sign(lift(3.0)) == -np.sign(lift(-3.0))
    assert abs(lift(-3.0)) > abs(lift(3.0))  # the jet is faster than the suction


def test_dead_band_and_least_speed():
    """Protects: small commands turn nothing, larger ones at least as fast as the motor can turn slowly."""
    for rpm, turns in ((3.0, 0.0), (-3.9, 0.0), (5.0, 8.0), (-5.0, -8.0), (30.0, 30.0)):
        state = turns / 60.0
        assert lag_rate(MODEL, SCREW, rpm / 60.0, state) == pytest.approx(0.0, abs=1e-12)
    assert lag_rate(build_model(TS100), SCREW, 0.05, 0.0) > 0.0


def test_only_the_true_vehicle_of_a_mission_that_says_so_has_it():
    """Protects: the paper's plants and the autopilot's map stay the published ones."""
    twin, text = Twin(TS100), (MISSIONS / "docking.yaml").read_text()
    for switch, flow in (("false", 0), ("true", 1)):
        twin.start(parse_mission(f"{text}\nactuator_flow: {switch}\n", "x", TS100))
        assert twin.onboard["model"]["flow"] == 0 and twin.world["model"]["flow"] == flow
    paper = parse_mission((MISSIONS / "s4_mdca_bumpless.yaml").read_text(), "x", TS100)
    twin.start(paper)
    assert twin.world["model"]["flow"] == 0 and not paper.actuator_flow


def test_wash_names_a_screw():
    """Protects: a stream from nowhere is refused with its place."""
    with pytest.raises(VehicleError) as error:
        parse_vehicle(TS100.text.replace('screw = "n_p"', 'screw = "n_q"'), "x.toml")
    assert {problem.field for problem in error.value.problems} == {
        f"actuators[{i}].wash.screw" for i in range(4)
    }
