"""Water, mass and hull of a vehicle as its file describes them: every field carries its unit in its name.

Body axes: x forward, y starboard, z down, origin O_b. Files use degrees; `physics.model` converts.
"""

from typing import Annotated, Literal

from pydantic import Field

from bumpless.config.declare import Choice, Number, Part, Row, Text, model
from bumpless.config.names import BODY, WRENCH
from bumpless.config.vehicle.published import PublishedCoefficients

Vector3 = tuple[float, float, float]
Wrench = tuple[float, ...]


@model
class Environment:
    """The water the vehicle's coefficients are stated for."""

    water_density_kgpm3: Annotated[float, Number("Density of the water", "kg/m³", above=0.0)]
    gravity_mps2: Annotated[float, Number("Acceleration of gravity", "m/s²", above=0.0)]


@model
class Mass:
    """Rigid body and buoyancy. Inertias are about the centre of gravity, along body axes."""

    mass_kg: Annotated[float, Number("Mass", "kg", above=0.0)]
    displaced_volume_m3: Annotated[float, Number("Displaced volume", "m³", above=0.0)]
    center_of_gravity_m: Annotated[Vector3, Row("Centre of gravity", "m", names=BODY)]
    center_of_buoyancy_m: Annotated[Vector3, Row("Centre of buoyancy", "m", names=BODY)]
    moments_of_inertia_kgm2: Annotated[
        Vector3, Row("Moments of inertia", "kg·m²", 1e-6, names=("I_xx", "I_yy", "I_zz"))
    ]
    product_of_inertia_xz_kgm2: Annotated[float, Number("Product of inertia I_xz", "kg·m²")] = 0.0


@model
class MyringHull:
    """A torpedo hull of Myring's form and what its drag and lift depend on.

    Source: Prestero 2001, section 3.1; Myring 1976.
    """

    kind: Annotated[Literal["myring"], Choice("Form of the hull")]
    diameter_m: Annotated[float, Number("Largest diameter", "m", above=0.0)]
    nose_length_m: Annotated[float, Number("a, length of the nose", "m", above=0.0)]
    nose_offset_m: Annotated[float, Number("a_offset, cut off in front", "m", 0.0)]
    middle_length_m: Annotated[float, Number("b, length of the cylinder", "m", 0.0)]
    tail_length_m: Annotated[float, Number("c, length of the tail", "m", above=0.0)]
    tail_offset_m: Annotated[float, Number("c_offset, cut off behind", "m", 0.0)]
    nose_exponent: Annotated[float, Number("n, exponent of the nose", "", above=0.0)]
    tail_half_angle_deg: Annotated[float, Number("θ, half angle of the tail", "deg", max=60.0, above=0.0)]
    nose_to_origin_m: Annotated[float, Number("From the nose tip back to O_b", "m", above=0.0)]
    skin_friction_coefficient: Annotated[
        float, Number("c_ss, skin friction on the wetted surface", "", max=0.1, above=0.0)
    ]
    cross_flow_drag_coefficient: Annotated[float, Number("c_dc of the hull's sections", "", 0.0, 3.0)]
    body_lift_slope_per_rad: Annotated[float, Number("c_ydb, body lift on diameter squared", "1/rad", 0.0)]
    body_lift_x_m: Annotated[float, Number("x_cp, where body lift acts", "m", help="In forward flow.")]
    linear_damping: Annotated[
        Wrench, Row("Linear damping, diagonal", "N·s/m or N·m·s", 0.0, names=WRENCH)
    ] = (0.0,) * 6
    coefficients: Annotated[
        PublishedCoefficients | None, Part("Published coefficients, in place of strip theory's")
    ] = None

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


@model
class TabulatedHull:
    """A body whose coefficients were measured: diagonals about O_b in wrench order X Y Z K M N."""

    kind: Annotated[Literal["tabulated"], Choice("Form of the hull")]
    size_m: Annotated[Vector3, Row("Bounding box", "m", 0.001, names=("length", "width", "height"))]
    added_mass: Annotated[Wrench, Row("Added mass", "kg or kg·m²", 0.0, names=WRENCH)]
    linear_damping: Annotated[Wrench, Row("Linear damping", "N·s/m or N·m·s", 0.0, names=WRENCH)]
    quadratic_damping: Annotated[Wrench, Row("Quadratic damping", "N·s²/m² or N·m·s²", 0.0, names=WRENCH)]

    @property
    def length_m(self) -> float:
        """Length of the bounding box."""
        return self.size_m[0]

    @property
    def diameter_m(self) -> float:
        """Height of the bounding box."""
        return self.size_m[2]


Hull = Annotated[MyringHull | TabulatedHull, Field(discriminator="kind")]


@model
class Appendage:
    """Something that sticks out of the hull and drags: drag area C_D A along each body axis."""

    name: Annotated[str, Text("Name", pattern=".+", form="must not be empty")]
    position_m: Annotated[Vector3, Row("Where it is", "m", names=BODY)]
    drag_area_m2: Annotated[Vector3, Row("Drag area along each axis", "m²", 0.0, names=BODY)]
