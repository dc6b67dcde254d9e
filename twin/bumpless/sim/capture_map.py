"""Which offsets and angles a funnel takes up: a hull that is let into a dock, again and again.

The hull is not steered: it keeps its speed by thrust along x_b, and funnel and water do the rest. What an
autopilot adds is not in the map; it is what the dock forgives.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle
from bumpless.jit import jit
from bumpless.physics.dock.latch import feel_dock
from bumpless.physics.faults import FAULTS
from bumpless.physics.model import build_model
from bumpless.physics.plant import PLANT, step_plant
from bumpless.physics.sensors import N_NOISE
from bumpless.sim.truth import truth_of

DT, SUBSTEPS = 0.05, 4
BEFORE_M = 0.05  # of the nose before the entry at the start
LEFT_M = 0.5  # before the entry: the hull has been thrown out


@dataclass(frozen=True)
class CaptureMap:
    """Rows: offsets; columns: angles."""

    offset_m: npt.NDArray[np.float64]  # (n,) of the nose from the axis, in the plane of the angle
    angle_deg: npt.NDArray[np.float64]  # (m,) of the hull from the axis, positive where it points outwards
    captured: npt.NDArray[np.bool_]  # (n, m) and not harder than dock and hull bear
    force_max_n: npt.NDArray[np.float64]  # (n, m) largest sum of normal forces; NaN: begins inside a wall


def capture_map(
    mission: Mission,
    vehicle: Vehicle,
    offsets_m: Sequence[float],
    angles_deg: Sequence[float],
    speed_mps: float = 0.1,
    gain_nspm: float = 20.0,
    time_s: float = 60.0,
) -> CaptureMap:
    """What becomes of a hull whose nose comes to the entry with each offset and angle, in still water.

    gain_nspm: thrust per m/s of speed missing, so that a hull held fast pushes with gain_nspm * speed_mps.
    Raises: ValueError when the mission has no dock to enter.
    """
    if mission.target.dock is None:
        raise ValueError(f"{mission.name} has no dock to enter")
    model, noise, faults = build_model(vehicle), np.zeros(N_NOISE), np.zeros(1, FAULTS)
    rest = np.zeros(MAX_ACTUATORS)
    captured = np.zeros((len(offsets_m), len(angles_deg)), bool)
    force = np.zeros(captured.shape)
    for i, offset in enumerate(offsets_m):
        for j, angle in enumerate(angles_deg):
            environment = _still_water(mission, vehicle)
            plant = _before(environment["dock"], model, offset, np.radians(angle), speed_mps)
            cycles = round(time_s / DT)
            force[i, j] = let_in(
                model, environment, faults[0], plant, rest, speed_mps, gain_nspm, cycles, noise
            )
            dock = environment["dock"]
            captured[i, j] = dock["captured"] == 1 and force[i, j] <= dock["force_most"]
    return CaptureMap(np.array(offsets_m, float), np.array(angles_deg, float), captured, force)


def _still_water(mission: Mission, vehicle: Vehicle) -> Any:
    environment = np.zeros(1, truth_of(mission, vehicle).dtype["environment"])[0]
    dock = truth_of(mission, vehicle)[0]["environment"]["dock"]
    dock["period"] = 0.0
    environment["dock"] = dock
    return environment


def _before(dock: Any, model: Any, offset: float, angle: float, speed: float) -> Any:
    """A PLANT record with the nose before the entry, off to starboard, pointing outwards by `angle`."""
    plant, nose, axis = np.zeros(1, PLANT)[0], float(model["rings"]["x"][0]), float(dock["heading"])
    psi = axis + angle
    c, s = np.cos(axis), np.sin(axis)
    north, east, down = dock["entry"]
    plant["eta"][:3] = (
        north - BEFORE_M * c - offset * s - nose * np.cos(psi),
        east - BEFORE_M * s + offset * c - nose * np.sin(psi),
        down,
    )
    plant["eta"][5], plant["nu"][0], plant["effectiveness"] = psi, speed, 1.0
    return plant


@jit
def let_in(model, environment, faults, plant, command, speed, gain, cycles, noise):
    """Push the hull until it is captured, thrown out or out of time; largest sum of normal forces, N.

    NaN where it is inside a wall from the start.

    command (8,): at rest. Two seconds longer once captured, so that the stop is felt. gain: N s/m.
    """
    most, left = 0.0, cycles
    dock = environment.dock
    feel_dock(dock, model.rings, plant.eta, plant.nu, 0.0, environment.tau_e)
    if dock.felt.force > 0.0:
        return np.nan
    for k in range(6):
        environment.tau_e[k] = 0.0
    while left > 0:
        left -= 1
        push = 0.0 if dock.captured == 1 else gain * (speed - plant.nu[0])
        environment.tau_e[0] = push
        step_plant(model, environment, faults, plant, command, DT, SUBSTEPS, noise)
        most = max(most, dock.felt.peak)
        if dock.captured == 1 and left > 40:
            left = 40
        if dock.felt.nose_depth < -LEFT_M:
            return most
    return most
