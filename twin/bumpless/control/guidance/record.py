"""What guidance is told, what it remembers and what it says."""

import numpy as np

from bumpless.config.parameters.records import section_dtype

f8, i8 = np.float64, np.int64

GUIDANCE_SETTINGS = section_dtype("guidance")

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
        ("first", i8),  # 1 in a mission's first cycle, but where docking begins as the vehicle is found
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
