"""A twin put where a vehicle is now, from nothing but what the vehicle says of itself.

What it doesn't say is inferred: integrals such that the PID demands what it said it demands, what guidance
has learnt such that its references are those told. The sea is the current it believes in, the target stands
where it believes it, its sensors are without noise: what follows is what the vehicle's own model expects.
"""

from dataclasses import dataclass
from math import radians
from types import SimpleNamespace
from typing import Any

import numpy as np

from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import APPROACH, ENTRY, FORWARD, RUNNING, TRANSIT
from bumpless.contract.units import EDGE_PER_SI
from bumpless.control.docking.entry import choose_way
from bumpless.control.docking.line import approach_most, approach_speed
from bumpless.control.guidance.station import observation_point
from bumpless.sim.cycle import fly
from bumpless.sim.twin import Twin, new_log

_BEHIND = 0.7  # of the wanted deceleration that is in force, on the whole: its jerk is limited
_LONG_AGO = -1_000_000_000  # cycle
_PROBE = 0.01  # m or rad, of what guidance has learnt
_OFTEN = 1000  # fixes: the target has been seen for long


@dataclass(frozen=True)
class Said:
    """The newest message of each kind."""

    navigation: pb.Navigation
    guidance: pb.Guidance
    supervisor: pb.Supervisor
    control: pb.Control
    actuators: pb.Actuators
    target: pb.Target
    mission: pb.MissionStatus


class PresentTwin(Twin):
    """A twin from the present moment on. Raises ValueError when no mission runs, or numbers are missing."""

    def __init__(self, vehicle: Vehicle, mission: Mission, parameters: Parameters, said: Said) -> None:
        super().__init__(vehicle, parameters)
        if said.supervisor.phase != RUNNING:
            raise ValueError("no mission is running: what would be flown ahead is not known")
        if len(said.actuators.actuators) != len(vehicle.commands):
            raise ValueError("the vehicle tells of other actuators than its description")
        self.start(mission, mission.seed, parameters)
        self.drain_events()
        self._said = said
        self._place()
        self._remember()
        records = (self._onboard, self._world)
        if not all(np.isfinite(_floats(record)).all() for record in records):
            raise ValueError("what the vehicle says of its state is not finite")
        self._learn()

    def ahead(self, cycles: int) -> np.ndarray:
        """Fly up to so many cycles without noise; their LOG rows."""
        log = new_log(cycles)
        noise = np.zeros((cycles, self._noise.shape[1]))
        return log[: fly(self._handle, self._onboard, self._world, noise, log)]

    def _place(self) -> None:
        """The plant and its world, as the vehicle believes them."""
        said, world = self._said, self.world
        plant, truth = world["plant"], world["truth"]
        environment = truth["environment"]
        plant["eta"], plant["nu"] = _eta(said.navigation), _nu(said.navigation)
        plant["time"] = said.navigation.stamp.mission_time_s
        plant["gust"] = 0.0
        plant["u"][: len(self.vehicle.commands)] = self._si(a.feedback for a in said.actuators.actuators)
        for name in ("gust_std", "wave_height", "n_profile", "shelter_width"):
            environment[name] = 0
        environment["current"] = _vector(said.navigation.current_estimate_ned_mps)
        truth["errors"]["noise_scale"] = 0.0
        truth["target"][:3] = _vector(said.target.position_ned_m)
        shares = [a.effectiveness if a.HasField("effectiveness") else 1.0 for a in said.actuators.actuators]
        faults = truth["faults"]
        lost = [(i, share) for i, share in enumerate(shares) if share < 1.0][: len(faults["actuator"])]
        faults["n"] = len(lost)
        for k, (actuator, share) in enumerate(lost):
            faults["actuator"][k], faults["effectiveness"][k] = actuator, share
            faults["time"][k], faults["blend"][k] = -1.0, 0.0
        plant["effectiveness"][: len(shares)] = shares

    def _remember(self) -> None:
        """What the autopilot remembers."""
        said, state, plan = self._said, self._state, self.onboard["plan"]
        supervisor, navigation, control = said.supervisor, said.navigation, said.control
        cycle = max(1, round(navigation.stamp.mission_time_s / self.period_s))
        state["clock"]["cycle"], state["clock"]["time"] = cycle, cycle * self.period_s
        plan["cycles"] = max(int(plan["cycles"]), round(said.mission.duration_s / self.period_s))
        believed = state["navigation"]
        believed["eta"], believed["nu"] = _eta(navigation), _nu(navigation)
        believed["current"] = _vector(navigation.current_estimate_ned_mps)
        believed["target"] = _vector(said.target.position_ned_m)
        believed["fixes"] = _OFTEN if supervisor.detection else 0
        believed["smooth_nu_r"][:3] = _vector(navigation.velocity_through_water_body_mps)
        believed["smooth_nu_r"][3:] = believed["nu"][3:]
        self._remember_mode(cycle)
        state["guidance"]["leg"] = said.guidance.leg
        state["guidance"]["reference"] = _reference(said.guidance)
        state["allocation"]["u"][: len(self.vehicle.commands)] = self._si(
            a.command for a in said.actuators.actuators
        )
        state["allocation"]["tau_c"] = _wrench(control.achieved)
        state["pid"]["unmet"] = _wrench(control.residual)
        state["pid"]["smooth"]["e"] = _errors(state["guidance"]["reference"], believed)
        state["pid"]["smooth"]["e_dot"][2:] = [0.0, *(-believed["nu"][3:])]
        state["belief"]["effectiveness"] = self.world["plant"]["effectiveness"]
        if state["docking"]["stage"]:
            self._remember_docking(cycle)

    def _remember_mode(self, cycle: int) -> None:
        said, settings = self._said.supervisor, self._settings
        supervisor, switching = self._state["supervisor"], self._state["switching"]
        mode = int(said.mode) or FORWARD
        supervisor["mode"], supervisor["previous_mode"] = mode, int(said.previous_mode) or mode
        supervisor["switch_cycle"] = (
            cycle - round(said.time_in_mode_s / self.period_s)
            if said.dwell_remaining_s > 0 or said.kappa < 1
            else _LONG_AGO
        )
        seen = bool(said.detection)
        supervisor["detected"] = seen
        supervisor["history"] = (1 << int(settings["supervisor"]["window"])) - 1 if seen else 0
        supervisor["hold_left"] = settings["supervisor"]["hold"] if seen else 0
        now, before = settings["modes"][mode - FORWARD], int(said.previous_mode) or mode
        old = settings["modes"][before - FORWARD]
        for name in ("Q", "R", "lam", "increment_share"):
            switching["minus"][name] = old[name]
            switching["now"][name] = now[name] if said.kappa >= 1 else old[name]
        control = self._said.control
        switching["now"]["tau_d"], switching["minus"]["tau_d"] = (
            _wrench(control.demanded),
            _wrench(control.frozen),
        )
        switching["kappa"], switching["ramp_length"] = said.kappa, now["n_sw"]
        switching["ramp_cycle"] = cycle - round(said.kappa * now["n_sw"]) if said.kappa < 1 else _LONG_AGO
        self._state["pid"]["K_I"] = now["K_I"]

    def _remember_docking(self, cycle: int) -> None:
        said, docking = self._said.supervisor, self._state["docking"]
        docking["stage"] = said.docking_stage or docking["stage"]
        docking["stage_cycle"] = cycle - round(said.time_in_mode_s / self.period_s)
        docking["tried"], docking["reason"] = said.docking_tries, said.wave_off_reason
        docking["heading"] = radians(said.approach_heading_deg)
        docking["made"] = self._state["navigation"]["nu"][0]  # no brake is blamed for what was not seen
        docking["fix_age"] = round(min(said.fix_age_s, 1e6) / self.period_s)
        docking["cleared"] = said.range_m <= float(self._settings["docking"]["gate_distance"])
        if docking["stage"] in (TRANSIT, ENTRY):
            docking["turn"] = self._state["navigation"]["nu"][5]
        if docking["stage"] == ENTRY:
            self._remember_way()
        if docking["stage"] == APPROACH:
            self._remember_braking()

    def _remember_braking(self) -> None:
        """How fast the speed reference falls on the approach line: it closes on what is asked there."""
        docking, settings, law = self._state["docking"], self._docking_settings(), self._settings["guidance"]
        left, in_force = float(self._said.supervisor.range_m), float(self._state["guidance"]["reference"][0])
        goal = approach_speed.py_func(settings, left)
        if int(self._state["supervisor"]["mode"]) == FORWARD:
            goal = min(goal, in_force)  # the leg's speed, until it brakes
        else:
            goal = min(goal, approach_most.py_func(settings, float(law["reverse_max"]), left))
        fastest = float(law["acceleration"])
        wanted = (goal - in_force) / settings.speed_time
        docking["u_dot"] = _BEHIND * min(max(wanted, -fastest), fastest)

    def _docking_settings(self) -> Any:
        return self._settings["docking"].copy().view((np.record, self._settings["docking"].dtype))

    def _remember_way(self) -> None:
        """Where the way round leads: the shortest from here, the one begun but for its first seconds."""
        docking, believed, plan = self._state["docking"], self._state["navigation"], self.onboard["plan"]
        settings = self._docking_settings()
        keep, point = settings.keep_out + float(plan["dock_radius"]), np.zeros(4)
        observation_point(believed["target"], float(docking["heading"]), float(plan["standoff"]), point)
        way = SimpleNamespace(heading=float(docking["heading"]), side=0, farther=0.0)
        choose_way.py_func(settings, keep, believed["eta"], believed["target"], point, way)
        docking["side"], docking["farther"] = way.side, way.farther

    def _learn(self) -> None:
        """What guidance has learnt and integrals hold, from one cycle flown for trial and taken back."""
        guidance, pid = self._state["guidance"], self._state["pid"]
        told = _reference(self._said.guidance)
        for _ in range(2):
            at = self._tried()["reference"]
            for name, channel in (("b", 5), ("alpha", 4)):
                before = float(guidance[name])
                guidance[name] = before + _PROBE
                slope = (self._tried()["reference"][channel] - at[channel]) / _PROBE
                step = (told[channel] - at[channel]) / slope if abs(slope) > 1e-3 else 0.0
                guidance[name] = before + float(np.clip(step, -0.6, 0.6))
        missing = _wrench(self._said.control.demanded_raw) - self._tried()["tau_plus"]
        pid["integral"] = np.where(pid["K_I"] > 0.0, missing, 0.0)

    def _tried(self) -> Any:
        """The row of one cycle from here, with everything as it was before."""
        records = [(record, record.copy()) for record in (self._onboard, self._world)]
        row = self.ahead(1)[0].copy()
        for record, before in records:
            record.view(np.uint8)[:] = before.view(np.uint8)
        return row

    def _si(self, values: Any) -> list[float]:
        return [
            value / EDGE_PER_SI[command.unit]
            for value, command in zip(values, self.vehicle.commands, strict=True)
        ]


def _vector(v: pb.Vector3) -> list[float]:
    return [v.x, v.y, v.z]


def _wrench(w: pb.Wrench) -> np.ndarray:
    return np.array([w.x_n, w.y_n, w.z_n, w.k_nm, w.m_nm, w.n_nm])


def _angles(a: pb.Attitude) -> list[float]:
    return [radians(a.roll_deg), radians(a.pitch_deg), radians(a.yaw_deg)]


def _eta(n: pb.Navigation) -> list[float]:
    return [*_vector(n.position_ned_m), *_angles(n.attitude)]


def _nu(n: pb.Navigation) -> list[float]:
    rates = _vector(n.angular_rate_body_degps)
    return [*_vector(n.velocity_body_mps), *(radians(rate) for rate in rates)]


def _reference(g: pb.Guidance) -> np.ndarray:
    speeds = [g.surge_speed_reference_mps, g.sway_speed_reference_mps, g.depth_reference_m]
    return np.array([*speeds, *_angles(g.attitude_reference)])


def _errors(reference: np.ndarray, believed: Any) -> np.ndarray:
    """e of eq. (42)."""
    eta, nu = believed["eta"], believed["nu"]
    angles = (reference[3:] - eta[3:] + np.pi) % (2.0 * np.pi) - np.pi
    return np.array([reference[0] - nu[0], reference[1] - nu[1], reference[2] - eta[2], *angles])


def _floats(record: np.ndarray) -> np.ndarray:
    """State numbers that came from outside, of a record of either kind."""
    found: list[Any] = []
    if "plant" in (record.dtype.names or ()):
        found = [record["plant"][name].ravel() for name in ("eta", "nu", "u")]
    else:
        state = record["state"]
        found = [state["navigation"][name].ravel() for name in ("eta", "nu", "current", "target")]
        found += [state["switching"]["now"]["tau_d"].ravel(), state["guidance"]["reference"].ravel()]
        found += [state["allocation"]["u"].ravel(), state["pid"]["unmet"].ravel()]
    return np.concatenate([np.asarray(part, float) for part in found])
