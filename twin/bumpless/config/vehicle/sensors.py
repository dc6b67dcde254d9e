"""The sensors of a vehicle as its file describes them: noise is one standard deviation of white noise.

What is left out is perfect or not there: no latency, no false sights, a marker seen from anywhere.
"""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, Part, Row, model
from bumpless.config.names import BODY

FieldOfView = Literal["angles", "rectangle", "cone"]


def noise(label: str, unit: str, record: str) -> Number:
    """A standard deviation."""
    return Number(label, unit, 0.0, record=record)


def bias(label: str, unit: str, record: str) -> Number:
    """A constant error, drawn anew for each run."""
    return Number(label, unit, 0.0, record=record, help="Constant in a run, drawn with this deviation.")


def rate() -> Number:
    """How often a sensor measures."""
    return Number("Measurements a second", "Hz", above=0.0)


def share(label: str, record: str = "") -> Number:
    """A probability."""
    return Number(label, "", 0.0, 1.0, record=record)


def place(record: str, most: float | None = None) -> Row:
    """Where a sensor is on the hull, no farther than `most` m off along each axis."""
    least = None if most is None else -most
    return Row("Place in body axes", "m", least, most, names=BODY, record=record)


def axis(i: int) -> Number:
    """Where camera i looks."""
    return Number("Optical axis below x_b", "deg", -90.0, 90.0, record=f"camera_pitch[{i}]")


def half_vertical(i: int) -> Number:
    """How far up and down camera i sees."""
    return Number("Half angle of view up and down", "deg", 0.0, 90.0, record=f"camera_half_vertical[{i}]",
                  help="0: as across. A cone has one angle only.")  # fmt: skip


def form(i: int) -> Choice:
    """Of the field of view of camera i."""
    return Choice("Form of the field of view", record=f"camera_shape[{i}]",
                  help="Limits on bearing and elevation, a pinhole's rectangle, a round window.")  # fmt: skip


@model
class Ins:
    """Inertial navigation: attitude and body rates, at the control rate."""

    roll_pitch_noise_deg: Annotated[float, noise("Noise of roll and pitch", "deg", "roll_pitch_std")]
    heading_noise_deg: Annotated[float, noise("Noise of the heading", "deg", "heading_std")]
    rate_noise_degps: Annotated[float, noise("Noise of the body rates", "deg/s", "rate_std")]
    heading_bias_deg: Annotated[float, bias("Bias of the heading", "deg", "heading_bias_std")] = 0.0
    roll_pitch_bias_deg: Annotated[float, bias("Bias of roll and pitch", "deg", "roll_pitch_bias_std")] = 0.0
    heading_drift_degprth: Annotated[
        float,
        Number("Drift of the heading, a random walk", "deg/√h", 0.0,
               help="Its deviation after an hour. Source: IEEE Std 952."),
    ] = 0.0  # fmt: skip


@model
class Dvl:
    """Doppler log: velocity over ground, and through water by water track, in body axes."""

    rate_hz: Annotated[float, rate()]
    ground_velocity_noise_mps: Annotated[float, noise("Noise of the velocity over ground", "m/s", "dvl_std")]
    water_velocity_noise_mps: Annotated[
        float, noise("Noise of the velocity through water", "m/s", "dvl_water_std")
    ]
    dropout_probability: Annotated[float, share("Share of pings missed")]
    scale_error: Annotated[float, bias("Error of scale, as a share", "", "dvl_scale_std")] = 0.0
    water_bias_mps: Annotated[
        float, bias("Bias of the velocity through water, each axis", "m/s", "dvl_water_bias_std")
    ] = 0.0
    altitude_min_m: Annotated[
        float, Number("Least altitude of bottom track", "m", 0.0, record="dvl_altitude_min")
    ] = 0.0
    altitude_max_m: Annotated[
        float,
        Number("Greatest altitude of bottom track", "m", 0.0, record="dvl_altitude_max",
               help="Beyond it only the water is tracked. 0: no limit."),
    ] = 0.0  # fmt: skip


@model
class DepthSensor:
    """Pressure cell: depth of O_b, at the control rate."""

    depth_noise_m: Annotated[float, noise("Noise of the depth", "m", "depth_std")]
    depth_bias_m: Annotated[float, bias("Bias of the depth", "m", "depth_bias_std")] = 0.0


@model
class Camera:
    """Stereo camera that finds the docking target by its QR code."""

    rate_hz: Annotated[float, rate()]
    position_m: Annotated[tuple[float, float, float], place("camera_position[0]")]
    pitch_down_deg: Annotated[float, axis(0)]
    field_of_view_half_deg: Annotated[
        float, Number("Half angle of view", "deg", max=90.0, above=0.0, record="camera_half_angle[0]")
    ]
    range_min_m: Annotated[float, Number("Nearest detection", "m", 0.0, record="camera_range_min[0]")]
    range_max_m: Annotated[float, Number("Farthest detection", "m", above=0.0, record="camera_range_max[0]")]
    range_noise_share: Annotated[
        float, Number("Noise of the range, as a share of it", "", 0.0, record="camera_range_std")
    ]
    bearing_noise_deg: Annotated[
        float, noise("Noise of bearing and elevation each", "deg", "camera_bearing_std")
    ]
    dropout_probability: Annotated[float, share("Share of frames missed")]
    field_of_view: Annotated[FieldOfView, form(0)] = "angles"
    field_of_view_vertical_half_deg: Annotated[float, half_vertical(0)] = 0.0
    latency_s: Annotated[
        float, Number("From a frame to its sight", "s", 0.0, 5.0, help="The autopilot knows it.")
    ] = 0.0
    outlier_probability: Annotated[float, share("Share of frames with a false sight", "camera_outlier")] = 0.0
    sight_attenuation_lengths: Annotated[
        float,
        Number("How far the code is read in turbid water, in attenuation lengths", "", above=0.0,
               record="camera_sight", help="4.8 for the eye. Source: Zaneveld and Pegau 2003."),
    ] = 4.8  # fmt: skip
    marker_angle_max_deg: Annotated[
        float,
        Number("Farthest off the marker's normal", "deg", max=180.0, above=0.0, record="camera_marker_angle",
               help="180: the code is read from any side, even from behind."),
    ] = 180.0  # fmt: skip


@model
class NearCamera:
    """A second camera for close range; rate, latency and errors are the first one's."""

    position_m: Annotated[tuple[float, float, float], place("camera_position[1]", 20.0)]
    pitch_down_deg: Annotated[float, axis(1)]
    field_of_view_half_deg: Annotated[
        float, Number("Half angle of view", "deg", 1.0, 90.0, record="camera_half_angle[1]")
    ]
    range_min_m: Annotated[float, Number("Nearest detection", "m", 0.0, 100.0, record="camera_range_min[1]")]
    range_max_m: Annotated[
        float, Number("Farthest detection", "m", 0.01, 100.0, record="camera_range_max[1]")
    ]
    field_of_view: Annotated[FieldOfView, form(1)] = "rectangle"
    field_of_view_vertical_half_deg: Annotated[float, half_vertical(1)] = 0.0


@model
class Usbl:
    """Acoustic head that hears a transponder at the target: range and direction, for homing."""

    rate_hz: Annotated[float, Number("Replies a second", "Hz", 0.01, 100.0)]
    position_m: Annotated[tuple[float, float, float], place("usbl_position", 20.0)]
    range_max_m: Annotated[float, Number("Farthest reply", "m", 0.1, 1e4, record="usbl_range_max")]
    range_noise_m: Annotated[float, Number("Noise of the range", "m", 0.0, 100.0, record="usbl_range_std")]
    angle_noise_deg: Annotated[
        float, Number("Noise of bearing and elevation each", "deg", 0.0, 45.0, record="usbl_angle_std")
    ]
    dropout_probability: Annotated[float, share("Share of replies missed", "usbl_dropout")] = 0.0
    outlier_probability: Annotated[float, share("Share of false replies", "usbl_outlier")] = 0.0


@model
class Sensors:
    """All sensors of a vehicle."""

    ins: Annotated[Ins, Part("Inertial navigation")]
    dvl: Annotated[Dvl, Part("Doppler log")]
    depth: Annotated[DepthSensor, Part("Pressure cell")]
    camera: Annotated[Camera, Part("Camera for the target")]
    near_camera: Annotated[NearCamera | None, Part("Second camera, for close range")] = None
    usbl: Annotated[Usbl | None, Part("USBL for homing")] = None
