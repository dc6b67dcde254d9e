"""A dock to enter, and how a hung dock moves; what is left out is not there.

The dock's axis is horizontal, along the target's heading, through the marker, which hangs behind its end: the
vehicle sees it through funnel and tube until it is captured.
"""

from typing import Annotated

from bumpless.config.declare import Number, Row, model
from bumpless.config.mission.notes import Vector3
from bumpless.config.names import NED


@model
class Dock:
    """A funnel with a tube behind it, solid outside and inside, with a stop at its end and a latch.

    Contact: F = k δ (1 + c δ') and Coulomb's friction, at points of the hull.
    Source: Hunt and Crossley 1975.
    """

    entry_before_marker_m: Annotated[
        float, Number("From the middle of the entry to the marker", "m", 0.1, 50.0)
    ]
    entry_radius_m: Annotated[float, Number("Inner radius of the funnel at the entry", "m", 0.02, 20.0)]
    tube_radius_m: Annotated[float, Number("Inner radius of the tube", "m", 0.02, 20.0)]
    cone_length_m: Annotated[float, Number("Length of the funnel", "m", 0.02, 20.0)]
    tube_length_m: Annotated[float, Number("From the funnel to the stop", "m", 0.02, 20.0)]
    capture_depth_m: Annotated[
        float, Number("Where the latch closes", "m", 0.02, 40.0, help="Depth of the nose behind the entry.")
    ]
    wall_m: Annotated[float, Number("Thickness of the wall", "m", 0.005, 1.0)] = 0.05
    stiffness_npm: Annotated[
        float, Number("k, stiffness of one contact", "N/m", 10.0, 20000.0, help="Points of the hull touch.")
    ] = 5000.0
    damping_spm: Annotated[float, Number("c, damping of a contact", "s/m", 0.0, 50.0)] = 1.5
    friction: Annotated[float, Number("μ, coefficient of friction", "", 0.0, 2.0)] = 0.2
    slip_speed_mps: Annotated[
        float, Number("Slip below which friction fades", "m/s", 0.001, 1.0, help="So that it stays smooth.")
    ] = 0.01
    force_most_n: Annotated[
        float,
        Number("Contact force that dock and hull bear", "N", 1.0, 1e6, help="More is a collision."),
    ] = 300.0

    @property
    def length_m(self) -> float:
        """From the entry to the stop."""
        return self.cone_length_m + self.tube_length_m


@model
class Motion:
    """Heave and sway of a hung dock with its marker: a sine about the place of the target."""

    amplitude_ned_m: Annotated[Vector3, Row("Amplitude", "m", -10.0, 10.0, names=NED)]
    period_s: Annotated[float, Number("Period", "s", 1.0, 1e4)]
    phase_deg: Annotated[float, Number("Phase at the start", "deg", -360.0, 360.0)] = 0.0
