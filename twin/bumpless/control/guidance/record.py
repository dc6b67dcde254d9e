"""What guidance is told, what it remembers and what it says."""

import numpy as np

f8, i8 = np.float64, np.int64

ALOS, AALOS = 0, 1  # laws

GUIDANCE_SETTINGS = np.dtype(
    [
        ("law", i8),  # ALOS of eq. (41), AALOS of Fossen and Aguiar 2024
        ("look_ahead", f8),  # Delta, m
        ("gamma", f8),  # adaptation gain
        ("depth_rate", f8),  # m/s
        ("pitch_look_ahead", f8),  # m, of the depth law that pitches; 0: depth by heave
        ("pitch_gamma", f8),  # its adaptation gain
        ("pitch_max", f8),  # rad
        ("speed_min", f8),  # m/s, slowest surge reference
        ("acceleration", f8),  # of the speed reference, m/s^2
        ("reverse_slope", f8),  # u_d = slope d + offset in R, at most reverse_max
        ("reverse_offset", f8),
        ("reverse_max", f8),
        ("hover_gain", f8),  # 1/s, position error to speed
        ("hover_max", f8),  # m/s
        ("hover_cross_gain", f8),  # share of the cross-track law kept in H, scaled by the inflow
        ("schedule_speed", f8),  # m/s through water above which fin channels get full gain
        ("schedule_min", f8),  # least share of the gain
        ("scheduled", f8, 6),  # 1 where gains follow the speed schedule
        ("schedule_limits", i8),  # 1: integral and demand limits follow the schedule too
        ("flow_drift", f8),  # share of sway and heave in the flow that the allocator sees
        ("flow_rates", f8),  # share of the turning rates in the flow that the allocator sees
        ("heading_rate", f8),  # rad/s, fastest change of the heading reference; 0: no limit
        ("flow_filter", f8),  # s, first-order lag on the velocity through water; 0: none
        ("crab_gain", f8),  # share of the estimated drift that the heading makes good
        ("error_filter", f8, 6),  # s, first-order lag on e; 0: none
        ("rate_filter", f8, 6),  # s, the same on e'
    ],
    align=True,
)

SITUATION = np.dtype(  # what guidance goes by in this cycle, besides the navigation's estimate
    [
        ("mode", i8),  # HOVER also while holding
        ("holding", i8),  # 1 while paused: hold station where the pause began
        ("station", f8, 4),  # where to hover: NED and heading
        ("range", f8),  # to the observation point, m
        ("detected", i8),
        ("slow", i8),  # 1 within d_FR^L: on the last leg no faster than R may be
        ("u_r", f8),  # surge through water, m/s
        ("adapt", i8),  # 1 where the law may learn: no ramp is under way
        ("first", i8),  # 1 in a mission's first cycle
    ],
    align=True,
)

GUIDANCE_STATE = np.dtype(
    [
        ("leg", i8),
        ("b", f8),  # learnt by the path law: m (ALOS) or rad
        ("alpha", f8),  # rad, pitch that holds depth, learnt
        ("reference", f8, 6),  # [u_d v_d z_d phi_d theta_d psi_d]
    ],
    align=True,
)

GUIDANCE_OUTPUT = np.dtype(
    [
        ("cross_track", f8),  # y_e, m
        ("along_track", f8),  # left to go, m
    ],
    align=True,
)
