"""Plant and autopilot in fixed steps, seeded, as fast as the machine can.

`Twin` flies one control cycle at a time (the live node paces it); `simulate` flies a whole mission
in one compiled loop. Both use the same compiled cycle, so the same seed gives the same rows.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from bumpless import records
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters, default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.control.allocation.qp import make_handle
from bumpless.control.autopilot import reset_autopilot
from bumpless.physics.model import build_model
from bumpless.physics.plant import new_work, observe_plant
from bumpless.sim.cycle import COMPLETED, IDLE, RUNNING, fly
from bumpless.sim.events import EventWriter, TwinEvent, completed_event, eventful, row_events
from bumpless.sim.settings import fill_settings, mode_controls, plan_of, sensors_of
from bumpless.sim.truth import TRUTH, tell, truth_of

Alter = Callable[[Any, Any], None]  # changes records in place
_CHUNK = 1024  # cycles per compiled call of `simulate`, so that progress can be shown


def parameters_for(vehicle: Vehicle, mission: Mission | None) -> Parameters:
    """The vehicle's parameters with the mission's overrides."""
    parameters = default_parameters(vehicle)
    return with_overrides(parameters, mission.parameters) if mission and mission.parameters else parameters


def one(dtype: np.dtype) -> np.ndarray:
    """A zeroed array of one record."""
    return np.zeros(1, dtype)


def new_log(cycles: int) -> np.ndarray:
    """Empty LOG rows for `Twin.fly`, shape (cycles,)."""
    return np.zeros(cycles, records.LOG)


class Twin:
    """One simulated vehicle with its autopilot. Not thread safe: one thread steps it."""

    def __init__(self, vehicle: Vehicle, parameters: Parameters | None = None) -> None:
        self.vehicle = vehicle
        self.period_s = vehicle.control_period_s
        self.mission: Mission | None = None
        self.phase: int = IDLE
        self.seed = 0
        self.events = EventWriter(tuple(actuator.name for actuator in vehicle.actuators))
        self._handles: dict[str, np.ndarray] = {}
        self._models = np.array([build_model(vehicle)] * 2)  # what the autopilot knows, what is true
        self._model, self._plant_model = self._models[0], self._models[1]
        self._settings, self._modes = one(records.SETTINGS), np.zeros(3, records.MODE_CONTROL)
        self._plan, self._truth, self._sensors = one(records.PLAN), one(TRUTH), one(records.SENSORS)
        self._plant, self._m = one(records.PLANT), one(records.MEASUREMENT)
        self._a, self._w = one(records.AUTOPILOT), one(records.ALLOCATION_WORK)
        self._row, self._last = one(records.LOG), one(records.LOG)
        # NumPy copies a record field by field, bytes at once: 85 and 2 us
        self._row_bytes, self._last_bytes = self._row.view(np.uint8), self._last.view(np.uint8)
        self._work = new_work()
        self._change = 0
        self._paused_at = 0  # cycle
        self._rng = np.random.Generator(np.random.PCG64(0))
        self._noise = np.zeros((1, records.N_NOISE))
        self._adopt(parameters or default_parameters(vehicle))
        self._plant[0]["effectiveness"] = 1.0
        self._a[0]["effectiveness"] = 1.0

    def _adopt(self, parameters: Parameters) -> None:
        self.parameters = parameters
        fill_settings(self._settings, self.vehicle, parameters)
        self._modes[:] = mode_controls(parameters)
        self._model["smoothing"] = parameters.allocation.shaft_smoothing
        solver = parameters.allocation.solver
        if solver not in self._handles:
            self._handles[solver] = make_handle(solver)
        self._handle = self._handles[solver]

    def start(
        self,
        mission: Mission,
        seed: int | None = None,
        parameters: Parameters | None = None,
        alter: Alter | None = None,
    ) -> None:
        """Put the plant at the mission's start and begin; parameters default to vehicle plus mission.

        alter(plant model, truth): may change the true vehicle and the TRUTH record; of both the autopilot
        learns no more than `bumpless.sim.truth.tell` tells it.
        """
        self._adopt(parameters or parameters_for(self.vehicle, mission))
        self.mission, self.seed = mission, mission.seed if seed is None else seed
        self._plan[:] = plan_of(mission, self.period_s)
        self._truth[:] = truth_of(mission, self.vehicle)
        self._sensors[:] = sensors_of(self.vehicle, mission)
        self._models[1:] = self._models[:1]
        if alter is not None:
            alter(self._plant_model, self._truth[0])
        tell(self._truth, self._plan, faults=self.parameters.allocation.effectiveness == "known")
        self._rng = np.random.Generator(np.random.PCG64(self.seed))
        place_plant(self._truth, self._sensors, self._plant, self._rng)
        observe_plant(self._plant_model, self._truth[0], self._plant[0], self._work)
        self._m[:] = self._a[:] = self._w[:] = 0  # nothing of an earlier run is left, not even in rounding
        reset_autopilot(self._modes, self._plan[0], self._model, self._a[0])
        self.phase, self._change = 2, 0
        self._last[:] = 0
        self.events.add("mission_started", f"Mission {mission.name} started.", {"mission": mission.name})

    def pause(self) -> None:
        """Brake, and hold station where the vehicle can stop until `resume`; the supervisor is frozen."""
        a = self._a[0]
        ahead, psi = self._stopping_distance(float(a["nu"][0])), a["eta"][5]
        a["hold_point"] = [
            a["eta"][0] + ahead * np.cos(psi),
            a["eta"][1] + ahead * np.sin(psi),
            a["eta"][2],
            psi,
        ]
        a["holding"], self._change, self.phase = 1, 1, 3
        self._paused_at = int(a["cycle"])
        self.events.add("mission_paused", "Mission paused; holding station.", {})

    def _stopping_distance(self, surge: float) -> float:
        """Way from `surge` (m/s) to rest: half the ramp at this speed, then all reverse thrust, m."""
        m, n = self._model, int(self._model["n_u"])
        thrust = np.maximum(m["T_nn"], m["T_nn_reverse"])[:n] * m["command_min"][:n] ** 2
        push = float(np.sum(thrust * np.abs(m["direction"][:n, 0]) * (m["kind"][:n] == records.THRUSTER)))
        braking = max(push, 1e-3) / float(m["M_RB"][0, 0] + m["M_A"][0, 0])
        ramp_s = self.parameters.hover.ramp_cycles * self.period_s
        return surge * ramp_s / 2 + surge * abs(surge) / (2 * braking)

    def resume(self) -> None:
        """Go on with the mission; its longest duration does not count the pause."""
        self._plan[0]["cycles"] += int(self._a[0]["cycle"]) - self._paused_at
        self._a[0]["holding"], self._change, self.phase = 0, 1, 2
        self.events.add("mission_resumed", "Mission resumed.", {})

    def abort(self, reason: str) -> None:
        """Stop every actuator as fast as its bounds allow."""
        self._a[0]["holding"], self.phase = 0, 5
        self.events.add("mission_aborted", f"Mission aborted: {reason}.", {"reason": reason}, severity=2)

    def set_parameters(self, parameters: Parameters) -> None:
        """Fly with other parameters from the next cycle on, blended in over the present mode's ramp."""
        self._adopt(parameters)
        self._change = 1
        self.events.add("parameters_applied", "New parameters are in force.", {})

    def step(self) -> np.ndarray:
        """Fly one control cycle; returns its LOG record, valid until the next step."""
        if self.phase != IDLE:
            self._rng.standard_normal(out=self._noise)
        _, phase = self._fly(self._noise, self._row)
        row = self._row[0]
        row_events(self.events, self._last[0], row, self._settings[0])
        self._last_bytes[:] = self._row_bytes
        if phase != self.phase:
            self.phase = phase
            completed_event(self.events, row)
        return row

    @property
    def cycles(self) -> int:
        """Longest duration of the mission, in control cycles."""
        return int(self._plan[0]["cycles"])

    def fly(self, log: np.ndarray) -> int:
        """Fly on until `log` (of `new_log`) is full or the phase changes; returns how many rows were filled.

        The cycles are those of `simulate`, however the flight is cut into calls. Adds no events for the rows.
        """
        rows, self.phase = self._fly(self._rng.standard_normal((len(log), records.N_NOISE)), log)
        return rows

    def _fly(self, noise: np.ndarray, log: np.ndarray) -> tuple[int, int]:
        """Fill `log` as `cycle.fly` does; noise (len(log), N_NOISE)."""
        flown = fly(
            self._handle,
            self._settings,
            self._modes,
            self._sensors,
            self._plan,
            self._truth,
            self._models[:1],
            self._models[1:],
            self._plant,
            self._m,
            self._a,
            self._w,
            self.phase,
            self._change,
            noise,
            log,
            self._work,
        )
        self._change = 0
        return flown

    def drain_events(self) -> list[TwinEvent]:
        """Events since the last call, oldest first."""
        return self.events.drain()


def place_plant(truth: np.ndarray, sensors: np.ndarray, plant: np.ndarray, rng: np.random.Generator) -> None:
    """Put the plant at the mission's start; draw the biases that last a run."""
    plant[:] = 0
    p = plant[0]
    p["eta"] = truth[0]["start"]
    psi = p["eta"][5]
    current = truth[0]["current"]
    p["nu"][0] = truth[0]["start_speed"] + current[0] * np.cos(psi) + current[1] * np.sin(psi)
    p["nu"][1] = -current[0] * np.sin(psi) + current[1] * np.cos(psi)
    p["effectiveness"] = 1.0
    draws = rng.standard_normal(4)
    p["heading_bias"] = draws[0] * sensors[0]["heading_bias_std"]
    p["depth_bias"] = draws[1] * sensors[0]["depth_bias_std"]
    p["gust"][:2] = draws[2:4] * truth[0]["gust_std"]


@dataclass(frozen=True)
class Result:
    """A flown mission: one LOG row per control cycle, and what made it."""

    log: np.ndarray
    mission: Mission
    vehicle: Vehicle
    parameters: Parameters
    seed: int
    phase: int
    events: list[TwinEvent] = field(default_factory=list)


def simulate(
    mission: Mission,
    vehicle: Vehicle,
    parameters: Parameters | None = None,
    seed: int | None = None,
    progress: Callable[[float], None] | None = None,
    alter: Alter | None = None,
) -> Result:
    """Fly `mission` to its end. A pure, picklable function of its arguments; solve times aside.

    parameters: default is the vehicle's with the mission's overrides. seed: default is the
    mission's. progress is called with the share flown, 0 to 1. alter: as in `Twin.start`.
    """
    parameters = parameters or parameters_for(vehicle, mission)
    twin = Twin(vehicle, parameters)
    twin.start(mission, seed, parameters, alter)
    total = twin.cycles
    log = new_log(total)
    filled = 0
    while filled < total and twin.phase == RUNNING:
        filled += twin.fly(log[filled : filled + _CHUNK])
        if progress:
            progress(filled / total if twin.phase == RUNNING else 1.0)
    log = log[:filled]
    for k in eventful(log):
        row_events(twin.events, log[k - 1], log[k], twin._settings[0])
    completed_event(twin.events, log[-1])
    return Result(log, mission, vehicle, twin.parameters, twin.seed, COMPLETED, twin.drain_events())
