"""What may be scaled: thrust of each kind of screw, lift of each kind of fin, drag along and across the hull.

Actuators with the same numbers share a scale, for they are of one type: a flight tells more of all than of
each. Torque, fin drag and lag stay as the file says.
"""

from dataclasses import dataclass

import numpy as np

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.parts import Fin
from bumpless.physics.model import first_slots

THRUST, LIFT, DRAG_ALONG, DRAG_ACROSS = "thrust", "lift", "drag along", "drag across"
MODEL_FIELDS = {THRUST: ("T_nn", "T_nn_reverse", "T_nv"), LIFT: ("C_La",)}
PRIOR_STD = {
    THRUST: 0.15,
    LIFT: 0.3,
    DRAG_ALONG: 0.2,
    DRAG_ACROSS: 0.2,
}  # of what a new vehicle may differ by
DAMPING = ("D_linear", "D_quadratic", "D_lift")


@dataclass(frozen=True)
class Scale:
    """One number that all of the same kind are multiplied by; 1 as in the file."""

    what: str
    names: tuple[str, ...]  # of the actuators; empty for drag
    slots: tuple[int, ...]  # in u

    @property
    def title(self) -> str:
        """Such as "thrust of n_v1, n_v2"."""
        return f"{self.what} of {', '.join(self.names)}" if self.names else f"{self.what} the hull"

    @property
    def prior_std(self) -> float:
        """Standard deviation about 1 before anything was flown."""
        return PRIOR_STD[self.what]

    def applied(self, model: np.record, factor: float) -> np.record:
        """A copy of a MODEL record with this scale."""
        out = model.copy()
        if self.what in MODEL_FIELDS:
            for name in MODEL_FIELDS[self.what]:
                out[name][list(self.slots)] *= factor
            return out
        for name in DAMPING:
            along = out[name][0, 0]
            if self.what == DRAG_ALONG:
                out[name][0, 0] *= factor
            else:
                out[name] *= factor
                out[name][0, 0] = along
        return out


def scales_of(vehicle: Vehicle) -> list[Scale]:
    """The scales of a vehicle, actuators in the file's order."""
    slots, groups = first_slots(vehicle), dict[tuple[object, ...], list[str]]()
    for actuator in vehicle.actuators:
        if isinstance(actuator, Fin):
            key = (LIFT, actuator.lift_slope_per_rad, actuator.planform_area_m2)
        else:
            alike = (actuator.thrust_coefficient, actuator.thrust_slope, actuator.diameter_m)
            key = (THRUST, actuator.kind, *alike)
        groups.setdefault(key, []).append(actuator.name)
    found = [
        Scale(str(key[0]), tuple(names), tuple(slots[name] for name in names))
        for key, names in groups.items()
    ]
    return [*found, Scale(DRAG_ALONG, (), ()), Scale(DRAG_ACROSS, (), ())]
