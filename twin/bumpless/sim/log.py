"""One row for each control cycle: what a flight is remembered by. `sim.row` fills it."""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n

f8, i8 = np.float64, np.int64

LOG = np.dtype(
    [
        ("time", f8),  # s since mission start
        ("cycle", i8),
        ("phase", i8),  # MissionPhase of `contract.enums`
        ("mode", i8),  # FORWARD, REVERSE, HOVER
        ("previous_mode", i8),
        ("kappa", f8),
        ("time_in_mode", f8),
        ("dwell_remaining", f8),  # s
        ("range", f8),  # to the observation point, m
        ("detected_raw", i8),
        ("detected", i8),  # after the filter
        ("flown", i8),  # mode whose gains and weights count: H while holding station; 0: actuators at rest
        ("hits", i8),  # camera frames of the filter's window that show the target
        ("hold_left", i8),  # camera frames that a detection still lasts without one
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
        ("status", i8),  # SolveStatus
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
        # docking automaton
        ("stage", i8),  # DockingStage; 0: the published automaton
        ("tried", i8),  # approaches begun
        ("tries", i8),  # in all
        ("reason", i8),  # WaveOffReason of the last wave-off
        ("cleared", i8),  # 1: past the gate
        ("held", f8),  # s in a row in place at the observation point
        ("approach", f8),  # approach heading in use, rad
        ("fix_age", f8),  # s since the last fix
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
        # a dock to enter; zero where there is none
        ("captured", i8),  # its latch has closed
        ("contact_force", f8),  # largest sum of normal forces in the period before, N
        ("contact_most", f8),  # what dock and hull bear, N
        ("nose_depth", f8),  # of the nose behind the entry, m
        ("nose_offset", f8),  # of the nose from the axis, m
    ],
    align=True,
)
