"""The sensors of a vehicle as its file describes them: noise is one standard deviation of white noise."""

from typing import Annotated

from bumpless.config.declare import Number, Part, Row, model
from bumpless.config.names import BODY


def noise(label: str, unit: str, record: str) -> Number:
    """A standard deviation."""
    return Number(label, unit, 0.0, record=record)


def bias(label: str, unit: str, record: str) -> Number:
    """A constant error, drawn anew for each run."""
    return Number(label, unit, 0.0, record=record, help="Constant in a run, drawn with this deviation.")


def rate() -> Number:
    """How often a sensor measures."""
    return Number("Measurements a second", "Hz", above=0.0)


@model
class Ins:
    """Inertial navigation: attitude and body rates, at the control rate."""

    roll_pitch_noise_deg: Annotated[float, noise("Noise of roll and pitch", "deg", "roll_pitch_std")]
    heading_noise_deg: Annotated[float, noise("Noise of the heading", "deg", "heading_std")]
    rate_noise_degps: Annotated[float, noise("Noise of the body rates", "deg/s", "rate_std")]
    heading_bias_deg: Annotated[float, bias("Bias of the heading", "deg", "heading_bias_std")] = 0.0


@model
class Dvl:
    """Doppler log: velocity over ground, and through water by water track, in body axes."""

    rate_hz: Annotated[float, rate()]
    ground_velocity_noise_mps: Annotated[float, noise("Noise of the velocity over ground", "m/s", "dvl_std")]
    water_velocity_noise_mps: Annotated[
        float, noise("Noise of the velocity through water", "m/s", "dvl_water_std")
    ]
    dropout_probability: Annotated[float, Number("Share of pings missed", "", 0.0, 1.0)]


@model
class DepthSensor:
    """Pressure cell: depth of O_b, at the control rate."""

    depth_noise_m: Annotated[float, noise("Noise of the depth", "m", "depth_std")]
    depth_bias_m: Annotated[float, bias("Bias of the depth", "m", "depth_bias_std")] = 0.0


@model
class Camera:
    """Stereo camera that finds the docking target by its QR code."""

    rate_hz: Annotated[float, rate()]
    position_m: Annotated[
        tuple[float, float, float], Row("Place in body axes", "m", names=BODY, record="camera_position")
    ]
    pitch_down_deg: Annotated[
        float, Number("Optical axis below x_b", "deg", -90.0, 90.0, record="camera_pitch")
    ]
    field_of_view_half_deg: Annotated[
        float, Number("Half angle of view", "deg", max=90.0, above=0.0, record="camera_half_angle")
    ]
    range_min_m: Annotated[float, Number("Nearest detection", "m", 0.0, record="camera_range_min")]
    range_max_m: Annotated[float, Number("Farthest detection", "m", above=0.0, record="camera_range_max")]
    range_noise_share: Annotated[
        float, Number("Noise of the range, as a share of it", "", 0.0, record="camera_range_std")
    ]
    bearing_noise_deg: Annotated[
        float, noise("Noise of bearing and elevation each", "deg", "camera_bearing_std")
    ]
    dropout_probability: Annotated[float, Number("Share of frames missed", "", 0.0, 1.0)]


@model
class Sensors:
    """All sensors of a vehicle."""

    ins: Annotated[Ins, Part("Inertial navigation")]
    dvl: Annotated[Dvl, Part("Doppler log")]
    depth: Annotated[DepthSensor, Part("Pressure cell")]
    camera: Annotated[Camera, Part("Camera for the target")]
