"""The sea of a mission: currents, waves, water; what is left out is not there."""

import math
from typing import Annotated

from bumpless.config.capacity import MAX_PROFILE
from bumpless.config.declare import Entries, Number, Part, Row, Switch, model
from bumpless.config.mission.notes import Vector3, Vector6, direction, flow
from bumpless.config.names import WRENCH


@model
class CurrentVariation:
    """First-order Gauss-Markov variation added to each horizontal component of the current."""

    std_mps: Annotated[float, Number("Standard deviation", "m/s", 0.0, 2.0)]
    time_constant_s: Annotated[float, Number("Correlation time", "s", 0.1, 1e5)]


@model
class CurrentAtDepth:
    """What is added to the current at a depth."""

    depth_m: Annotated[float, Number("Depth", "m", 0.0, 11000.0)]
    current_ned_mps: Annotated[Vector3, flow("Current, added to the mean")]


@model
class Shelter:
    """A wake behind the target's dock: dead water that mixes with the current, and eddies in it.

    Source: Bastankhah and Porté-Agel 2014.
    """

    width_m: Annotated[float, Number("Width of the dock across the current", "m", 0.05, 100.0)]
    drag_coefficient: Annotated[
        float, Number("Drag coefficient of the dock", "", 0.0, 3.0, help="On its area across the current.")
    ] = 1.0
    growth: Annotated[float, Number("Growth of the wake's half width per metre downstream", "", 0.0, 1.0)] = (
        0.05
    )
    turbulence: Annotated[float, Number("Eddies, as a share of the current taken away", "", 0.0, 2.0)] = 0.0


@model
class Wave:
    """A regular deep-water wave whose orbital motion decays with depth."""

    height_m: Annotated[float, Number("Height from trough to crest", "m", 0.0, 20.0)]
    period_s: Annotated[float, Number("Period", "s", 1.0, 60.0)]
    direction_deg: Annotated[float, direction("Heading towards which it travels")] = 0.0
    second_order: Annotated[
        bool, Switch("Suction towards the surface", help="The mean force of second order in the height.")
    ] = False

    @property
    def length_m(self) -> float:
        """From crest to crest in deep water."""
        return 9.80665 * self.period_s**2 / math.tau


@model
class Environment:
    """What acts on the vehicle besides itself."""

    current_ned_mps: Annotated[Vector3, flow("Current, the way it flows")] = (0.0, 0.0, 0.0)
    current_variation: Annotated[CurrentVariation | None, Part("Slow change of the current")] = None
    wave: Annotated[Wave | None, Part("Wave")] = None
    disturbance_body_n_nm: Annotated[
        Vector6, Row("Constant disturbance τ_e in body axes", "N or N·m", -1e4, 1e4, names=WRENCH)
    ] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    current_profile: Annotated[
        tuple[CurrentAtDepth, ...],
        Entries("Change of the current with depth", most=MAX_PROFILE,
                help="Depths ascending; linear between them, constant beyond."),
    ] = ()  # fmt: skip
    shelter: Annotated[Shelter | None, Part("Wake of the dock")] = None
    water_depth_m: Annotated[
        float,
        Number("Depth of the bottom", "m", 0.0, 11000.0, help="0: always within reach of the Doppler log."),
    ] = 0.0  # fmt: skip
    beam_attenuation_per_m: Annotated[
        float,
        Number("Turbidity: beam attenuation of the water", "1/m", 0.0, 50.0,
               help="0: clear; a harbour has 1 to 5."),
    ] = 0.0  # fmt: skip
