"""The docking automaton: approach line, gates, wave-off and go-around."""

from typing import Annotated

from bumpless.config.declare import Number, Switch, model


def way(label: str, record: str, most: float = 200.0, help: str = "") -> Number:
    """A distance."""
    return Number(label, "m", 0.0, most, record=record, help=help)


def pace(label: str, record: str, help: str = "") -> Number:
    """A speed."""
    return Number(label, "m/s", 0.0, 3.0, record=record, help=help)


def spell(label: str, record: str, least: float = 0.0, help: str = "") -> Number:
    """A time."""
    return Number(label, "s", least, 1000.0, record=record, help=help)


def share(label: str, record: str, help: str = "") -> Number:
    """A share, 0 to 1."""
    return Number(label, "", 0.0, 1.0, record=record, help=help)


@model
class DockingParameters:
    """How a dock is approached, and when an approach is given up. Ours, beyond the paper.

    Distances along the approach line are those left to the observation point.
    """

    enabled: Annotated[
        bool,
        Switch("Docking automaton", record="enabled",
               help="Off: the published automaton of eq. (53) with the published guidance."),
    ] = False  # fmt: skip
    tries: Annotated[int, Number("Approaches in all", "", 1, 20, record="tries")] = 3
    # the approach line
    entry_distance_m: Annotated[float, way("Where the approach line begins", "entry_distance")] = 15.5
    turn_radius_m: Annotated[
        float, Number("Turning radius of the way round", "m", 0.1, 200.0, record="turn_radius")
    ] = 6.0
    keep_out_m: Annotated[
        float,
        Number("Distance kept from the dock in F", "m", 0.0, 200.0, record="keep_out",
               help="From the circle about the target that holds the mission's dock."),
    ] = 4.2  # fmt: skip
    break_off_m: Annotated[
        float,
        way("Last place to break off in F", "break_off", help="An approach not fit to go on ends here."),
    ] = 6.5
    deceleration_mps2: Annotated[float, Number("Deceleration", "m/s²", 0.001, 2.0, record="deceleration")] = (
        0.02
    )
    try_brake_m: Annotated[
        float,
        way("Where the brake is tried", "try_brake", help="No faster than the next from there on; 0: off."),
    ] = 0.0
    try_brake_mps: Annotated[float, pace("Fastest approach from there on", "try_speed")] = 0.28
    end_gain_per_s: Annotated[
        float, Number("Speed per metre at the end", "1/s", 0.01, 5.0, record="end_gain")
    ] = 0.2
    look_ahead_m: Annotated[
        float, Number("Look-ahead of the line law at rest", "m", 0.1, 100.0, record="look_ahead")
    ] = 2.0
    look_ahead_slope_s: Annotated[float, spell("Its growth with speed through water", "look_ahead_slope")] = (
        4.0
    )
    lateral_damping: Annotated[float, share("Sideways speed error fed back", "lateral_damping")] = 0.5
    lateral_integral: Annotated[
        float,
        Number("Learning of sideways drift", "1/s", 0.0, 1.0, record="lateral_integral",
               help="Per metre of offset and m/s of flow."),
    ] = 0.005  # fmt: skip
    flow_floor_mps: Annotated[
        float, Number("Flow below which heading corrections fade", "m/s", 0.001, 1.0, record="flow_floor")
    ] = 0.03
    crab_far: Annotated[float, share("Largest heading correction far out", "crab_far", "Its sine.")] = 0.35
    crab_near: Annotated[
        float, share("The same at the observation point in still water", "crab_near", "Its sine.")
    ] = 0.05
    crab_borne: Annotated[
        float,
        share("The same there in a head current", "crab_borne",
              "Its sine. A current so far off the bow is held for good."),
    ] = 0.08  # fmt: skip
    crab_free: Annotated[
        float,
        share("The same where the approach heading may follow the hull", "crab_free",
              "Its sine. In H the heading follows, and the angle goes."),
    ] = 0.15  # fmt: skip
    crab_slope_per_m: Annotated[
        float, Number("Its growth with distance", "1/m", 0.0, 1.0, record="crab_slope")
    ] = 0.08
    straighten_m: Annotated[float, way("Where the heading is straightened", "straighten")] = 0.5
    straighten_flow_s: Annotated[float, spell("The same, per m/s of current missing", "straighten_flow")] = (
        15.0
    )
    aim_time_s: Annotated[
        float,
        spell("Stay whose drift the aim allows for", "aim_time",
              help="The aim lies upstream by what can't be made good, on the way to rest and so long after."),
    ] = 10.0  # fmt: skip
    aim_most_m: Annotated[float, way("Farthest aim upstream", "aim_most", 2.0)] = 0.3
    # the approach heading and the current
    turn_time_s: Annotated[
        float, spell("Time in which the approach heading follows the current", "turn_time", 0.1)
    ] = 30.0
    turn_until_m: Annotated[float, way("Where that ends", "turn_until")] = 2.5
    weathervane_s: Annotated[float, spell("Time in which it follows the hull in H", "weathervane", 0.1)] = 8.0
    # what can't be held is refused before the start and given up in flight; what surely can is accepted;
    # between the two lies a warning
    side_still_mps: Annotated[float, pace("Most current across that is borne at rest", "side_still")] = 0.022
    side_share: Annotated[float, share("And per m/s of head current", "side_share")] = 0.15
    following_mps: Annotated[float, pace("Most current from astern that is borne", "following")] = 0.16
    sure_side_still_mps: Annotated[
        float, pace("Current across that is surely borne at rest", "", "Asked by the mission's check only.")
    ] = 0.006
    sure_side_share: Annotated[float, share("The same per m/s of head current", "")] = 0.07
    sure_following_mps: Annotated[float, pace("Current from astern that is surely borne", "")] = 0.03
    # gates
    gate_distance_m: Annotated[
        float, way("Gate", "gate_distance", help="The approach stops there until the gate is passed.")
    ] = 3.0
    gate_depth_m: Annotated[float, way("Depth error at the gate", "gate_depth", 10.0)] = 0.12
    gate_heading_deg: Annotated[
        float, Number("Heading error at the gate", "deg", 0.1, 90.0, record="gate_heading")
    ] = 10.0
    gate_lateral_m: Annotated[float, way("Offset from the line at the gate", "gate_lateral", 10.0)] = 0.3
    patience_s: Annotated[float, spell("Patience at the gate, and in H outside its limits", "patience")] = (
        40.0
    )
    cone_base_m: Annotated[
        float, way("Half width of the approach cone at the observation point", "cone_base", 20.0)
    ] = 0.35
    cone_slope: Annotated[float, share("Its growth per metre", "cone_slope")] = 0.15
    hover_lateral_m: Annotated[float, way("Offset in H that is not waited out", "hover_lateral", 10.0)] = 0.12
    hover_heading_deg: Annotated[
        float, Number("Heading error in H that is not waited out", "deg", 0.1, 90.0, record="hover_heading")
    ] = 6.0
    # into a dock that can be entered
    creep_after_s: Annotated[
        float, spell("Stay at the observation point before the dock is entered", "creep_after")
    ] = 5.0
    creep_speed_mps: Annotated[float, pace("Speed into the dock", "creep_speed", help="Over ground.")] = 0.1
    creep_lateral_m: Annotated[
        float, way("Offset from the axis before the entry", "creep_lateral", 10.0, "More waves off.")
    ] = 0.2
    creep_heading_deg: Annotated[
        float, Number("Heading error before the entry", "deg", 0.1, 90.0, record="creep_heading")
    ] = 8.0
    creep_depth_m: Annotated[float, way("Depth error before the entry", "creep_depth", 10.0)] = 0.2
    creep_time_s: Annotated[
        float, spell("Time allowed from the observation point to the capture", "creep_time")
    ] = 90.0
    # wave-off
    lost_far_s: Annotated[float, spell("Time without the target before the gate", "lost_far")] = 5.0
    lost_near_s: Annotated[
        float,
        spell("The same behind it", "lost_near", help="Flown on the last fix and the current estimate."),
    ] = 20.0
    overshoot_m: Annotated[float, way("Way past the observation point", "overshoot", 10.0)] = 0.2
    lag_most_mps: Annotated[
        float, pace("Speed error that counts as a fault", "lag_most", "Smoothed over 4 s; twice it in F.")
    ] = 0.08
    lag_near_mps: Annotated[
        float, pace("Too fast by this, close by, counts as a fault of the brake", "lag_near")
    ] = 0.028
    unbraked_most_mps: Annotated[
        float,
        pace("Faster by this than thrust should have left it", "unbraked_most",
             "Over 3 s: with the share below counts as a fault of the brake."),
    ] = 0.032  # fmt: skip
    unbraked_share: Annotated[
        float, share("And by this share of what thrust should have taken off it", "unbraked_share")
    ] = 0.5
    hold_distance_m: Annotated[float, way("Hold point, where a wave-off ends", "hold_distance")] = 9.0
    back_speed_mps: Annotated[float, pace("Speed astern in still water", "back_speed")] = 0.15
    # references
    speed_time_s: Annotated[
        float, spell("Time in which the speed reference closes on its goal", "speed_time", 0.05)
    ] = 1.5
    jerk_mps3: Annotated[float, Number("Jerk of the speed reference", "m/s³", 1e-4, 10.0, record="jerk")] = (
        0.015
    )
    line_rate_degps: Annotated[
        float,
        Number("Fastest turn of heading and pitch on the line", "deg/s", 0.01, 180.0, record="line_rate"),
    ] = 5.0
    fin_rate_degps: Annotated[
        float,
        Number("Fastest fin in R and H", "deg/s", 0.1, 360.0, record="fin_rate",
               help="Where the flow is slow fins gain nothing by slamming."),
    ] = 11.5  # fmt: skip
    forward_feed: Annotated[float, share("Drag and inertia fed forward in surge", "forward_feed")] = 1.0
    turn_feed: Annotated[
        float, share("Drag of a turn fed forward", "turn_feed", "Under way: of the hull and of its fins.")
    ] = 0.6
    slow_worth: Annotated[
        float,
        Number("Largest factor on Q of pitch and yaw in slow flow", "", 1.0, 1e6, record="slow_worth"),
    ] = 1000.0
    # depth by pitch where the fins have flow, by heave where not
    pitch_flow_low_mps: Annotated[float, pace("Flow where pitch begins to hold depth", "pitch_flow_low")] = (
        0.15
    )
    pitch_flow_high_mps: Annotated[float, pace("Flow where it holds it alone", "pitch_flow_high")] = 0.4
    pitch_integral: Annotated[float, share("Heave integration that pitch takes away", "pitch_integral")] = 0.3
    pitch_lead_s: Annotated[float, spell("Lead of depth rate", "pitch_lead")] = 1.4
    pitch_look_slow: Annotated[
        float,
        Number("Share of the pitch look-ahead left without flow", "", 0.05, 1.0, record="pitch_look_slow",
               help="Grows to 1 at the speed of full gains: a slow hull needs steeper pitch."),
    ] = 0.25  # fmt: skip
    pitch_feed: Annotated[
        float, share("Slope of a leg fed forward", "pitch_feed", "By pitch; a step of depth is not.")
    ] = 1.0
    depth_rate_pitch_mps: Annotated[
        float, pace("Fastest change of the depth reference by pitch", "depth_rate_pitch")
    ] = 0.12
