"""The actuators of a vehicle as its file describes them: every field carries its unit in its name.

A new kind is a class under `@model` with a `kind` of its own word, and its name in `Actuator` below. Reader,
schema, catalogue and reference then know it. The class must also have `commands`, `position_m` and
`direction`. What it does is told to `bumpless.physics.actuators`; the way: docs/add_actuator_kind.md.

Body axes: x forward, y starboard, z down, origin O_b. Files use degrees and rpm; each kind's `fill` converts.
"""

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from bumpless.config.declare import Choice, Number, Part, Row, Text, model
from bumpless.config.names import BODY
from bumpless.config.vehicle.body import Appendage as Appendage
from bumpless.config.vehicle.body import Environment as Environment
from bumpless.config.vehicle.body import Hull as Hull
from bumpless.config.vehicle.body import Mass as Mass
from bumpless.config.vehicle.body import MyringHull as MyringHull
from bumpless.config.vehicle.body import TabulatedHull as TabulatedHull
from bumpless.config.vehicle.flow import ScrewFlow, Wash


def actuator_name() -> Text:
    """The name by which missions, messages and screens know an actuator."""
    return Text("Name", pattern=".+", form="must not be empty")


@dataclass(frozen=True)
class Command:
    """One number that an actuator is told: one entry of u, one row on the screen."""

    name: str
    actuator: str  # whose it is
    unit: str  # "deg" or "rpm"
    lower: float  # bounds in `unit`
    upper: float


@model
class Fin:
    """A rudder on a radial stock. delta > 0 lifts along e_L = [0, cos lambda, sin lambda] in forward flow,

    with lambda = radial_direction_deg + 90.

    Source: Gao et al. 2026, eqs. (13)-(20).
    """

    name: Annotated[str, actuator_name()]
    kind: Annotated[Literal["fin"], Choice("Kind of actuator")]
    x_m: Annotated[float, Number("Where lift acts along x", "m")]
    arm_m: Annotated[float, Number("From the x axis to where lift acts", "m", above=0.0)]
    radial_direction_deg: Annotated[float, Number("Direction of the stock, from +y towards +z", "deg")]
    planform_area_m2: Annotated[float, Number("Planform area", "m²", above=0.0)]
    span_m: Annotated[float, Number("Span", "m", above=0.0)]
    chord_m: Annotated[float, Number("Mean chord", "m", above=0.0)]
    deflection_max_deg: Annotated[float, Number("Largest deflection", "deg", max=60.0, above=0.0)]
    deflection_rate_degps: Annotated[float, Number("Fastest change of the deflection", "deg/s", above=0.0)]
    time_constant_s: Annotated[float, Number("Time constant", "s", above=0.0)]
    lift_slope_per_rad: Annotated[float, Number("Slope of the lift coefficient", "1/rad", above=0.0)]
    drag_coefficient_zero: Annotated[float, Number("Drag coefficient without lift", "", 0.0)]
    drag_rise_per_rad2: Annotated[float, Number("Rise of the drag coefficient", "1/rad²", 0.0)]
    stall_angle_deg: Annotated[float, Number("Angle of stall", "deg", max=60.0, above=0.0)]
    reverse_lift_share: Annotated[float, Number("Share of the lift in reversed flow", "", 0.0, 1.0)]
    cross_flow_drag_coefficient: Annotated[float, Number("c_df, of flow across the plate", "", 0.0, 3.0)]
    wash: Annotated[Wash | None, Part("Stream of a screw", help="With a mission's `actuator_flow`.")] = None

    @property
    def position_m(self) -> tuple[float, float, float]:
        """Where lift acts, in body axes."""
        a = math.radians(self.radial_direction_deg)
        return (self.x_m, self.arm_m * math.cos(a), self.arm_m * math.sin(a))

    @property
    def direction(self) -> tuple[float, float, float]:
        """Unit lift direction e_L in body axes."""
        a = math.radians(self.radial_direction_deg + 90.0)
        return (0.0, math.cos(a), math.sin(a))

    @property
    def commands(self) -> tuple[Command, ...]:
        """The deflection."""
        limit = self.deflection_max_deg
        return (Command(self.name, self.name, "deg", -limit, limit),)


FLOW = Part("What flow does to it", help="With a mission's `actuator_flow`.")


@model
class Screw:
    """What every screw has; K_T and K_Q fall linearly with the advance ratio.

    Source: Gao et al. 2026, eqs. (8)-(12).
    """

    name: Annotated[str, actuator_name()]
    kind: Annotated[str, Text("Kind of actuator")]
    position_m: Annotated[tuple[float, float, float], Row("Where it is", "m", names=BODY)]
    diameter_m: Annotated[float, Number("Diameter", "m", above=0.0)]
    thrust_coefficient: Annotated[float, Number("K_T at J = 0", "", above=0.0)]
    thrust_slope: Annotated[float, Number("-dK_T/dJ", "", 0.0)]
    torque_coefficient: Annotated[float, Number("K_Q at J = 0", "", 0.0)]
    torque_slope: Annotated[float, Number("-dK_Q/dJ", "", 0.0)]
    reverse_thrust_share: Annotated[
        float, Number("Share of the thrust backwards", "", 0.0, 1.0, help="K_T at n < 0 over K_T at n > 0.")
    ]
    wake_fraction: Annotated[
        float,
        Number("w, wake fraction", "", 0.0, 0.9, help="V_A = (1 - w) times the flow along the thrust."),
    ]
    hand: Annotated[
        Literal["right", "left", "balanced"],
        Choice("Hand of the screw", help="balanced: no torque reaches the hull."),
    ]
    shaft_speed_min_rpm: Annotated[float, Number("Fastest backwards", "rpm", max=0.0)]
    shaft_speed_max_rpm: Annotated[float, Number("Fastest forwards", "rpm", above=0.0)]
    shaft_acceleration_rpmps: Annotated[
        float, Number("Fastest change of the shaft speed", "rpm/s", above=0.0)
    ]
    time_constant_s: Annotated[float, Number("Time constant", "s", above=0.0)]


@model
class Thruster(Screw):
    """A screw that pushes along `direction`."""

    kind: Annotated[Literal["thruster"], Choice("Kind of actuator")]
    direction: Annotated[
        tuple[float, float, float],
        Row("Where positive thrust pushes", names=BODY, nonzero=True, help="Normalised on use."),
    ]
    flow: Annotated[ScrewFlow | None, FLOW] = None

    @property
    def commands(self) -> tuple[Command, ...]:
        """The shaft speed."""
        return (Command(self.name, self.name, "rpm", self.shaft_speed_min_rpm, self.shaft_speed_max_rpm),)


@model
class Azimuth(Screw):
    """A screw in a pod that turns: at the angle 0 it pushes along x_b, at +90 deg along y_b."""

    kind: Annotated[Literal["azimuth"], Choice("Kind of actuator")]
    angle_max_deg: Annotated[float, Number("Largest angle, to either side", "deg", max=180.0, above=0.0)]
    angle_rate_degps: Annotated[float, Number("Fastest change of the angle", "deg/s", above=0.0)]
    angle_time_constant_s: Annotated[float, Number("Time constant of the angle", "s", above=0.0)]
    flow: Annotated[ScrewFlow | None, FLOW] = None

    @property
    def direction(self) -> tuple[float, float, float]:
        """Unit vector of thrust at the angle 0, in body axes."""
        return (1.0, 0.0, 0.0)

    @property
    def commands(self) -> tuple[Command, ...]:
        """The shaft speed, then the angle."""
        speed, angle, limit = f"{self.name}_speed", f"{self.name}_angle", self.angle_max_deg
        return (
            Command(speed, self.name, "rpm", self.shaft_speed_min_rpm, self.shaft_speed_max_rpm),
            Command(angle, self.name, "deg", -limit, limit),
        )


Actuator = Annotated[Fin | Thruster | Azimuth, Field(discriminator="kind")]
