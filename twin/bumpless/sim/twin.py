"""Plant and autopilot in fixed steps, seeded, as fast as the machine can.

`Twin` flies one control cycle at a time (the live node paces it); `simulate` flies a whole mission
in one compiled loop. Both use the same compiled cycle, so the same seed gives the same rows.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters, default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import (
    ABORTED,
    APPROACH,
    BACK,
    COMPLETED,
    CREEP,
    FAILSAFE,
    FORWARD,
    HOVER,
    IDLE,
    PAUSED,
    RUNNING,
    WARNING,
)
from bumpless.control.allocation.qp import make_handle
from bumpless.control.onboard import ONBOARD
from bumpless.control.reset import reset_state
from bumpless.physics.model import build_model, fill_flow
from bumpless.physics.plant import observe_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.sim.condition import Condition, condition_of
from bumpless.sim.cycle import fly
from bumpless.sim.events import EventWriter, TwinEvent, completed_event, eventful, row_events
from bumpless.sim.log import LOG
from bumpless.sim.settings import fill_settings, plan_of, sensors_of
from bumpless.sim.trim import load
from bumpless.sim.truth import tell, truth_of
from bumpless.sim.world import WORLD, clear, place_plant, start_shafts

Alter = Callable[[Any, Any], None]  # changes records in place
_CHUNK = 1024  # cycles per compiled call of `simulate`, so that progress can be shown


def parameters_for(vehicle: Vehicle, mission: Mission | None) -> Parameters:
    """The vehicle's parameters with the mission's overrides."""
    parameters = default_parameters(vehicle)
    return with_overrides(parameters, mission.parameters) if mission and mission.parameters else parameters


def one(dtype: np.dtype) -> np.ndarray:
    """A zeroed array of one record."""
    return np.zeros(1, dtype)


def bytes_of(record: np.ndarray, name: str) -> np.ndarray:
    """The bytes of one field of an array of one record."""
    fields: Any = record.dtype.fields
    begin = fields[name][1]
    return record.view(np.uint8)[begin : begin + record.dtype[name].itemsize]


def new_log(cycles: int) -> np.ndarray:
    """Empty LOG rows for `Twin.fly`, shape (cycles,)."""
    return np.zeros(cycles, LOG)


class Twin:
    """One simulated vehicle with its autopilot. Not thread safe: one thread steps it.

    `onboard` and `world` are the ONBOARD and WORLD records: what the vehicle knows, and what is true.
    """

    def __init__(self, vehicle: Vehicle, parameters: Parameters | None = None) -> None:
        self.vehicle = vehicle
        self.period_s = vehicle.control_period_s
        self.mission: Mission | None = None
        self.seed = 0
        self.events = EventWriter(tuple(command.actuator for command in vehicle.commands))
        self._handles: dict[str, np.ndarray] = {}
        self._onboard, self._world = one(ONBOARD), one(WORLD)
        self.onboard, self.world = self._onboard[0], self._world[0]
        self._orders, self._state = self.onboard["orders"], self.onboard["state"]
        self._settings = self.onboard["settings"]
        self._settings_bytes = bytes_of(self._onboard, "settings")
        self._filled = self._settings_bytes[:0]  # what `parameters` came to
        self._row, self._last = one(LOG), one(LOG)
        # NumPy copies a record field by field, bytes at once: 85 and 2 us
        self._row_bytes, self._last_bytes = self._row.view(np.uint8), self._last.view(np.uint8)
        self._paused_at = 0  # cycle
        self._rng = np.random.Generator(np.random.PCG64(0))
        self._noise = np.zeros((1, N_NOISE))
        self.onboard["model"] = self.world["model"] = build_model(vehicle)
        self._adopt(parameters or default_parameters(vehicle))
        self._orders["phase"] = IDLE
        self._state["supervisor"]["mode"] = self._state["supervisor"]["previous_mode"] = FORWARD
        self._state["belief"]["effectiveness"] = self.world["plant"]["effectiveness"] = 1.0

    @property
    def phase(self) -> int:
        """MissionPhase."""
        return int(self._orders["phase"])

    def _adopt(self, parameters: Parameters) -> None:
        if len(self._filled) and parameters is self.parameters:  # a campaign's flights have them in common
            self._settings_bytes[:] = self._filled
            return
        self.parameters = parameters
        fill_settings(self._settings, self.vehicle, parameters)
        self._filled = self._settings_bytes.copy()
        self.onboard["model"]["smoothing"] = parameters.allocation.shaft_smoothing
        self.onboard["model"]["fins_coast"] = not parameters.allocation.fins_brake
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
        self._rng = np.random.Generator(np.random.PCG64(self.seed))
        onboard, world = self.onboard, self.world
        onboard["sensors"] = world["sensors"] = sensors_of(self.vehicle, mission)[0]
        world["truth"], world["model"] = truth_of(mission, self.vehicle)[0], onboard["model"]
        if mission.actuator_flow:
            fill_flow(world["model"], self.vehicle)
        load(world["model"], mission.trim)
        if alter is not None:
            alter(world["model"], world["truth"])
        place_plant(world["truth"], world["sensors"], world["plant"], self._rng)
        if self.parameters.docking.enabled:
            start_shafts(onboard["model"], world["truth"], world["plant"])
        observe_plant(world["model"], world["truth"]["environment"], world["plant"])
        onboard["plan"] = plan_of(mission, self.vehicle)[0]
        told = self.parameters.allocation.effectiveness == "known"
        tell(world["truth"], onboard["plan"], faults=told)
        clear(world["measurement"])  # nothing of an earlier run is left, not even in rounding
        for name in ("state", "output", "scratch"):
            clear(onboard[name])
        reset_state(self._settings, onboard["plan"], self._state)
        self._order(RUNNING, change=False)
        self._last[:] = 0
        self.events.add("mission_started", f"Mission {mission.name} started.", {"mission": mission.name})

    def _order(self, phase: int, change: bool) -> None:
        """Fly in `phase` from the next cycle on; change: with a ramp."""
        self._orders["phase"], self._orders["change"] = phase, change

    def pause(self) -> None:
        """Brake, and hold station where the vehicle can stop until `resume`; the supervisor is frozen."""
        self._hold(PAUSED)
        self._paused_at = int(self._state["clock"]["cycle"])
        self.events.add("mission_paused", "Mission paused; holding station.", {})

    def surface(self) -> None:
        """Brake, and hold station at the surface until told otherwise; also after a mission."""
        if self.phase != PAUSED:
            self._paused_at = int(self._state["clock"]["cycle"])
            self._hold(PAUSED)
        self._orders["hold_point"][2] = 0.0
        self.events.add("surfacing", "Holding station at the surface.", {}, WARNING)

    def wave_off(self) -> bool:
        """Back off along the approach line and hold there for good; False where no approach is flown."""
        docking, settings = self._state["docking"], self._settings["docking"]
        if not self.parameters.docking.enabled or docking["stage"] not in (APPROACH, BACK, CREEP):
            return False
        docking["stage"], docking["stage_cycle"] = BACK, self._state["clock"]["cycle"]
        docking["gate_cycles"] = docking["cleared"] = 0
        docking["reason"], docking["back_to"] = FAILSAFE, settings["hold_distance"]
        docking["tried"] = settings["tries"]  # no further one
        return True

    @property
    def condition(self) -> Condition:
        """What the vehicle reports of its body."""
        return condition_of(self.mission, float(self._state["clock"]["time"]))

    def _hold(self, phase: int) -> None:
        """Brake in `phase`, and hold station where the vehicle can stop."""
        eta, surge = self._state["navigation"]["eta"], float(self._state["navigation"]["nu"][0])
        ahead, psi = self._stopping_distance(surge), eta[5]
        self._orders["hold_point"] = [
            eta[0] + ahead * np.cos(psi),
            eta[1] + ahead * np.sin(psi),
            eta[2],
            psi,
        ]
        self._order(phase, change=True)

    def _stopping_distance(self, surge: float) -> float:
        """Way from `surge` (m/s) to rest: half the ramp at this speed, then all reverse thrust, m."""
        m, n = self.onboard["model"], int(self.onboard["model"]["n_u"])
        thrust = np.maximum(m["T_nn"], m["T_nn_reverse"])[:n] * m["command_min"][:n] ** 2
        push = float(np.sum(thrust * np.abs(m["direction"][:n, 0])))
        braking = max(push, 1e-3) / float(m["M_RB"][0, 0] + m["M_A"][0, 0])
        ramp_s = self.parameters.hover.ramp_cycles * self.period_s
        return surge * ramp_s / 2 + surge * abs(surge) / (2 * braking)

    def resume(self) -> None:
        """Go on with the mission; its longest duration does not count the pause."""
        self.onboard["plan"]["cycles"] += int(self._state["clock"]["cycle"]) - self._paused_at
        self._order(RUNNING, change=True)
        self.events.add("mission_resumed", "Mission resumed.", {})

    def abort(self, reason: str) -> None:
        """Stop every actuator as fast as its bounds allow; also of a vehicle that holds after its mission."""
        over = self.phase == COMPLETED
        self._orders["phase"] = ABORTED
        code, what = (
            ("actuators_stopped", "Actuators stopped") if over else ("mission_aborted", "Mission aborted")
        )
        self.events.add(code, f"{what}: {reason}.", {"reason": reason}, WARNING)

    def set_parameters(self, parameters: Parameters) -> None:
        """Fly with other parameters from the next cycle on, blended in over the present mode's ramp."""
        self._adopt(parameters)
        self._orders["change"] = True
        self.events.add("parameters_applied", "New parameters are in force.", {})

    def step(self) -> np.void:
        """Fly one control cycle; returns its LOG record, valid until the next step."""
        phase = self.phase
        if phase != IDLE:
            self._rng.standard_normal(out=self._noise)
        fly(self._handle, self._onboard, self._world, self._noise, self._row)
        row = self._row[0]
        row_events(self.events, self._last[0], row, self._settings)
        self._last_bytes[:] = self._row_bytes
        if self.phase != phase:
            completed_event(self.events, row)
            self._stay(float(row["time"]))
        return row

    def _stay(self, time_s: float) -> None:
        """After the mission: hold station until told otherwise, and say so."""
        if not self.parameters.docking.enabled and self._state["supervisor"]["mode"] != HOVER:
            self._hold(COMPLETED)
        text = "Holding station until told otherwise; abort stops all actuators, and the vehicle then drifts."
        self.events.add("holding_station", text, {}, time_s=time_s)

    @property
    def cycles(self) -> int:
        """Longest duration of the mission, in control cycles."""
        return int(self.onboard["plan"]["cycles"])

    def fly(self, log: np.ndarray) -> int:
        """Fly up to len(log) cycles into LOG rows, to the end of the phase at most; returns how many.

        The cycles are those of `simulate`, however the flight is cut into calls. Adds no events for the rows.
        """
        noise = self._rng.standard_normal((len(log), N_NOISE))
        return fly(self._handle, self._onboard, self._world, noise, log)

    def drain_events(self) -> list[TwinEvent]:
        """Events since the last call, oldest first."""
        return self.events.drain()


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
        row_events(twin.events, log[k - 1], log[k], twin.onboard["settings"])
    completed_event(twin.events, log[-1])
    return Result(log, mission, vehicle, twin.parameters, twin.seed, COMPLETED, twin.drain_events())
