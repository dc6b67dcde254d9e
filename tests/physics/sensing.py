"""What the tests of sensors share: a suite without errors, and what it says of a plant held somewhere."""

from typing import Any

import numpy as np

from bumpless.physics.plant import PLANT
from bumpless.physics.sensors import MEASUREMENT, N_NOISE, SENSOR_ERRORS, SENSORS, measure

TARGET = np.array([10.0, 0.0, 2.0, 0.0])  # a marker 10 m north at 2 m, approached on north
DT = 0.05


class Suite:
    """A suite of sensors with no errors but those named, and a plant that tests put somewhere."""

    def __init__(self, **said: Any) -> None:
        self.sensors, self.errors, self.plant, self.m = (
            np.zeros(1, kind)[0] for kind in (SENSORS, SENSOR_ERRORS, PLANT, MEASUREMENT)
        )
        self.errors["noise_scale"], self.errors["key"] = 1.0, 12345
        self.sensors["dvl_dropout"] = self.sensors["camera_dropout"] = -np.inf
        self.sensors["n_cameras"], self.sensors["camera_range_max"] = 1, 100.0
        self.sensors["camera_half_angle"], self.sensors["camera_marker_angle"] = np.radians(40), np.pi
        self.sensors["camera_sight"] = 4.8
        for name, value in said.items():
            (self.sensors if name in (SENSORS.names or ()) else self.errors)[name] = value
        self.plant["eta"][2] = TARGET[2]
        self.rng, self.cycle = np.random.default_rng(1), 0

    def hear(self, cycles: int = 1, noise: bool = False) -> np.ndarray:
        """The measurements of so many cycles, (cycles,)."""
        out = np.zeros(cycles, MEASUREMENT)
        for k in range(cycles):
            row = self.rng.standard_normal(N_NOISE) if noise else np.zeros(N_NOISE)
            measure(self.sensors, self.errors, TARGET, self.plant, self.cycle, row, self.m)
            self.cycle, out[k] = self.cycle + 1, self.m
            self.plant["time"] += DT
        return out

    def put(self, north: float, east: float = 0.0, down: float = 2.0, heading: float = 0.0) -> "Suite":
        """Put the plant somewhere, deg."""
        self.plant["eta"] = north, east, down, 0.0, 0.0, np.radians(heading)
        return self
