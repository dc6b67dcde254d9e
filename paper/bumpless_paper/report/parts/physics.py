"""Cross-checks of the plant that need no trust in us: laws of physics and other people's code."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.vehicle import load_vehicle, vehicle_names
from bumpless.physics.actuators import total_wrench
from bumpless.physics.dynamics import coriolis_force, damping_force
from bumpless.physics.faults import FAULTS
from bumpless.physics.frames import body_to_ned
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.physics.water import ENVIRONMENT
from bumpless_paper.report.content import Figure, Grid, Panel, Part, Series
from bumpless_paper.report.parts import Progress

Array = NDArray[np.float64]
_HEALTHY = np.ones(MAX_ACTUATORS)
_QUIET = np.zeros(N_NOISE)
_CALM, _WHOLE = np.zeros(1, ENVIRONMENT)[0], np.zeros(1, FAULTS)[0]  # water at rest, nothing broken


def fly(
    model: np.record, nu: Array, command: Array, seconds: float, dt: float, substeps: int = 1
) -> np.ndarray:
    """PLANT record after `seconds` from velocity nu (6,) at 20 m depth, commands held, no current."""
    plant = np.zeros(1, PLANT)
    plant[0]["nu"], plant[0]["effectiveness"] = nu, 1.0
    plant[0]["eta"][2] = 20.0
    for _ in range(round(seconds / dt)):
        step_plant(model, _CALM, _WHOLE, plant[0], command, dt, substeps, _QUIET)
    return plant[0]


def energy(model: np.record, plant: np.ndarray) -> float:
    """Kinetic energy with added mass, and the potential energy of weight and buoyancy, J."""
    total = 0.5 * plant["nu"] @ (model["M_RB"] + model["M_A"]) @ plant["nu"]
    down = np.zeros(3)
    for r, weight in ((model["r_g"], model["weight"]), (model["r_b"], -model["buoyancy"])):
        body_to_ned(*plant["eta"][3:], np.array(r), down)
        total -= weight * (down[2] + plant["eta"][2])
    return float(total)


def _without_losses(model: np.record) -> np.record:
    ideal = model.copy()
    for name in ("D_linear", "D_quadratic", "D_lift", "fin_area", "T_nv", "Q_nv"):
        ideal[name] = 0.0
    return ideal


def steady_speed(model: np.record) -> float:
    """Relative gap between the simulated top speed and the root of thrust minus drag."""
    from scipy.optimize import brentq

    n = int(model["n_u"])
    ahead = (model["T_nn"] > 0.0) & (model["direction"][:, 0] > 0.5)  # screws; pods at the angle 0
    u = np.zeros(MAX_ACTUATORS)
    u[:n] = np.where(ahead[:n], 0.6 * model["command_max"][:n], 0.0)
    calm = model.copy()
    calm["M_inv"] = 0.0  # on a rail: surge alone moves
    calm["M_inv"][0, 0] = 1.0 / (model["M_RB"] + model["M_A"])[0, 0]

    def surplus(speed: float) -> float:
        nu, tau = np.array([speed, 0, 0, 0, 0, 0.0]), np.zeros(6)
        total_wrench(calm, u, _HEALTHY, nu, tau)
        damping_force(calm, nu, tau)
        return float(tau[0])

    expected = float(brentq(surplus, 1e-3, 10.0))  # pyright: ignore[reportArgumentType]
    return abs(float(fly(calm, np.zeros(6), u, 200.0, 0.05)["nu"][0]) / expected - 1.0)


def mirrored_turns(model: np.record) -> float:
    """Largest difference of a turn to starboard and the mirrored turn to port, m and rad."""
    even = model.copy()
    even["Q_nn"] = even["Q_nv"] = 0.0
    mirror = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
    start = np.array([0.6, 0.05, 0.0, 0.05, 0.0, 0.1])
    u = np.zeros(MAX_ACTUATORS)
    one, other = (fly(even, s, u, 20.0, 0.05)["eta"] for s in (start, start * mirror))
    return float(np.abs(one * mirror - other).max())


def energy_drift(model: np.record) -> float:
    """Relative change of energy over 20 s without damping, fins and screws."""
    ideal = _without_losses(model)
    nu = np.array([0.6, 0.2, -0.1, 0.2, 0.15, -0.1])
    begin, end = (energy(ideal, fly(ideal, nu, np.zeros(8), s, 0.02, 5)) for s in (0.0, 20.0))
    scale = 0.5 * nu @ (model["M_RB"] + model["M_A"]) @ nu
    return abs(end - begin) / float(scale)


def decay_balance(model: np.record) -> float:
    """Free decay: energy lost against the work of damping integrated along the way, relative."""
    freely = model.copy()
    freely["fin_area"] = freely["T_nv"] = freely["Q_nv"] = 0.0
    plant = np.zeros(1, PLANT)
    plant[0]["nu"], plant[0]["effectiveness"] = [0.8, 0.1, 0.1, 0.1, 0.1, 0.1], 1.0
    begin, dt, powers = energy(freely, plant[0]), 0.002, []
    for k in range(4001):
        drag = np.zeros(6)
        damping_force(freely, plant[0]["nu"], drag)
        powers.append(float(drag @ plant[0]["nu"]))
        if k < 4000:
            step_plant(freely, _CALM, _WHOLE, plant[0], np.zeros(8), dt, 1, _QUIET)
    done = float(np.trapezoid(powers, dx=dt))
    return abs((energy(freely, plant[0]) - begin) / done - 1.0)


def coriolis_work(model: np.record) -> float:
    """Largest |nu' C(nu) nu| over random velocities."""
    draws = np.random.default_rng(0).uniform(-1.5, 1.5, (200, 6))
    worst = 0.0
    for nu in draws:
        force = np.zeros(6)
        coriolis_force(model["M_RB"], nu, force)
        coriolis_force(model["M_A"], nu, force)
        worst = max(worst, abs(float(force @ nu)))
    return worst


def rotation_gap(_: np.record) -> float:
    """Largest difference of our rotation and SciPy's over random attitudes."""
    from scipy.spatial.transform import Rotation

    draws, worst = np.random.default_rng(0).uniform(-1.4, 1.4, (200, 6)), 0.0
    for row in draws:
        out = np.zeros(3)
        body_to_ned(row[0], row[1], row[2], row[3:].copy(), out)
        worst = max(worst, float(np.abs(Rotation.from_euler("ZYX", row[2::-1]).apply(row[3:]) - out).max()))
    return worst


def step_errors(model: np.record) -> tuple[Array, Array]:
    """(steps, errors): a smooth 4 s manoeuvre with larger and larger Runge-Kutta steps, s and mixed units."""
    nu = np.array([0.5, 0.02, 0.01, 0.05, 0.02, -0.03])

    def end(substeps: int) -> Array:
        plant = fly(model, nu, np.zeros(8), 4.0, 0.4, substeps)
        return np.concatenate([plant["eta"], plant["nu"]])

    exact, counts = end(256), np.array([2, 4, 8, 16, 32])
    return 0.4 / counts, np.array([np.abs(end(int(n)) - exact).max() for n in counts])


CHECKS: tuple[tuple[str, str, Callable[[np.record], float], float], ...] = (
    (
        "top speed",
        "on a rail, against the root of thrust − drag by Brent's method; relative",
        steady_speed,
        1e-6,
    ),
    ("mirrored turns", "free turns to starboard and port; m and rad", mirrored_turns, 1e-9),
    ("energy kept", "20 s without damping; relative", energy_drift, 1e-7),
    ("energy balance", "free decay: energy lost against the drag's work; relative", decay_balance, 1e-4),
    ("Coriolis does no work", "200 random velocities; W", coriolis_work, 1e-9),
    ("rotation", "against SciPy's Rotation, 200 random attitudes; m", rotation_gap, 1e-12),
)


def part(progress: Progress) -> Part:
    """Every check on every shipped vehicle."""
    rows, figures, names = [], [], vehicle_names()
    orders, curves = {}, []
    total, done = len(names) * (len(CHECKS) + 1), 0
    for k, name in enumerate(names):
        model = build_model(load_vehicle(name))
        for title, how, check, limit in CHECKS:
            value = check(model)
            rows.append([name, title, how, value, limit, "passed" if value <= limit else "failed"])
            done += 1
            progress(done / total)
        steps, errors = step_errors(model)
        use = errors > 1e-12
        orders[name] = float(np.polyfit(np.log(steps[use][-4:]), np.log(errors[use][-4:]), 1)[0])
        passed = "passed" if orders[name] > 3.5 else "failed"
        how = "slope of error over step, classical Runge-Kutta is of order 4"
        rows.append([name, "order of the integrator", how, orders[name], 3.5, passed])
        curves.append(Series(name, steps, np.maximum(errors, 1e-16), k))
        done += 1
        progress(done / total)
    figures.append(
        Figure(
            "integrator_order",
            "Step-size convergence",
            "Error of a 4 s manoeuvre over the step; the control cycle uses 0.025 s.",
            [Panel("step (s)", "largest error", curves, log_x=True, log_y=True)],
        )
    )
    failed = [row[:2] for row in rows if row[-1] == "failed"]
    return Part(
        "physics",
        "Cross-checks",
        f"Laws that hold whatever the parameters are, and comparisons with independent code: "
        f"{len(rows) - len(failed)} of {len(rows)} pass.",
        [
            Grid(
                "cross_checks",
                "Plant",
                "Each on every shipped vehicle; the order must exceed its limit, the others stay below.",
                ["vehicle", "check", "how", "value", "limit", ""],
                rows,
            )
        ],
        figures,
        numbers={"passed": len(rows) - len(failed), "checks": len(rows), "failed": failed, "order": orders},
        hashes={f"vehicle {name}": load_vehicle(name).sha256 for name in names},
    )
