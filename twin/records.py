"""The arrays that compiled code works on: one NumPy record type per role, SI and radians throughout.

A record is a named, fixed-size block of memory. Compiled functions read and write its fields
without conversion, it pickles, and a run is an array of `LOG` rows. Capacity is fixed
(`MAX_ACTUATORS`), so one compilation serves every vehicle; unused entries are zero.

Order of actuators: the vehicle file's. Wrench order: [X Y Z K M N] in body axes about O_b.
"""

import numpy as np

MAX_ACTUATORS = 8
MAX_WAYPOINTS = 64
N_MODES = 3
FORWARD, REVERSE, HOVER = 0, 1, 2
THRUSTER, FIN = 0, 1

f8, i8 = np.float64, np.int64
_n = MAX_ACTUATORS

MODEL = np.dtype(
    [
        # rigid body and restoring force
        ("rho", f8),  # kg/m^3
        ("weight", f8),  # N
        ("buoyancy", f8),  # N
        ("r_g", f8, 3),  # centre of gravity in body axes, m
        ("r_b", f8, 3),  # centre of buoyancy in body axes, m
        ("M_RB", f8, (6, 6)),
        ("M_A", f8, (6, 6)),
        ("M_inv", f8, (6, 6)),  # (M_RB + M_A)^-1
        # tau_damping_i = -(D_linear_ij + D_quadratic_ij |nu_j| + D_lift_ij s_i) nu_j,
        # s_i = |u| for the force rows, u for the moment rows
        ("D_linear", f8, (6, 6)),
        ("D_quadratic", f8, (6, 6)),
        ("D_lift", f8, (6, 6)),
        ("controllable", f8, 6),  # 1 where the actuators can act, 0 elsewhere (S_c)
        # actuators
        ("n_u", i8),
        ("kind", i8, _n),  # THRUSTER or FIN
        ("position", f8, (_n, 3)),  # r_i, m
        ("direction", f8, (_n, 3)),  # thrust direction d_j, or lift direction e_L
        ("command_min", f8, _n),  # rad or rev/s
        ("command_max", f8, _n),
        ("command_rate", f8, _n),  # rad/s or rev/s^2, magnitude
        ("time_constant", f8, _n),  # first-order lag, s
        # thruster: T = T_nn n|n| - T_nv |n| V_A ; shaft torque Q = Q_nn n|n| - Q_nv |n| V_A along d
        ("T_nn", f8, _n),  # rho D^4 K_T(0), N s^2, for n > 0
        ("T_nn_reverse", f8, _n),  # the same for n < 0
        ("T_nv", f8, _n),  # rho D^3 (-dK_T/dJ), N s^2/m
        ("Q_nn", f8, _n),  # N m s^2, signed by the screw's hand
        ("Q_nv", f8, _n),
        # fin: C_L = C_La alpha up to the stall angle, C_D = C_D0 + C_D2 alpha^2
        ("fin_area", f8, _n),  # m^2
        ("C_La", f8, _n),  # 1/rad
        ("C_D0", f8, _n),
        ("C_D2", f8, _n),  # 1/rad^2
        ("stall_angle", f8, _n),  # rad
        ("reverse_lift", f8, _n),  # share of C_La left when the flow meets the trailing edge
    ],
    align=True,
)

MODE_CONTROL = np.dtype(
    [
        ("Q", f8, 6),  # diagonal of Q
        ("R", f8, _n),  # diagonal of R, bound-normalised commands
        ("lam", f8),  # lambda
        ("n_sw", f8),  # ramp length into this mode, cycles
        ("K_P", f8, 6),  # diagonals, on e = [u v z phi theta psi]
        ("K_I", f8, 6),
        ("K_D", f8, 6),
        ("integral_limit", f8, 6),  # bound of |K_I e_I|, N or N m
        ("demand_limit", f8, 6),  # bound of |tau_d|, N or N m
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
        ("range_true", f8),
    ],
    align=True,
)
