"""The arrays that compiled code works on: one NumPy record type per role, SI and radians throughout.

A record is a named, fixed-size block of memory. Compiled functions read and write its fields
without conversion, it pickles, and a run is an array of `LOG` rows. Capacity is fixed
(`MAX_ACTUATORS`), so one compilation serves every vehicle; unused entries are zero.
Order of actuators: the vehicle file's. Wrench order: [X Y Z K M N] in body axes about O_b.
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as MAX_ACTUATORS
from bumpless.config.capacity import MAX_FAULTS as MAX_FAULTS
from bumpless.config.capacity import MAX_OUTAGES as MAX_OUTAGES
from bumpless.config.capacity import MAX_WAYPOINTS as MAX_WAYPOINTS
from bumpless.config.capacity import N_MODES as N_MODES
from bumpless.control.effectiveness.record import ESTIMATOR
from bumpless.physics.model_record import MODEL as MODEL

FORWARD, REVERSE, HOVER = 0, 1, 2

f8, i8 = np.float64, np.int64
_n = MAX_ACTUATORS

MODE_CONTROL = np.dtype(
    [
        ("Q", f8, 6),  # diagonal of Q, 1/N^2 or 1/(N m)^2
        ("R", f8, _n),  # diagonal of R, on bound-normalised commands
        ("lam", f8),  # lambda
        ("n_sw", f8),  # ramp length into this mode, cycles
        ("K_P", f8, 6),  # diagonals, on e = [u v z phi theta psi]
        ("K_I", f8, 6),
        ("K_D", f8, 6),
        ("integral_limit", f8, 6),  # bound of |K_I e_I|, N or N m
        ("demand_limit", f8, 6),  # bound of |tau_d|, N or N m
        ("increment_share", f8),  # of du_max that commands may use in this mode
    ],
    align=True,
)

SETTINGS = np.dtype(
    [
        ("dt", f8),  # control period, s
        # supervisor: thresholds in m, counts in cycles
        ("d_rh_l", f8),
        ("d_rh_u", f8),
        ("d_fr_l", f8),
        ("d_fr_u", f8),
        ("d_hf_u", f8),
        ("n_dwell", i8),
        ("hits", i8),
        ("window", i8),
        ("hold", i8),
        # bumpless mechanisms
        ("ramp", i8),
        ("align", i8),
        ("project", i8),
        ("align_channels", f8, 6),  # 1 where the integrator is aligned
        ("align_bleed", f8),  # s over which the aligned offset decays; 0 keeps it, as published
        ("scale_integration", i8),  # 1: integration is scaled by kappa during the ramp
        ("integral_at_switch", i8),  # KEEP, RESCALE, RESET of what is not aligned
        ("ramp_increment_share", f8),  # of du_max at kappa = 0, growing to 1 with kappa^4
        ("ramp_increment_price", f8),  # extra weight of ||u - u_prev||^2 at kappa = 0, fading to 0
        # allocation
        ("allocator", i8),  # MDCA, WLS, PID_DIRECT
        ("sqp_iterations", i8),
        ("kkt_tolerance", f8),
        ("fault_tolerant", i8),
        ("estimate", i8),  # 1: effectiveness is estimated; 0: told
        ("fault_evidence", f8),  # log-likelihood ratio that raises an alarm
        ("effectiveness_blend", f8),  # s over which a diagnosed loss is blended in
        ("anti_windup", f8),  # 1/s, feedback of the allocation residual into the integrals
        ("increment_price", f8),  # weight of ||u - u_prev||^2; 0 as published
        ("direct_map", i8),  # S1: THRUST_LINEAR, SPEED_LINEAR
        ("degraded_map", i8),  # fault tolerance: allocate with the effectiveness as it is
        ("priority", f8, 6),  # factors on Q once a fault is known
        ("slack_price", f8, 6),  # P of the slack on each wrench component; 0 allows none
        ("easing_made_up", i8),  # 1: thrust that eased screws missed is asked for in the next cycle
        ("fault_gains", f8, (3, 6)),  # factors on K_P, K_I, K_D once a fault is known
        # guidance
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

MDCA, WLS, PID_DIRECT = 0, 1, 2
ALOS, AALOS = 0, 1
KEEP, RESCALE, RESET = 0, 1, 2
THRUST_LINEAR, SPEED_LINEAR = 0, 1

N_NOISE = 24

FAULT_FIELDS = [  # of a plan as of the truth
    ("n_faults", i8),
    ("fault_actuator", i8, MAX_FAULTS),
    ("fault_time", f8, MAX_FAULTS),  # s
    ("fault_effectiveness", f8, MAX_FAULTS),  # 0 to 1
    ("fault_blend", f8, MAX_FAULTS),  # s over which it comes in
]

PLAN = np.dtype(  # all that an autopilot knows of a mission; what is true besides is `bumpless.sim.truth`
    [
        ("n_legs", i8),
        ("waypoint", f8, (MAX_WAYPOINTS, 3)),  # NED, m; leg i goes from i to i + 1
        ("speed", f8, MAX_WAYPOINTS),  # of leg i, m/s
        ("target", f8, 4),  # planned marker position NED, approach heading
        ("standoff", f8),  # m before the marker
        ("start", f8, 6),  # eta
        ("start_speed", f8),  # surge through water, m/s
        ("cycles", i8),  # longest duration
        ("hold_cycles", i8),  # in a row in H within d_RH^U that complete the mission; 0: never
        # faults it is told of; only a fault-tolerant allocator looks
        *FAULT_FIELDS,
    ],
    align=True,
)

SENSORS = np.dtype(
    [
        ("roll_pitch_std", f8),  # rad
        ("heading_std", f8),  # rad
        ("heading_bias_std", f8),  # rad, drawn once a run
        ("rate_std", f8),  # rad/s
        ("dvl_std", f8),  # m/s
        ("dvl_water_std", f8),  # m/s
        ("dvl_period", i8),  # cycles
        ("dvl_dropout", f8),  # z score below which a sample is lost
        ("depth_std", f8),  # m
        ("depth_bias_std", f8),  # m, drawn once a run
        ("camera_position", f8, 3),  # body, m
        ("camera_pitch", f8),  # rad, of the optical axis below x_b
        ("camera_half_angle", f8),  # rad
        ("camera_range_max", f8),  # m
        ("camera_range_min", f8),
        ("camera_period", i8),  # cycles
        ("camera_dropout", f8),  # z score
        ("camera_range_std", f8),  # share of range
        ("camera_bearing_std", f8),  # rad
    ],
    align=True,
)

MEASUREMENT = np.dtype(
    [
        ("attitude", f8, 3),
        ("rates", f8, 3),
        ("velocity", f8, 3),  # over ground, body
        ("velocity_valid", i8),  # 1 in a cycle with a new sample
        ("water_velocity", f8, 3),  # through water, body
        ("depth", f8),
        ("detected", i8),  # target seen
        ("fresh", i8),  # 1 in a cycle with a new camera frame
        ("target", f8, 3),  # range m, bearing rad, elevation rad in camera axes
        ("u_feedback", f8, _n),
    ],
    align=True,
)

PLANT = np.dtype(
    [
        ("time", f8),
        ("eta", f8, 6),
        ("nu", f8, 6),
        ("u", f8, _n),
        ("gust", f8, 3),
        ("current", f8, 3),  # NED at the vehicle, m/s
        ("current_dot", f8, 3),
        ("tau", f8, 6),  # actuator wrench at the last step's end
        ("effectiveness", f8, _n),
        ("heading_bias", f8),
        ("depth_bias", f8),
    ],
    align=True,
)

AUTOPILOT = np.dtype(
    [
        ("cycle", i8),  # k
        ("time", f8),
        # navigation
        ("eta", f8, 6),
        ("nu", f8, 6),
        ("current", f8, 3),
        ("nu_r", f8, 6),
        ("flow", f8, 6),  # velocity through water, smoothed; nu_r: what of it the allocator sees
        ("target", f8, 3),
        ("fixes", i8),
        # supervisor
        ("mode", i8),
        ("previous_mode", i8),
        ("switch_cycle", i8),  # k_s of the last mode switch
        ("history", i8),  # raw detections, newest in bit 0
        ("hold_left", i8),
        ("detected", i8),
        ("range", f8),
        ("hover_cycles", i8),  # in a row in H and in range
        ("holding", i8),  # 1 while paused: hold `hold_point`
        ("hold_point", f8, 4),  # NED and heading
        # guidance
        ("sway", i8),  # 1 when the vehicle can push sideways
        ("leg", i8),
        ("b", f8),
        ("alpha", f8),  # rad, pitch that holds depth, learnt
        ("reference", f8, 6),
        ("depth_rate", f8),
        ("cross_track", f8),
        ("along_track", f8),
        # pid
        ("error", f8, 6),
        ("error_rate", f8, 6),
        ("smooth_error", f8, 6),
        ("smooth_rate", f8, 6),
        ("K_I", f8, 6),  # of the last cycle
        ("integral", f8, 6),  # K_I e_I, N or N m
        ("bias", f8, 6),  # aligned offset, bled off
        ("schedule", f8),
        # switching
        ("ramp_cycle", i8),  # k at which the present ramp began
        ("ramp_length", f8),
        ("kappa", f8),
        ("tau_plus", f8, 6),
        ("tau_minus", f8, 6),
        ("tau_d", f8, 6),
        ("Q", f8, 6),
        ("R", f8, _n),
        ("lam", f8),
        ("Q_minus", f8, 6),
        ("R_minus", f8, _n),
        ("lam_minus", f8),
        ("Q_mode", f8, 6),  # Q before priorities and slack
        ("increment_share", f8),
        ("increment_share_minus", f8),
        ("step_share", f8),  # of the rate limit, in force in this cycle
        ("increment_price", f8),
        ("fault_share", f8),  # how far a known fault is blended in
        # allocation
        ("u", f8, _n),
        ("u_lower", f8, _n),
        ("u_upper", f8, _n),
        ("du_max", f8, _n),
        ("tau_c", f8, 6),
        ("limited", i8, 6),  # 1 where a command at a bound has authority
        ("status", i8),
        ("refused", i8),  # cycles in a row without a demand to allocate
        ("iterations", i8),
        ("kkt", f8),
        ("cost", f8),
        ("slack", f8, 6),
        ("solve_time", f8),
        ("effectiveness", f8, _n),  # as the allocator believes
        ("estimator", ESTIMATOR),
    ],
    align=True,
)

ALLOCATION_WORK = np.dtype(
    [
        ("x", f8, _n),
        ("lower", f8, _n),
        ("upper", f8, _n),
        ("step", f8, _n),
        ("trial", f8, _n),
        ("u_previous", f8, _n),
        ("x_previous", f8, _n),
        ("healthy", f8, _n),
        ("curvature", f8, _n),
        ("coupling", f8, _n),  # the same between slot i and the next
        ("free", i8, _n),
        ("weight", f8, 6),
        ("lb", f8, _n),
        ("ub", f8, _n),
        ("g", f8, _n),
        ("H", f8, (_n, _n)),
        ("jacobian", f8, (6, _n)),
        ("tau", f8, 6),
        ("price", f8, _n),
        ("demand", f8, 6),
        ("missed", f8, 6),
        ("channel", f8, 6),
        ("flow", f8, 6),
    ],
    align=True,
)

LOG = np.dtype(
    [
        ("time", f8),  # s since mission start
        ("cycle", i8),
        ("phase", i8),  # MissionPhase of the contract
        ("mode", i8),  # FORWARD, REVERSE, HOVER
        ("previous_mode", i8),
        ("kappa", f8),
        ("time_in_mode", f8),
        ("dwell_remaining", f8),  # s
        ("range", f8),  # to the observation point, m
        ("detected_raw", i8),
        ("detected", i8),  # after the filter
        # navigation estimate
        ("eta_hat", f8, 6),
        ("nu_hat", f8, 6),
        ("nu_r_hat", f8, 3),  # velocity through water, body
        ("current_hat", f8, 3),  # NED
        ("depth", f8),  # measured
        # guidance: [u_d v_d z_d phi_d theta_d psi_d]
        ("reference", f8, 6),
        ("cross_track", f8),
        ("along_track", f8),
        ("leg", i8),
        ("leg_count", i8),
        ("error", f8, 6),  # e of eq. (42)
        ("integral", f8, 6),  # K_I e_I, in wrench units
        # control and allocation
        ("tau_d", f8, 6),
        ("tau_plus", f8, 6),  # PID of the active mode before the ramp
        ("tau_minus", f8, 6),  # frozen pre-switch demand
        ("tau_c", f8, 6),  # G(u) by the allocator's model
        ("u", f8, _n),  # command: rad or rev/s
        ("u_feedback", f8, _n),
        ("u_lower", f8, _n),
        ("u_upper", f8, _n),
        ("du_max", f8, _n),  # increment bound of this cycle
        ("status", i8),  # SolveStatus of the contract
        ("iterations", i8),
        ("kkt", f8),
        ("cost", f8),
        ("residual_norm", f8),
        ("slack", f8, 6),
        ("solve_time", f8),  # s
        # effectiveness: estimated, or as told
        ("effectiveness_hat", f8, _n),
        ("faults", i8),  # diagnosed by the autopilot: bit i for actuator i
        ("fault_evidence", f8, _n),  # log-likelihood ratio of a change against none
        ("unexplained", f8, 6),  # wrench that the model leaves unexplained, N and N m
        # target
        ("target_measured", f8, 3),  # range m, bearing rad, elevation rad; NaN when not detected
        ("target", f8, 4),  # estimate: position NED, approach heading
        ("observation_point", f8, 3),
        # truth: only a simulated vehicle fills these
        ("eta", f8, 6),
        ("nu", f8, 6),
        ("tau", f8, 6),  # the plant's actuator wrench
        ("current", f8, 3),  # NED
        ("effectiveness", f8, _n),
        ("range_true", f8),  # to the true target's observation point, m
        ("target_true", f8, 3),  # NED
    ],
    align=True,
)
