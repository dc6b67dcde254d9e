"""The true plant and its sensors under commands of the test's own choice, watched by the estimator alone."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from bumpless import records
from bumpless.config.parameters import default_parameters, with_overrides
from bumpless.config.vehicle import load_vehicle
from bumpless.control.autopilot import believe_faults, reset_autopilot
from bumpless.control.effectiveness.step import estimate_effectiveness
from bumpless.control.navigation import navigate
from bumpless.physics.model import build_model
from bumpless.physics.plant import new_work, step_plant
from bumpless.physics.sensors import measure
from bumpless.sim.settings import fill_settings, mode_controls, plan_of, sensors_of
from bumpless.sim.truth import tell, truth_of
from bumpless.sim.twin import one, place_plant
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
    settings, model, modes = one(records.SETTINGS), build_model(vehicle), mode_controls(parameters)
    fill_settings(settings, vehicle, parameters)
    truth, plan, sensors = (
        truth_of(mission, vehicle),
        plan_of(mission, vehicle.control_period_s),
        sensors_of(vehicle, mission),
    )
    truth[0]["n_faults"], truth[0]["noise_scale"] = len(faults), noise_scale
    for f, (actuator, at, effectiveness) in enumerate(faults):
        truth[0]["fault_actuator"][f], truth[0]["fault_time"][f] = actuator, at
        truth[0]["fault_effectiveness"][f] = effectiveness
    tell(truth, plan, faults=False)
    plant, m, a = one(records.PLANT), one(records.MEASUREMENT), one(records.AUTOPILOT)
    rng, work, out = np.random.Generator(np.random.PCG64(seed)), new_work(), Watched()
    place_plant(truth, sensors, plant, rng)
    reset_autopilot(modes, plan[0], model, a[0])
    u, dt = np.zeros(records.MAX_ACTUATORS), vehicle.control_period_s
    for k in range(round(seconds / dt)):
        noise, t = rng.standard_normal(records.N_NOISE), k * dt
        measure(sensors[0], truth[0], plant[0], k, noise, m[0])
        if spoil is not None:
            spoil(t, m[0])
        navigate(settings[0], sensors[0], m[0], a[0], work)
        estimate_effectiveness(settings[0], sensors[0], model, m[0], a[0])
        believe_faults(settings[0], plan[0], a[0])
        estimator = a[0]["estimator"]
        out.time.append(t)
        out.faults.append(int(sum(int(f) << i for i, f in enumerate(estimator["faulty"]))))
        out.said.append(1.0 - estimator["loss"])
        out.heard.append(a[0]["effectiveness"].copy())
        u[: len(vehicle.actuators)] = commands(t)
        step_plant(model, truth[0], plant[0], u, dt, 2, noise, work)
        a[0]["cycle"] += 1
        a[0]["time"] += dt
    return out
