"""How a drawn vehicle differs from its file: changes of the true plant, unknown to the autopilot."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Self

import numpy as np


@dataclass(frozen=True)
class Alteration:
    """Callable as `alter` of `simulate`; the defaults change nothing. Units as in `quantities`."""

    mass: float = 1.0
    net_buoyancy_n: float = 0.0
    ballast_n: float = 0.0
    ballast_x_m: float = 0.0
    trim_x_m: float = 0.0
    trim_y_m: float = 0.0
    drag_axial: float = 1.0
    drag_cross: float = 1.0
    lag: float = 1.0
    rate: float = 1.0
    fin_slew: float = 1.0
    fin_lift: float = 1.0
    thrust: float = 1.0

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Self:
        """From a draw; what is no property of the vehicle is left out."""
        return cls(**{f.name: values[f.name] for f in fields(cls) if f.name in values})

    def __call__(self, model: Any, truth: Any) -> None:
        """Change the MODEL record of the true plant in place."""
        self._weigh(model)
        model["r_b"][0] += self.trim_x_m
        model["r_b"][1] += self.trim_y_m
        model["buoyancy"] += self.net_buoyancy_n
        for name in ("D_linear", "D_quadratic", "D_lift"):
            axial = model[name][0, 0]
            model[name] *= self.drag_cross
            model[name][0, 0] = axial * self.drag_axial
        model["time_constant"] *= self.lag
        model["command_rate"] *= self.rate
        model["command_rate"][model["C_La"] > 0.0] *= self.fin_slew
        for name in ("T_nn", "T_nn_reverse", "T_nv"):
            model[name] *= self.thrust
        model["C_La"] *= self.fin_lift

    def _weigh(self, model: Any) -> None:
        """More mass in trim, then a point weight ahead of O_b. Source: Fossen 2021, eq. (3.49)."""
        if self.mass == 1.0 and self.ballast_n == 0.0:
            return
        for name in ("M_RB", "weight", "buoyancy"):
            model[name] *= self.mass
        gravity = model["weight"] / model["M_RB"][0, 0]
        m, x = self.ballast_n / gravity, self.ballast_x_m
        added = np.diag([m, m, m, 0.0, m * x * x, m * x * x])
        added[1, 5] = added[5, 1] = m * x
        added[2, 4] = added[4, 2] = -m * x
        before = model["weight"] * model["r_g"]
        model["M_RB"] += added
        model["weight"] += self.ballast_n
        model["r_g"] = (before + self.ballast_n * np.array([x, 0.0, 0.0])) / model["weight"]
        model["M_inv"] = np.linalg.inv(model["M_RB"] + model["M_A"])
