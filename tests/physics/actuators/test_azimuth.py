"""The azimuth pod: two commands that act together, from the file to allocator, envelope and scene."""

from dataclasses import replace
from functools import cache
from itertools import product

import numpy as np
import pytest
import viser
from scipy.spatial import ConvexHull

from bumpless.config.capacity import MAX_ACTUATORS as N
from bumpless.config.mission import Mission, shipped_mission
from bumpless.config.mission.model import Fault
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle, VehicleError, load_vehicle, parse_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.control.allocation.bounds import command_bounds
from bumpless.control.allocation.mdca import allocate_mdca
from bumpless.control.allocation.qp import make_handle
from bumpless.control.allocation.record import ALLOCATION_WORK, PROBLEM, SOLUTION
from bumpless.control.settings import SETTINGS
from bumpless.physics.actuators import total_wrench
from bumpless.physics.envelope import attainable_sets, sampled_sets, select
from bumpless.physics.model import build_model
from bumpless.sim.settings import fill_settings
from bumpless.sim.twin import Result, one, simulate
from bumpless.telemetry import make_context, messages
from bumpless_server.scene import mesh
from bumpless_server.scene.model import parts_of
from bumpless_server.scene.vehicle_view import VehicleView

PODS = {"port": 0, "starboard": 2}  # their first slots


@cache
def twinpod() -> Vehicle:
    return load_vehicle("twinpod")


@cache
def model() -> np.record:
    return build_model(twinpod())


@cache
def flight(allocator: str = "mdca", fault: str = "") -> Result:
    """The shipped mission; in still water for the baselines, or with half a pod's thrust lost from 18 s."""
    mission: Mission = shipped_mission("azimuth_docking")
    allocation = {"allocator": allocator, "fault_tolerant": bool(fault), "effectiveness": "estimated"}
    if allocator != "mdca":
        mission = replace(mission, environment=replace(mission.environment, current_ned_mps=(0.0, 0.0, 0.0)))
    if fault:
        mission = replace(mission, faults=(Fault(actuator=fault, at_s=18.0, effectiveness=0.5, blend_s=0.0),))
    parameters = with_overrides(default_parameters(twinpod()), {"allocation": allocation})
    return simulate(mission, twinpod(), parameters, seed=1)


def test_a_pod_takes_two_commands_with_names_units_and_bounds_of_their_own() -> None:
    """Protects: what screens, logs and weights list is the command; faults name the actuator."""
    assert [(c.name, c.actuator, c.unit, c.upper) for c in twinpod().commands[:4]] == [
        ("port_speed", "port", "rpm", 2000.0),
        ("port_angle", "port", "deg", 180.0),
        ("starboard_speed", "starboard", "rpm", 2000.0),
        ("starboard_angle", "starboard", "deg", 180.0),
    ]
    assert twinpod().slots("azimuth") == [0, 1, 2, 3]
    assert model()["part"][:6].tolist() == [0, 1, 0, 1, 0, 0]
    assert model()["command_max"][1] == pytest.approx(np.pi)


def test_thrust_points_where_the_pod_does() -> None:
    """Protects: angle 0 pushes ahead, +90 deg to starboard, reversed thrust the other way."""
    for degrees, sign in product((0.0, 30.0, 90.0, -60.0), (1.0, -1.0)):
        u, tau = np.zeros(N), np.zeros(6)
        u[0], u[1] = sign * 20.0, np.radians(degrees)
        total_wrench(model(), u, np.ones(N), np.zeros(6), tau)
        size = (model()["T_nn"] if sign > 0 else model()["T_nn_reverse"])[0] * 400.0
        np.testing.assert_allclose(tau[:2], sign * size * np.array([np.cos(u[1]), np.sin(u[1])]), atol=1e-9)
        x, y, _ = model()["position"][0]
        arm = model()["Q_nn"][0] * sign * 400.0  # of the shaft's torque, which lies in the plane
        assert tau[5] == pytest.approx(x * tau[1] - y * tau[0])
        np.testing.assert_allclose(tau[3:5], arm * np.array([np.cos(u[1]), np.sin(u[1])]), atol=1e-9)


def test_too_many_commands_and_names_taken_twice_are_refused() -> None:
    """Protects: capacity counts commands, and no two commands share a name."""
    extra = '\n[[actuators]]\nname = "{}"\ntype = "pod"\nposition_m = [0.5, 0.0, 0.3]\nhand = "right"\n'
    text = twinpod().text
    assert len(parse_vehicle(text + extra.format("keel"), "more.toml").commands) == 8
    with pytest.raises(VehicleError, match="must have 8 commands at most, they have 10"):
        parse_vehicle(text + extra.format("keel") + extra.format("skeg"), "more.toml")
    with pytest.raises(VehicleError, match="must be different"):
        parse_vehicle(text.replace('name = "bow"', 'name = "port_angle"'), "twice.toml")


@pytest.fixture(scope="module")
def answers() -> list[tuple[np.ndarray, np.ndarray]]:
    """(wanted, achieved) [X Y N] for jumps of the demand, each held for 8 s, from stopped pods on."""
    settings, p, solution, w = (one(d)[0] for d in (SETTINGS, PROBLEM, SOLUTION, ALLOCATION_WORK))
    fill_settings(settings, twinpod(), default_parameters(twinpod()))
    p["Q"], p["R"], p["lam"], p["effectiveness"] = [1, 1, 1, 0, 4, 4], 1.0, 1e-2, 1.0
    p["increment_price"], p["warm"], p["dt"] = 1.0, 1, settings["dt"]
    handle, rng, found = make_handle("osqp"), np.random.default_rng(1), []
    for wanted in [np.array([0.0, 4.0, 0.0]), *rng.uniform([-6, -3, -1.5], [6, 3, 1.5], (40, 3))]:
        p["tau_d"][[0, 1, 5]] = wanted
        for _ in range(160):
            p["u_previous"] = solution["u"]
            command_bounds(model(), p["u_previous"], p["dt"], p["u_lower"], p["u_upper"], p["du_max"])
            allocate_mdca(handle, settings["allocation"], model(), p, solution, w)
            assert (np.abs(solution["u"] - p["u_previous"]) <= p["du_max"] * (1 + 1e-9)).all()
        found.append((wanted, _wrench(solution["u"], np.zeros(6))[[0, 1, 5]]))
    return found


def test_stopped_pods_start_and_turn(answers: list[tuple[np.ndarray, np.ndarray]]) -> None:
    """Protects: at no thrust an angle has no effect and no gradient; sway is found nevertheless."""
    wanted, achieved = answers[0]
    np.testing.assert_allclose(achieved, wanted, atol=0.15)


def test_jumps_of_the_demand_are_followed(answers: list[tuple[np.ndarray, np.ndarray]]) -> None:
    """Protects: from wherever the pods point they find a way to what is wanted: none ends up in a trap."""
    for wanted, achieved in answers:
        np.testing.assert_allclose(achieved, wanted, atol=0.3)


@pytest.mark.parametrize("surge", [0.0, 0.6])
def test_attainable_set_equals_brute_force(surge: float) -> None:
    """Protects: the support function runs over both commands: against the hull of 60,000 commands of both.

    None leaves the set by more than its levels let it, 9 deg apart (1 - cos 4.5 deg), and the sizes agree.
    """
    rng, pods = np.random.default_rng(2), select(model(), kind=model()["kind"][0])
    assert pods.tolist() == [0, 2]
    nu = np.array([surge, 0, 0, 0, 0, 0.0])
    corners = rng.uniform(model()["command_min"], model()["command_max"], (60_000, N))
    edge = rng.random(corners.shape) < 0.4  # corners of the box are what random numbers never meet
    corners = np.where(edge & (np.arange(N) % 2 == 0), np.sign(corners) * model()["command_max"], corners)
    corners[:, 4:] = 0.0
    w = np.array([_wrench(u, nu) for u in corners])
    sets = attainable_sets(model(), surge, 3000, pods)
    for found, columns in ((sets.force, [0, 1]), (sets.moment, [3, 4, 5])):
        hull, brute = ConvexHull(found.vertices[:, [c % 3 for c in columns]]), ConvexHull(w[:, columns])
        width = np.ptp(w[:, columns], axis=0).max()
        assert (w[:, columns] @ hull.equations[:, :-1].T + hull.equations[:, -1]).max() < 4e-3 * width
        assert 0.9 * hull.volume < brute.volume < 1.005 * hull.volume


def _wrench(u: np.ndarray, nu: np.ndarray) -> np.ndarray:
    tau = np.zeros(6)
    total_wrench(model(), u, np.ones(N), nu, tau)
    return tau


def test_one_pod_reaches_a_disc() -> None:
    """Protects: all of the plane to full thrust, without a dent where only a reversed screw would push."""
    one = attainable_sets(model(), 0.0, 3000, [0]).force.vertices
    full = float(model()["T_nn"][0] * model()["command_max"][0] ** 2)
    assert np.hypot(one[:, 0], one[:, 1]) == pytest.approx(full, rel=2e-3)
    assert np.abs(one[:, 2]).max() == 0.0
    assert "azimuths" in sampled_sets(model(), 0.0, n_random=200)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_it_docks_in_a_cross_current_by_turning_its_pods(seed: int) -> None:
    """Protects: F, R, H, each once, and rest at the observation point, heading on the target."""
    log = (
        flight().log if seed == 1 else simulate(shipped_mission("azimuth_docking"), twinpod(), seed=seed).log
    )
    changes = log["mode"][np.flatnonzero(np.diff(log["mode"], prepend=-1))]
    assert changes.tolist() == [FORWARD, REVERSE, HOVER]
    last = log[-200:]
    assert last["range_true"].max() < 0.15  # what docked asks for
    assert np.abs(last["eta"][:, 2] - last["observation_point"][:, 2]).max() < 0.05
    assert np.abs(np.degrees(last["eta"][:, 5]) - 12.0).max() < 2.0
    assert np.abs(last["nu"][:, :3]).max() < 0.05
    assert np.abs(last["tau"][:, 1]).mean() > 0.5  # it pushes against the current
    assert np.abs(np.degrees(last["u"][:, [1, 3]])).max() > 15.0
    assert ((log["u"] >= log["u_lower"] - 1e-9) & (log["u"] <= log["u_upper"] + 1e-9)).all()
    steps = np.abs(np.diff(log["u"], axis=0))
    assert (steps <= log["du_max"][1:] * (1 + 1e-9) + 1e-12).all()


@pytest.mark.parametrize("allocator", ["wls", "pid_direct"])
def test_baselines_leave_the_pods_straight(allocator: str) -> None:
    """Protects: maps that are linear at rest know no angle; in still water they dock without one."""
    log = flight(allocator).log
    assert not log["u"][:, [1, 3]].any()
    assert log["mode"][-1] == HOVER and log["range_true"][-1] < 0.3
    assert (log["u"] >= log["u_lower"] - 1e-9).all() and (log["u"] <= log["u_upper"] + 1e-9).all()


@pytest.mark.parametrize("pod", PODS)
def test_a_weak_pod_is_found_out(pod: str) -> None:
    """Protects: the estimator sees the thrust where the pod points, and names the actuator, not its angle."""
    result, i = flight(fault=pod), PODS[pod]
    raised = np.flatnonzero(result.log["faults"])
    assert 18.0 < result.log["time"][raised[0]] < 24.0
    assert set(result.log["faults"].tolist()) == {0, 1 << i}
    assert result.log["effectiveness_hat"][-1, i] == pytest.approx(0.5, abs=0.05)
    assert [e.details["actuator"] for e in result.events if e.code == "fault_detected"] == [pod]
    assert result.log["range_true"][-1] < 0.1


def test_telemetry_tells_each_command_in_its_unit_and_the_actuators_effectiveness_with_both() -> None:
    """Protects: rpm and deg at the edge; half a pod is half in both of its rows."""
    row = flight(fault="port").log[-1]
    told = dict(messages(row, make_context(twinpod(), default_parameters(twinpod()))))
    speed, angle = told["tlm/actuators"].actuators[:2]  # type: ignore[attr-defined]
    assert (speed.name, speed.unit, angle.name, angle.unit) == ("port_speed", "rpm", "port_angle", "deg")
    assert speed.command == pytest.approx(60.0 * row["u"][0])
    assert angle.command == pytest.approx(np.degrees(row["u"][1]))
    assert speed.effectiveness == angle.effectiveness == row["effectiveness_hat"][0]
    assert speed.faulty and angle.faulty
    assert list(told["truth/state"].effectiveness) == [0.5, 0.5, 1.0, 1.0, 1.0, 1.0]  # type: ignore[attr-defined]


def test_the_drawn_pod_turns_with_its_angle_and_carries_its_screw() -> None:
    """Protects: the scene shows where a pod pushes."""
    parts = {part.name: part for part in parts_of(twinpod())}
    pod, screw = parts["port_pod"], parts["port"]
    assert (pod.command, pod.motion, screw.command, screw.motion) == (1, "turn", 0, "spin")
    assert screw.carrier == pod.name and screw.position == pod.position
    assert pod.axis is not None and screw.axis == (1.0, 0.0, 0.0)
    np.testing.assert_allclose(mesh.turn(pod.axis, np.pi / 2) @ [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], atol=1e-9)
    names = list(parts)
    assert names.index(pod.name) < names.index(screw.name)


def test_the_scene_moves_pod_and_screw_each_by_its_own_command() -> None:
    """Protects: angle in deg to the pod, speed in rpm to the screw, which hangs on the pod's node."""
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    try:
        view = VehicleView(server.scene, twinpod(), light=True)
        assert view.nodes["port"].name.endswith("/port_pod/port")
        np.testing.assert_allclose(view.nodes["port"].position, 0.0)
        for time_ns in (1_000_000_000, 1_050_000_000):
            said = [pb.Actuator(feedback=feedback) for feedback in (600.0, 40.0, 0.0, -30.0, 0.0, 0.0)]
            view.move_actuators(pb.Actuators(stamp=pb.Stamp(time_ns=time_ns), actuators=said))
        assert view.angle("port_pod") == pytest.approx(np.radians(40.0))
        assert view.angle("starboard_pod") == pytest.approx(np.radians(-30.0))
        assert view.angle("port") > 0.0 == view.angle("starboard")
    finally:
        server.stop()
