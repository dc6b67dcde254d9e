"""The sensors of a vehicle as its file describes them: noise is one standard deviation of white noise."""

from dataclasses import dataclass

from bumpless.config.vehicle.fields import number, vector


@dataclass(frozen=True)
class Ins:
    """Inertial navigation: attitude and body rates, at the control rate."""

    roll_pitch_noise_deg: float = number(low=0)
    heading_noise_deg: float = number(low=0)
    rate_noise_degps: float = number(low=0)
    heading_bias_deg: float = number(low=0, default=0.0)  # constant in a run, drawn with this deviation


@dataclass(frozen=True)
class Dvl:
    """Doppler log: velocity over ground, and through water by water track, in body axes."""

    rate_hz: float = number(above=0)
    ground_velocity_noise_mps: float = number(low=0)
    water_velocity_noise_mps: float = number(low=0)
    dropout_probability: float = number(low=0, high=1)  # of each ping


@dataclass(frozen=True)
class DepthSensor:
    """Pressure cell: depth of O_b, at the control rate."""

    depth_noise_m: float = number(low=0)
    depth_bias_m: float = number(low=0, default=0.0)  # constant in a run, drawn with this deviation


@dataclass(frozen=True)
class Camera:
    """Stereo camera that finds the docking target by its QR code."""

    rate_hz: float = number(above=0)
    position_m: tuple[float, float, float] = vector(3)
    pitch_down_deg: float = number(low=-90, high=90)  # optical axis below x_b
    field_of_view_half_deg: float = number(above=0, high=90)
    range_min_m: float = number(low=0)
    range_max_m: float = number(above=0)
    range_noise_share: float = number(low=0)  # of the range
    bearing_noise_deg: float = number(low=0)  # bearing and elevation each
    dropout_probability: float = number(low=0, high=1)  # of each frame


@dataclass(frozen=True)
class Sensors:
    """All sensors of a vehicle."""

    ins: Ins
    dvl: Dvl
    depth: DepthSensor
    camera: Camera
