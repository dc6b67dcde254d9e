"""The vehicle as compiled code reads it: rigid body, water forces and actuators. One compilation serves every
vehicle: capacity is fixed (`MAX_ACTUATORS`), unused entries are zero. Order of actuators: the vehicle file's.
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n
from bumpless.physics.dock.record import HULL_RINGS

f8, i8 = np.float64, np.int64

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
        ("half_height", f8),  # of the hull, m
        ("rings", HULL_RINGS),  # of a hull of revolution, from the nose; what can touch a dock
        ("controllable", f8, 6),  # 1 where the actuators can act, 0 elsewhere (S_c)
        # one entry for each command; what belongs to an actuator stands at its first, see `physics.actuators`
        ("n_u", i8),
        ("kind", i8, _n),  # a KIND of `physics.actuators.dispatch`
        ("part", i8, _n),  # which of its actuator's commands this is, from 0
        ("steers", i8, _n),  # 1: serves moments, 0: pushes; for the direct mapping of the baseline S1
        ("trust", f8, _n),  # share of the evidence against it that counts, see `control.effectiveness`
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
        # flow at the actuators, of the simulated vehicle only, see `physics.actuators.screw_flow`; zero: none
        ("flow", i8),  # 1: with all that follows
        ("T_vv", f8, _n),  # drag of the stopped screw, N s^2/m^2
        ("T_no", f8, _n),  # T_nv against the flow
        ("Q_vv", f8, _n),  # N m s^2/m^2
        ("Q_no", f8, _n),
        ("deduction", f8, _n),  # share of the thrust ahead that the hull loses
        ("deduction_astern", f8, _n),
        ("cross_loss", f8, _n),  # s^2/m^2
        ("dead_band", f8, _n),  # rev/s
        ("least_speed", f8, _n),  # rev/s
        ("disc_area", f8, _n),  # m^2
        ("inflow_share", f8, _n),  # 1 - w
        ("washed_by", i8, _n),  # 1 + slot of the screw in whose stream a fin stands; 0: none
        ("washed_share", f8, _n),  # of the fin's area
        ("fins_coast", i8),  # 1: the allocator takes fin drag as given and does not brake with fins
        ("smoothing", f8),  # thrust share below which the allocator eases a screw through zero
    ],
    align=True,
)
