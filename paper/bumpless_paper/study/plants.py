"""The plants on which a claim must hold: a stated distribution, drawn by number.

`DISTRIBUTION` and the wider `WIDE` are the statements; `draw(i)` gives plant i, always the same. A `Plant`
changes the true vehicle and its sea; the autopilot flies every plant with one set of parameters and one
nominal model, and is told no more than where it starts and, in S6, the fault. Source of the ranges: issue
"True", "Not at one lucky point"; the ends of trim, buoyancy, lag and fault are ours, and so are those that
only WIDE draws. What the allocator would have to know, `thrust` and `fin_lift`, is among these.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from bumpless.campaign.plant import Alteration


@dataclass(frozen=True)
class Spread:
    """One uncertain number: uniform between two ends, or log-uniform for a scale factor."""

    low: float
    high: float
    unit: str
    about: str
    logarithmic: bool = False

    def at(self, share: float) -> float:
        """The number at a share of the range, 0 to 1."""
        if self.logarithmic:
            return float(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share


DISTRIBUTION: dict[str, Spread] = {
    "current_along": Spread(-0.15, 0.15, "m/s", "current along the path, positive from astern"),
    "current_across": Spread(-0.15, 0.15, "m/s", "current across the path, positive to starboard"),
    "trim_x": Spread(-0.0005, 0.0005, "m", "centre of buoyancy fore-aft; 0.5 mm pitches the hull by 2.9 deg"),
    "trim_y": Spread(-0.0005, 0.0005, "m", "centre of buoyancy athwart; 0.5 mm rolls the hull by 2.9 deg"),
    "net_buoyancy": Spread(-0.3, 0.3, "N", "buoyancy minus weight; both verticals together give 1.17 N"),
    "drag_axial": Spread(0.7, 1.3, "1", "factor on surge damping"),
    "drag_cross": Spread(0.7, 1.3, "1", "factor on every other damping and body lift term"),
    "lag": Spread(0.5, 2.0, "1", "factor on every actuator's time constant", logarithmic=True),
    "noise": Spread(0.5, 4.0, "1", "factor on every sensor's noise", logarithmic=True),
    "fault_time": Spread(30.0, 55.0, "s", "of the propeller's fault in S5 and S6"),
    "fault_effectiveness": Spread(0.2, 0.7, "1", "what the fault leaves of the propeller"),
}

# A second distribution, beside the first so that published goals stay comparable: the allocator's own map is
# never exact on these plants, and the sensors have an offset.
WIDE: dict[str, Spread] = DISTRIBUTION | {
    "fin_slew": Spread(0.3, 1.5, "1", "factor on the fins' fastest deflection", logarithmic=True),
    "fin_lift": Spread(
        0.5, 1.1, "1", "factor on the fins' lift; thin-wing theory for their aspect ratio: 0.5"
    ),
    "thrust": Spread(0.8, 1.15, "1", "factor on every screw's thrust, forwards, backwards and with inflow"),
    "heading_bias": Spread(-0.0175, 0.0175, "rad", "offset of the compass; 1 deg"),
    "depth_bias": Spread(-0.05, 0.05, "m", "offset of the depth sensor"),
}


@dataclass(frozen=True)
class Plant:
    """One drawn plant; the defaults are the vehicle file's own. Callable as `alter` of `simulate`."""

    number: int = -1
    current_along: float = 0.0
    current_across: float = 0.0
    trim_x: float = 0.0
    trim_y: float = 0.0
    net_buoyancy: float = 0.0
    drag_axial: float = 1.0
    drag_cross: float = 1.0
    lag: float = 1.0
    noise: float = 1.0
    fault_time: float | None = None
    fault_effectiveness: float | None = None
    fault_actuator: int | None = None  # another than the mission's
    thrust: float = 1.0
    fin_lift: float = 1.0
    fin_slew: float = 1.0
    heading_bias: float = 0.0
    depth_bias: float = 0.0

    def __call__(self, model: Any, truth: Any) -> None:
        """Change the records of the true plant and of the flight's truth in place."""
        c, s = np.cos(truth["target"][3]), np.sin(truth["target"][3])
        along, across = self.current_along, self.current_across
        truth["environment"]["current"][:2] += [along * c - across * s, along * s + across * c]
        self._start_in_trim(truth)
        truth["errors"]["noise_scale"] *= self.noise
        faults = truth["faults"]
        if faults["n"] > 0 and self.fault_time is not None:
            faults["time"][0] = self.fault_time
        if faults["n"] > 0 and self.fault_effectiveness is not None:
            faults["effectiveness"][0] = self.fault_effectiveness
        if faults["n"] > 0 and self.fault_actuator is not None:
            faults["actuator"][0] = self.fault_actuator
        Alteration(
            net_buoyancy_n=self.net_buoyancy,
            trim_x_m=self.trim_x,
            trim_y_m=self.trim_y,
            drag_axial=self.drag_axial,
            drag_cross=self.drag_cross,
            lag=self.lag,
            fin_lift=self.fin_lift,
            thrust=self.thrust,
            fin_slew=self.fin_slew,
        )(model, truth)
        truth["errors"]["heading_bias"] += self.heading_bias / self.noise
        truth["errors"]["depth_bias"] += self.depth_bias / self.noise

    def _start_in_trim(self, truth: Any) -> None:
        """Start along the first leg, the bow already turned into the current that crosses it."""
        if truth["start_speed"] > 0.0:
            truth["start"][5] -= np.arcsin(np.clip(self.current_across / truth["start_speed"], -0.5, 0.5))

    def as_dict(self) -> dict[str, float | None]:
        """For JSON."""
        return asdict(self)


NOMINAL = Plant()


def draw(number: int, spreads: Mapping[str, Spread] = DISTRIBUTION) -> Plant:
    """Plant `number` of a distribution: independent uniform shares from its own random stream.

    What both distributions name is drawn alike: WIDE's plant i is DISTRIBUTION's, and more.
    """
    shares = np.random.Generator(np.random.PCG64([20260514, number])).random(len(spreads))
    values: dict[str, Any] = {
        name: spread.at(float(x)) for (name, spread), x in zip(spreads.items(), shares, strict=True)
    }
    return Plant(number=number, **values)
