"""Where the things are that cameras and rulers know."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Places:
    """What a preset must hold, NED in m; heading in rad."""

    vehicle: np.ndarray = field(default_factory=lambda: np.zeros(3))
    heading: float = 0.0
    path: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    target: np.ndarray | None = None
    target_heading: float = 0.0
    observation: np.ndarray | None = None
