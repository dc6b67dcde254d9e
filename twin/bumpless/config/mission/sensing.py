"""What a mission changes of the vehicle's sensors, and fits besides; what is left out stays as it is."""

from typing import Annotated

from bumpless.config.capacity import MAX_OUTAGES
from bumpless.config.declare import Entries, Number, Part, Switch, model
from bumpless.config.mission.notes import moment
from bumpless.config.vehicle.sensors import NearCamera, Usbl


@model
class Detection:
    """What this mission changes of the vehicle's target camera; what is left out stays."""

    range_max_m: Annotated[float | None, Number("Farthest detection", "m", 0.1, 200.0)] = None
    field_of_view_half_deg: Annotated[float | None, Number("Half angle of view", "deg", 1.0, 90.0)] = None
    dropout_probability: Annotated[float | None, Number("Share of frames missed", "", 0.0, 1.0)] = None
    latency_s: Annotated[float | None, Number("From a frame to its sight", "s", 0.0, 5.0)] = None
    outlier_probability: Annotated[
        float | None, Number("Share of frames with a false sight", "", 0.0, 1.0)
    ] = None
    marker_angle_max_deg: Annotated[
        float | None, Number("Farthest off the marker's normal", "deg", 1.0, 180.0)
    ] = None


@model
class InsChange:
    """What this mission changes of the inertial navigation."""

    heading_bias_deg: Annotated[float | None, Number("Bias of the heading", "deg", 0.0, 90.0)] = None
    roll_pitch_bias_deg: Annotated[float | None, Number("Bias of roll and pitch", "deg", 0.0, 20.0)] = None
    heading_drift_degprth: Annotated[
        float | None, Number("Drift of the heading, a random walk", "deg/√h", 0.0, 1000.0)
    ] = None


@model
class DvlChange:
    """What this mission changes of the Doppler log."""

    dropout_probability: Annotated[float | None, Number("Share of pings missed", "", 0.0, 1.0)] = None
    scale_error: Annotated[float | None, Number("Error of scale, as a share", "", 0.0, 0.5)] = None
    water_bias_mps: Annotated[
        float | None, Number("Bias of the velocity through water, each axis", "m/s", 0.0, 1.0)
    ] = None
    altitude_min_m: Annotated[float | None, Number("Least altitude of bottom track", "m", 0.0, 1e4)] = None
    altitude_max_m: Annotated[float | None, Number("Greatest altitude of bottom track", "m", 0.0, 1e4)] = None


@model
class Outage:
    """A time in which the target isn't seen, whatever the geometry."""

    from_s: Annotated[float, moment("Begin")]
    to_s: Annotated[float, moment("End")]


@model
class DvlOutage:
    """A time in which the Doppler log doesn't track the bottom, whatever the altitude."""

    from_s: Annotated[float, moment("Begin")]
    to_s: Annotated[float, moment("End")]
    water_track: Annotated[bool, Switch("The water is still tracked")] = True


@model
class Sensors:
    """What this mission changes of the vehicle's sensors."""

    noise_scale: Annotated[
        float, Number("Factor on every noise of the vehicle file; 0 is none", "", 0.0, 20.0)
    ] = 1.0
    detection: Annotated[Detection | None, Part("Target camera")] = None
    outages: Annotated[tuple[Outage, ...], Entries("Times without the target", most=MAX_OUTAGES)] = ()
    ins: Annotated[InsChange | None, Part("Inertial navigation")] = None
    dvl: Annotated[DvlChange | None, Part("Doppler log")] = None
    dvl_outages: Annotated[
        tuple[DvlOutage, ...], Entries("Times without bottom track", most=MAX_OUTAGES)
    ] = ()
    near_camera: Annotated[NearCamera | None, Part("A second camera, for close range")] = None
    usbl: Annotated[Usbl | None, Part("A USBL for homing")] = None
