"""Operating points: each mode of a mission flown to rest about its reference, without noise.

The path is straightened to the north and the mission's current turned with it. Dead reckoning and the
target's estimate are taken as exact, and in F and R the way along the track is held: it is the supervisor's
variable, not a state that the mode contracts. A fifth of the thrust of each thruster that would idle is taken
up by a constant load, because a stopped propeller has no slope: n grows with the root of thrust.
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from bumpless.config.mission import End, Environment, Leg, Mission, Sensors, Start, Target
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.control.supervisor import change_mode
from bumpless.sim.twin import Twin

FAR_M = 500.0
SETTLE_S = 200.0
_KEPT = ("_onboard", "_world", "_row", "_last")


class Silence:
    """A source of random numbers that are all zero."""

    def standard_normal(self, size: Any = None, out: np.ndarray | None = None) -> np.ndarray:
        """Zeros, into `out` when given."""
        if out is None:
            return np.zeros(size or ())
        out[:] = 0.0
        return out


@dataclass
class Point:
    """A twin that flies one mode about its reference; `save` and `restore` move between states."""

    twin: Twin
    mode: int
    held: float  # north, m; NaN when free
    target: np.ndarray

    def step(self) -> None:
        """One cycle, then what is taken as exact is set again."""
        self.twin.step()
        plant, navigation = self.twin.world["plant"], self.twin.onboard["state"]["navigation"]
        if math.isfinite(self.held):
            plant["eta"][0] = self.held
        navigation["eta"][:2] = plant["eta"][:2]
        navigation["target"] = self.target

    def save(self) -> dict[str, np.ndarray]:
        """Everything that the next cycle depends on."""
        return {name: getattr(self.twin, name).view(np.uint8).copy() for name in _KEPT}

    def restore(self, saved: dict[str, np.ndarray]) -> None:
        """Back to a saved state."""
        for name, value in saved.items():
            getattr(self.twin, name).view(np.uint8)[:] = value
        self.twin.events.drain()

    def enter(self, mode: int) -> None:
        """Make the next cycle the first in `mode`, as the supervisor does."""
        state = self.twin.onboard["state"]
        change_mode(mode, int(state["clock"]["cycle"]), state["supervisor"])
        self.mode, self.twin.onboard["orders"]["change"] = mode, 1

    @property
    def period(self) -> int:
        """Cycles after which all sensors have been read once."""
        sensors = self.twin.onboard["sensors"]
        return math.lcm(max(1, int(sensors["dvl_period"])), max(1, int(sensors["camera_period"])))


def straightened(mission: Mission, model: np.void, mode: int) -> Mission:
    """The mission's last leg and target, turned to the north and moved far from the start."""
    heading = math.radians(mission.target.heading_deg)
    n, e, d = mission.environment.current_ned_mps
    ahead, aside = (
        n * math.cos(heading) + e * math.sin(heading),
        -n * math.sin(heading) + e * math.cos(heading),
    )
    depth = max(mission.target.position_ned_m[2], 20.0)
    load = thruster_load(model, mode) + np.array(mission.environment.disturbance_body_n_nm)
    return replace(
        mission,
        start=Start((0.0, 0.0, depth), 0.0, mission.legs[-1].speed_mps),
        legs=(Leg((FAR_M, 0.0, depth), mission.legs[-1].speed_mps),),
        target=Target((FAR_M + mission.target.standoff_m, 0.0, depth), 0.0, mission.target.standoff_m),
        environment=Environment((ahead, aside, d), None, None, tuple(float(x) for x in load)),  # type: ignore[arg-type]
        sensors=Sensors(noise_scale=0.0),
        faults=(),
        end=End(),
        duration_s=1e5,
    )


def thruster_load(model: np.void, mode: int) -> np.ndarray:
    """Minus the wrench of the thrusters at a fifth of their largest thrust, N and N m.

    Those that push ahead count in hover only; under way they work anyway.
    """
    load = np.zeros(6)
    for i in range(int(model["n_u"])):
        works = mode != HOVER and abs(model["direction"][i, 0]) > 0.5
        if not works:  # what is no screw has no T_nn
            force = 0.2 * model["T_nn"][i] * model["command_max"][i] ** 2 * model["direction"][i]
            load[:3] -= force
            load[3:] -= np.cross(model["position"][i], force)
    return load * model["controllable"]


def settle(mission: Mission, vehicle: Vehicle, parameters: Parameters, mode: int) -> Point:
    """Fly `mode` until it is at rest about its reference; the allocator solves to the last digit."""
    exact = replace(parameters.allocation, sqp_iterations=30, kkt_tolerance=1e-11)
    twin = Twin(vehicle)
    flown = straightened(mission, twin.onboard["model"], mode)
    chosen = replace(parameters, allocation=exact)
    twin.start(flown, 0, chosen)
    twin._rng = Silence()  # type: ignore[assignment]
    twin.onboard["settings"]["supervisor"]["n_dwell"] = np.iinfo(np.int64).max // 4
    supervisor = parameters.supervisor
    away = {
        FORWARD: FAR_M / 2,
        REVERSE: (supervisor.range_fr_lower_m + supervisor.range_rh_lower_m) / 2,
        HOVER: 0.0,
    }[mode]
    target = np.array(flown.target.position_ned_m)
    plant, state = twin.world["plant"], twin.onboard["state"]
    plant["eta"][0] = state["navigation"]["eta"][0] = FAR_M - away
    if mode == HOVER:
        plant["nu"][:2] = flown.environment.current_ned_mps[:2]
    passes = parameters.guidance.speed_min_mps > 0.0  # such a vehicle cannot stop in H
    free = mode == HOVER and not passes
    point = Point(twin, mode, math.nan if free else FAR_M - away, target)
    state["supervisor"]["mode"], state["supervisor"]["switch_cycle"] = mode, 0
    count = round(SETTLE_S / vehicle.control_period_s / point.period) * point.period
    for _ in range(count):
        point.step()
    twin.events.drain()
    return point
