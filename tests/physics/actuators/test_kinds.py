"""Every kind of actuator, on every shipped vehicle: derivatives, decision variables, and refusals."""

from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from bumpless.config.capacity import MAX_ACTUATORS as N
from bumpless.config.declare import parts_of, tag_of
from bumpless.config.vehicle import Actuator, VehicleError, load_vehicle, parse_vehicle, vehicle_names
from bumpless.control.allocation.curvature import residual_curvature
from bumpless.control.allocation.wrench_map import wrench_map
from bumpless.physics.actuators import (
    KINDS,
    actuator_wrench,
    add_map,
    add_missed,
    command_slope,
    curve,
    dispatch,
    fill_actuator,
    to_command,
    to_x,
    total_wrench,
)
from bumpless.physics.model import build_model
from bumpless_server.scene.actuators import DRAW, actuator_parts

NAMES = vehicle_names()
MODELS = {name: build_model(load_vehicle(name)) for name in NAMES}
DECLARED = [tag_of(kind) for kind in parts_of(Actuator)]
H = 1e-6


def draws(name: str, count: int = 200):
    """(model, x, u_previous, effectiveness, nu_r), away from the kinks where a screw reverses."""
    model, rng = MODELS[name], np.random.default_rng(3)
    for _ in range(count):
        x, nu = rng.uniform(-0.99, 0.99, N), rng.normal(0.0, [0.5, 0.2, 0.2, 0.1, 0.1, 0.1])
        x = np.where(np.abs(x) < 1e-3, 0.01, x)
        previous = rng.uniform(model["command_min"], model["command_max"])
        yield model, x, previous, rng.uniform(0.3, 1.0, N), nu


def mapped(model, x, previous, effect, nu):
    """(tau, jacobian) at x."""
    tau, J = np.zeros(6), np.zeros((6, N))
    wrench_map(model, x, previous, effect, nu, tau, J)
    return tau, J


@pytest.mark.parametrize("name", NAMES)
def test_derivative_of_the_wrench_equals_finite_differences(name: str) -> None:
    """Protects: dG/dx, in every column of every kind, those coupled through a partner's command included."""
    for model, x, *rest in draws(name):
        _, J = mapped(model, x, *rest)
        for i in range(int(model["n_u"])):
            step = H * np.eye(N)[i]
            up, down = mapped(model, x + step, *rest)[0], mapped(model, x - step, *rest)[0]
            np.testing.assert_allclose(
                (up - down) / (2 * H), J[:, i], atol=3e-4 * (1 + np.abs(J[:, i]).max())
            )
        assert not J[:, int(model["n_u"]) :].any()


@pytest.mark.parametrize("name", NAMES)
def test_curvature_equals_finite_differences(name: str) -> None:
    """Protects: the second-order term on the diagonal, between a command and the next, and nowhere else.

    Where a fin's stall begins or ends G'' jumps; one draw in fifty may meet that.
    """
    missed = total = 0
    for model, x, previous, effect, nu in draws(name):
        n, weight = int(model["n_u"]), np.random.default_rng(total).normal(size=6)
        out, coupling = np.ones(N), np.ones(N)
        residual_curvature(model, x, previous, effect, nu, weight, out, coupling)
        expected = np.zeros((n, n))
        for i in range(n):
            step = H * np.eye(N)[i]
            up, down = (
                mapped(model, x + step, previous, effect, nu)[1],
                mapped(model, x - step, previous, effect, nu)[1],
            )
            expected[i] = -(weight @ (up - down) / (2 * H))[:n]
        found = np.diag(out[:n]) + np.diag(coupling[: n - 1], 1) + np.diag(coupling[: n - 1], -1)
        missed += int(np.abs(found - expected).max() > 2e-3 * (1 + np.abs(expected).max()))
        total += 1
    assert missed <= total / 50


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("smoothing", [0.0, 0.05])
def test_decision_variables_invert_rise_and_map_bounds_exactly(name: str, smoothing: float) -> None:
    """Protects: Proposition 1: a box of commands is a box of x; to and fro is the identity."""
    model = MODELS[name].copy()
    model["smoothing"] = smoothing
    for i in range(int(model["n_u"])):
        lower, upper = to_x(model, i, model["command_min"][i]), to_x(model, i, model["command_max"][i])
        xs = np.linspace(lower, upper, 101)
        commands = np.array([to_command(model, i, x) for x in xs])
        assert (np.diff(commands) > 0.0).all()
        assert commands[[0, -1]] == pytest.approx(
            [model["command_min"][i], model["command_max"][i]], rel=1e-12
        )
        assert [to_x(model, i, c) for c in commands] == pytest.approx(xs.tolist(), abs=1e-10)
        assert to_x(model, i, 0.0) == 0.0 == to_command(model, i, 0.0)
        if smoothing > 0.0:
            for x in (-0.6, -0.02, 0.004, 0.3):
                ends = [to_command(model, i, x + side * H) / model["command_max"][i] for side in (1, -1)]
                share = (
                    np.sqrt(model["T_nn"][i] / model["T_nn_reverse"][i]) if x < 0 < model["T_nn"][i] else 1.0
                )
                assert command_slope(model, i, x) * share == pytest.approx(
                    (ends[0] - ends[1]) / (2 * H), rel=1e-3
                )


@pytest.mark.parametrize("name", NAMES)
def test_map_is_the_plants_wrench_where_the_last_command_is_the_present_one(name: str) -> None:
    """Protects: allocator and plant agree on what a kind does: G(x) = tau(u) at u = u_previous."""
    for model, x, _, effect, nu in draws(name, 50):
        n = int(model["n_u"])
        u = np.array([to_command(model, i, x[i]) for i in range(n)] + [0.0] * (N - n))
        tau = np.zeros(6)
        total_wrench(model, u, effect, nu, tau)
        np.testing.assert_allclose(mapped(model, x, u, effect, nu)[0], tau, atol=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_what_easing_misses_is_the_difference_it_makes(name: str) -> None:
    """Protects: far from zero, missed + given = asked for, along wherever the actuator pushes."""
    model, still = MODELS[name].copy(), np.zeros(6)
    model["smoothing"] = 0.05
    x, n = np.full(N, 0.8), int(model["n_u"])
    u = np.array([to_command(model, i, x[i]) for i in range(n)] + [0.0] * (N - n))
    asked = mapped(model, x, np.zeros(N), np.ones(N), still)[0]
    given, missed = np.zeros(6), np.zeros(6)
    total_wrench(model, u, np.ones(N), still, given)
    for i in range(n):
        add_missed(model, i, u, 1.0, missed)
    force = slice(0, 3)
    np.testing.assert_allclose((given + missed)[force], asked[force], atol=2e-4 * (1 + np.abs(asked).max()))


def test_every_declared_kind_has_a_module_and_is_drawn() -> None:
    """Protects: a kind that files may name is known to model and scene, by a number of its own."""
    assert set(DECLARED) == set(KINDS) == set(DRAW)
    assert all(isinstance(kind, ModuleType) for kind in KINDS.values())
    assert len({kind.KIND for kind in KINDS.values()} | {0}) == len(KINDS) + 1
    assert len({kind.GROUP for kind in KINDS.values()}) == len(KINDS)


def test_a_file_with_an_unknown_kind_is_refused() -> None:
    """Protects: the reader names the field and the kinds there are."""
    text = load_vehicle("ts100").text.replace('kind = "fin"', 'kind = "sail"', 1)
    with pytest.raises(VehicleError, match="kind = sail; must be one of " + ", ".join(DECLARED)):
        parse_vehicle(text, "sails.toml")


def test_model_and_scene_refuse_an_unknown_kind() -> None:
    """Protects: nothing takes a kind it does not know for a thruster."""
    fin, hull = load_vehicle("ts100").actuators[0], load_vehicle("ts100").hull
    sail: Any = SimpleNamespace(**vars(fin) | {"kind": "sail"}, commands=fin.commands)
    with pytest.raises(ValueError, match="delta_1: unknown kind of actuator 'sail'"):
        fill_actuator(MODELS["ts100"].copy(), 0, sail, 1000.0)
    with pytest.raises(ValueError, match="delta_1: unknown kind of actuator 'sail'"):
        actuator_parts(sail, 0, hull)


@pytest.mark.parametrize("number", [0, 99])
def test_compiled_dispatch_refuses_an_unknown_kind(number: int) -> None:
    """Protects: an unset or unknown kind is refused by every compiled function, never flown as another."""
    model, v6, v8, column = MODELS["ts100"].copy(), np.zeros(6), np.zeros(N), np.zeros((N, 6))
    model["kind"][5] = number
    calls = [
        lambda: total_wrench(model, v8, np.ones(N), v6, v6),
        lambda: actuator_wrench(model, 5, v8, v6, v6),
        lambda: to_x(model, 5, 1.0),
        lambda: to_command(model, 5, 1.0),
        lambda: add_map(model, 5, v8, v8, 1.0, v6, v6, column),
        lambda: curve(model, 5, v8, v8, 1.0, v6, v6, v8, v8),
        lambda: command_slope(model, 5, 0.1),
        lambda: add_missed(model, 5, v8, 1.0, v6),
        lambda: dispatch.wrench(model, 5, v8, v6),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="unknown kind of actuator"):
            call()
