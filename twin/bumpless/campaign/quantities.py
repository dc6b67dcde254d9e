"""What a campaign may draw: every quantity with its unit, its bounds and what it changes.

Axes named `along`, `across` and `relative` are those of the target's approach heading: along is the way in,
across is to starboard of it. A quantity that is not drawn leaves the mission and the vehicle as they are.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """One number, or for an actuator one name, that differs between flights."""

    unit: str
    about: str
    low: float
    high: float
    factor: bool = False  # 1 leaves things as they are


def _factor(about: str, low: float = 0.1, high: float = 10.0) -> Quantity:
    return Quantity("1", f"factor on {about}", low, high, factor=True)


QUANTITIES: dict[str, Quantity] = {
    # sea
    "current_speed_mps": Quantity("m/s", "horizontal current, in place of the mission's", 0.0, 5.0),
    "current_relative_deg": Quantity(
        "deg", "where it flows to, from the approach heading: 0 from astern, 180 against", -360.0, 360.0
    ),
    "current_along_mps": Quantity("m/s", "current added along the approach", -5.0, 5.0),
    "current_across_mps": Quantity("m/s", "current added across the approach", -5.0, 5.0),
    "current_variation_mps": Quantity("m/s", "standard deviation of the current's slow change", 0.0, 2.0),
    "current_variation_time_s": Quantity("s", "its correlation time", 0.1, 1e5),
    "wave_height_m": Quantity("m", "height of the wave", 0.0, 20.0),
    "wave_period_s": Quantity("s", "its period", 1.0, 60.0),
    "wave_relative_deg": Quantity("deg", "where it travels to, from the approach heading", -360.0, 360.0),
    "attenuation_per_m": Quantity("1/m", "turbidity: beam attenuation of the water", 0.0, 50.0),
    "water_depth_m": Quantity("m", "depth of the bottom; 0: always in reach of the Doppler log", 0.0, 11e3),
    "shelter_width_m": Quantity("m", "width of the dock across the current, for its wake", 0.05, 100.0),
    "shelter_turbulence": Quantity("1", "eddies, as a share of the current taken away", 0.0, 2.0),
    # a hung dock, in place of the mission's motion; 8 s where the mission says no period
    "dock_heave_m": Quantity("m", "amplitude of the dock's heave", 0.0, 10.0),
    "dock_sway_m": Quantity("m", "amplitude of its sway across the approach", 0.0, 10.0),
    "dock_period_s": Quantity("s", "its period", 1.0, 1e4),
    "dock_phase_deg": Quantity("deg", "its phase at the start", -360.0, 360.0),
    # target: where it truly is, and the approach heading that the vehicle is told
    "target_along_m": Quantity("m", "true target from the planned one, along the approach", -100.0, 100.0),
    "target_across_m": Quantity("m", "true target from the planned one, across", -100.0, 100.0),
    "target_down_m": Quantity("m", "true target from the planned one, down", -100.0, 100.0),
    "target_turn_deg": Quantity("deg", "turn of the approach heading, told", -180.0, 180.0),
    # start, in axes of the mission's start heading
    "start_ahead_m": Quantity("m", "start ahead of the mission's", -1e4, 1e4),
    "start_abeam_m": Quantity("m", "start to starboard of the mission's", -1e4, 1e4),
    "start_down_m": Quantity("m", "start below the mission's", -1e3, 1e3),
    "start_turn_deg": Quantity("deg", "start heading from the mission's", -180.0, 180.0),
    "start_speed_mps": Quantity("m/s", "surge at the start, in place of the mission's", 0.0, 5.0),
    # sensors
    "noise": Quantity("1", "factor on every noise of the sensors", 0.0, 20.0, factor=True),
    "heading_bias_std_deg": Quantity("deg", "deviation from which a run's heading bias is drawn", 0.0, 90.0),
    "depth_bias_std_m": Quantity("m", "deviation from which a run's depth bias is drawn", 0.0, 100.0),
    "detection_range_m": Quantity("m", "farthest detection of the target", 0.1, 200.0),
    "detection_dropout": Quantity("1", "share of camera frames missed", 0.0, 1.0),
    "detection_latency_s": Quantity("s", "from a camera frame to its sight", 0.0, 5.0),
    "detection_outliers": Quantity("1", "share of camera frames with a false sight", 0.0, 1.0),
    "marker_angle_deg": Quantity("deg", "farthest off the marker's normal at which it is seen", 1.0, 180.0),
    "heading_drift_degprth": Quantity("deg/√h", "random walk of the heading", 0.0, 1000.0),
    "roll_pitch_bias_deg": Quantity(
        "deg", "deviation from which biases of roll and pitch are drawn", 0.0, 20.0
    ),
    "dvl_scale_error": Quantity("1", "deviation of the Doppler log's scale", 0.0, 0.5),
    "dvl_water_bias_mps": Quantity("m/s", "deviation of water track's biases", 0.0, 1.0),
    "dvl_dropout": Quantity("1", "share of the Doppler log's pings missed", 0.0, 1.0),
    "dvl_outage_at_s": Quantity("s", "the bottom is lost from here on", 0.0, 1e5),
    "dvl_outage_length_s": Quantity("s", "for this long", 0.0, 1e5),
    "outage_at_s": Quantity("s", "the target is not seen from here on", 0.0, 1e5),
    "outage_length_s": Quantity("s", "for this long", 0.0, 1e5),
    # fault of one actuator: of the mission's first one what is drawn, or all four of a new one
    "fault_actuator": Quantity("", "name of the actuator", 0.0, 0.0),
    "fault_at_s": Quantity("s", "when it fails", 0.0, 1e5),
    "fault_effectiveness": Quantity("1", "share of its force that is left", 0.0, 1.0),
    "fault_blend_s": Quantity("s", "time over which it fails", 0.0, 1000.0),
    # the true vehicle, of which the autopilot knows nothing
    "actuator_flow": Quantity("", "1 with the real flow at screws and fins, 0 without", 0.0, 1.0),
    "mass": _factor("mass, inertia and displacement; added mass aside", 0.5, 2.0),
    "net_buoyancy_n": Quantity("N", "lift added at the centre of buoyancy", -1e3, 1e3),
    "ballast_n": Quantity("N", "weight added at the place below", -1e3, 1e3),
    "ballast_x_m": Quantity("m", "place of the added weight ahead of O_b", -10.0, 10.0),
    "trim_x_m": Quantity("m", "shift of the centre of buoyancy ahead", -1.0, 1.0),
    "trim_y_m": Quantity("m", "shift of the centre of buoyancy to starboard", -1.0, 1.0),
    "drag_axial": _factor("surge damping"),
    "drag_cross": _factor("every other damping and lift of the body"),
    "lag": _factor("every actuator's time constant"),
    "rate": _factor("every actuator's fastest change"),
    "fin_slew": _factor("the fins' fastest deflection"),
    "fin_lift": _factor("the fins' lift", 0.0),
    "thrust": _factor("the screws' thrust", 0.0),
}
NAMES = ("fault_actuator",)  # drawn from names, not numbers
# drawn only together, for one alone would mean nothing
TOGETHER = (
    ("current_speed_mps", "current_relative_deg"),
    ("outage_at_s", "outage_length_s"),
    ("dvl_outage_at_s", "dvl_outage_length_s"),
    ("ballast_n", "ballast_x_m"),
)
EITHER = (("current_speed_mps", "current_along_mps"), ("current_speed_mps", "current_across_mps"))
