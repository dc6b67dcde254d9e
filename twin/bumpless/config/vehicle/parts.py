"""The parts of a vehicle as its file describes them: every field carries its unit in its name.

Body axes: x forward, y starboard, z down, origin O_b. Files use degrees and rpm; `physics.model` converts.
"""

import math
from dataclasses import dataclass

from bumpless.config.vehicle.fields import choice, number, text, vector


@dataclass(frozen=True)
class Environment:
    """The water the vehicle's coefficients are stated for."""

    water_density_kgpm3: float = number(above=0)
    gravity_mps2: float = number(above=0)


@dataclass(frozen=True)
class Mass:
    """Rigid body and buoyancy. Inertias are about the centre of gravity, along body axes."""

    mass_kg: float = number(above=0)
    displaced_volume_m3: float = number(above=0)
    center_of_gravity_m: tuple[float, float, float] = vector(3)
    center_of_buoyancy_m: tuple[float, float, float] = vector(3)
    moments_of_inertia_kgm2: tuple[float, float, float] = vector(3, low=1e-6)  # I_xx, I_yy, I_zz
    product_of_inertia_xz_kgm2: float = number(default=0.0)


@dataclass(frozen=True)
class MyringHull:
    """A torpedo hull of Myring's form and what its drag and lift depend on.

    Source: Prestero 2001, section 3.1; Myring 1976.
    """

    kind: str = choice("myring")
    diameter_m: float = number(above=0)
    nose_length_m: float = number(above=0)  # a
    nose_offset_m: float = number(low=0)  # a_offset: cut off in front
    middle_length_m: float = number(low=0)  # b
    tail_length_m: float = number(above=0)  # c
    tail_offset_m: float = number(low=0)  # c_offset: cut off behind
    nose_exponent: float = number(above=0)  # n
    tail_half_angle_deg: float = number(above=0, high=60)  # theta
    nose_to_origin_m: float = number(above=0)  # from the nose tip back to O_b
    skin_friction_coefficient: float = number(above=0, high=0.1)  # c_ss on the wetted surface
    cross_flow_drag_coefficient: float = number(low=0, high=3)  # c_dc of the hull's sections
    body_lift_slope_per_rad: float = number(low=0)  # c_ydb, on diameter squared
    body_lift_x_m: float = number()  # where body lift acts in forward flow, x_cp
    linear_damping: tuple[float, ...] = vector(6, low=0, default=(0.0,) * 6)  # N s/m | N m s, diagonal

    @property
    def length_m(self) -> float:
        """Overall length, both ends as cut."""
        return (
            self.nose_length_m
            - self.nose_offset_m
            + self.middle_length_m
            + self.tail_length_m
            - self.tail_offset_m
        )


@dataclass(frozen=True)
class TabulatedHull:
    """A body whose coefficients were measured: diagonals about O_b in wrench order X Y Z K M N."""

    kind: str = choice("tabulated")
    size_m: tuple[float, float, float] = vector(3, low=0.001)  # bounding box: length, width, height
    added_mass: tuple[float, ...] = vector(6, low=0)  # kg | kg m^2
    linear_damping: tuple[float, ...] = vector(6, low=0)  # N s/m | N m s
    quadratic_damping: tuple[float, ...] = vector(6, low=0)  # N s^2/m^2 | N m s^2

    @property
    def length_m(self) -> float:
        """Length of the bounding box."""
        return self.size_m[0]

    @property
    def diameter_m(self) -> float:
        """Height of the bounding box."""
        return self.size_m[2]


Hull = MyringHull | TabulatedHull


@dataclass(frozen=True)
class Appendage:
    """Something that sticks out of the hull and drags: drag area C_D A along each body axis."""

    name: str = text()
    position_m: tuple[float, float, float] = vector(3)
    drag_area_m2: tuple[float, float, float] = vector(3, low=0)


@dataclass(frozen=True)
class Command:
    """One number that an actuator is told: one entry of u, one row on the screen."""

    name: str
    actuator: str  # whose it is
    unit: str  # "deg" or "rpm"
    lower: float  # bounds in `unit`
    upper: float


@dataclass(frozen=True)
class Fin:
    """A rudder on a radial stock. delta > 0 lifts along e_L = [0, cos lambda, sin lambda] in forward flow,

    with lambda = radial_direction_deg + 90.

    Source: Gao et al. 2026, eqs. (13)-(20).
    """

    name: str = text()
    kind: str = choice("fin")
    x_m: float = number()
    arm_m: float = number(above=0)  # from the x axis to where lift acts
    radial_direction_deg: float = number()  # of the stock, from +y towards +z
    planform_area_m2: float = number(above=0)
    span_m: float = number(above=0)
    chord_m: float = number(above=0)  # mean
    deflection_max_deg: float = number(above=0, high=60)
    deflection_rate_degps: float = number(above=0)
    time_constant_s: float = number(above=0)
    lift_slope_per_rad: float = number(above=0)
    drag_coefficient_zero: float = number(low=0)
    drag_rise_per_rad2: float = number(low=0)
    stall_angle_deg: float = number(above=0, high=60)
    reverse_lift_share: float = number(low=0, high=1)
    cross_flow_drag_coefficient: float = number(low=0, high=3)  # c_df, flow across the plate

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


@dataclass(frozen=True)
class Screw:
    """What every screw has; K_T and K_Q fall linearly with the advance ratio.

    Source: Gao et al. 2026, eqs. (8)-(12).
    """

    name: str = text()
    position_m: tuple[float, float, float] = vector(3)
    diameter_m: float = number(above=0)
    thrust_coefficient: float = number(above=0)  # K_T at J = 0
    thrust_slope: float = number(low=0)  # -dK_T/dJ
    torque_coefficient: float = number(low=0)  # K_Q at J = 0
    torque_slope: float = number(low=0)  # -dK_Q/dJ
    reverse_thrust_share: float = number(low=0, high=1)  # K_T at n < 0 over K_T at n > 0
    wake_fraction: float = number(low=0, high=0.9)  # V_A = (1 - w) times the flow along the thrust
    hand: str = choice("right", "left", "balanced")  # balanced: no torque reaches the hull
    shaft_speed_min_rpm: float = number(high=0)
    shaft_speed_max_rpm: float = number(above=0)
    shaft_acceleration_rpmps: float = number(above=0)
    time_constant_s: float = number(above=0)


@dataclass(frozen=True)
class Thruster(Screw):
    """A screw that pushes along `direction`."""

    kind: str = choice("thruster")
    direction: tuple[float, float, float] = vector(3)  # normalised on use

    @property
    def commands(self) -> tuple[Command, ...]:
        """The shaft speed."""
        return (Command(self.name, self.name, "rpm", self.shaft_speed_min_rpm, self.shaft_speed_max_rpm),)


@dataclass(frozen=True)
class Azimuth(Screw):
    """A screw in a pod that turns: at the angle 0 it pushes along x_b, at +90 deg along y_b."""

    kind: str = choice("azimuth")
    angle_max_deg: float = number(above=0, high=180)  # to either side
    angle_rate_degps: float = number(above=0)
    angle_time_constant_s: float = number(above=0)

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


Actuator = Fin | Thruster | Azimuth
ACTUATORS = {"fin": Fin, "thruster": Thruster, "azimuth": Azimuth}  # by their name in a vehicle file
