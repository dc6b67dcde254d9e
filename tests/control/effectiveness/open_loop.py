"""The true plant and its sensors under commands of the test's own choice, watched by the estimator alone."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import load_vehicle
from bumpless.control.effectiveness.step import believe_faults, estimate_effectiveness
from bumpless.control.navigation import navigate
from bumpless.control.onboard import ONBOARD
from bumpless.control.reset import reset_state
from bumpless.physics.model import build_model
from bumpless.physics.plant import step_plant
from bumpless.physics.sensors import N_NOISE, measure
from bumpless.sim.settings import fill_settings, plan_of, sensors_of
from bumpless.sim.truth import tell, truth_of
from bumpless.sim.twin import one
from bumpless.sim.world import WORLD, place_plant
from bumpless_paper.study.scenarios import SCENARIOS, mission_of

OVERRIDES = {"allocation": {"fault_tolerant": True, "effectiveness": "estimated"}}


@dataclass
class Watched:
    """What the estimator said in each cycle: time s, faults as bits, its estimate, what is believed."""

    time: list[float] = field(default_factory=list)
    faults: list[int] = field(default_factory=list)
    said: list[np.ndarray] = field(default_factory=list)
    heard: list[np.ndarray] = field(default_factory=list)

    def first_alarm(self, bit: int) -> float:
        """Time of the first cycle in which actuator `bit` counts as faulty; infinite if never."""
        return next((t for t, f in zip(self.time, self.faults, strict=True) if f >> bit & 1), np.inf)


def watch(
    commands: Callable[[float], Sequence[float]],
    seconds: float,
    faults: Sequence[tuple[int, float, float]] = (),
    spoil: Callable[[float, np.void], None] | None = None,
    seed: int = 1,
    noise_scale: float = 1.0,
) -> Watched:
    """Fly ts100 open loop. commands(t): rad and rev/s; faults: (actuator, time s, effectiveness), at once.

    spoil(t, measurement): may change what the sensors say.
    """
    vehicle = load_vehicle("ts100")
    parameters = with_overrides(default_parameters(vehicle), OVERRIDES)
    mission = mission_of(SCENARIOS["S4"])
    onboard, world = one(ONBOARD)[0], one(WORLD)[0]
    settings, s, truth, plant = onboard["settings"], onboard["state"], world["truth"], world["plant"]
    fill_settings(settings, vehicle, parameters)
    onboard["model"] = world["model"] = build_model(vehicle)
    world["truth"] = truth_of(mission, vehicle)[0]
    onboard["plan"] = plan_of(mission, vehicle)[0]
    onboard["sensors"] = world["sensors"] = sensors_of(vehicle, mission)[0]
    truth["faults"]["n"], truth["errors"]["noise_scale"] = len(faults), noise_scale
    for f, (actuator, at, effectiveness) in enumerate(faults):
        truth["faults"]["actuator"][f], truth["faults"]["time"][f] = actuator, at
        truth["faults"]["effectiveness"][f] = effectiveness
    tell(truth, onboard["plan"], faults=False)
    rng, out = np.random.Generator(np.random.PCG64(seed)), Watched()
    place_plant(truth, world["sensors"], plant, rng)
    reset_state(settings, onboard["plan"], s)
    u, dt, m, estimator = (
        np.zeros(MAX_ACTUATORS),
        vehicle.control_period_s,
        world["measurement"],
        s["estimator"],
    )
    for k in range(round(seconds / dt)):
        noise, t = rng.standard_normal(N_NOISE), k * dt
        measure(world["sensors"], truth["errors"], truth["target"], plant, k, noise, m)
        if spoil is not None:
            spoil(t, m)
        _listen(onboard, m)
        out.time.append(t)
        out.faults.append(int(sum(int(f) << i for i, f in enumerate(estimator["faulty"]))))
        out.said.append(1.0 - estimator["loss"])
        out.heard.append(s["belief"]["effectiveness"].copy())
        u[: len(vehicle.commands)] = commands(t)
        step_plant(world["model"], truth["environment"], truth["faults"], plant, u, dt, 2, noise)
    return out


def _listen(onboard: np.void, m: np.void) -> None:
    """What an autopilot does with a measurement up to its belief in its actuators."""
    settings, s, sensors = onboard["settings"], onboard["state"], onboard["sensors"]
    allocation, dt, work = settings["allocation"], settings["dt"], onboard["scratch"]["estimator"]
    clock, navigation, estimator = s["clock"], s["navigation"], s["estimator"]
    model, believed, out = onboard["model"], s["belief"]["effectiveness"], onboard["output"]["navigation"]
    navigate(dt, settings["navigation"], clock, sensors, model, believed, m, navigation, out)
    estimate_effectiveness(
        dt, allocation["fault_evidence"], sensors, onboard["model"], m, navigation, estimator, work
    )
    believe_faults(allocation, dt, clock["time"], onboard["plan"]["faults"], estimator, s["belief"])
    clock["cycle"] += 1
    clock["time"] += dt
