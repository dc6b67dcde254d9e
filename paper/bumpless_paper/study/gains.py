"""How TS-100 is flown in the paper's scenarios and in the tank study.

The vehicle file has the gains that dock, and the docking automaton. The study flies the published automaton,
eq. (53), with the published guidance, and gains tuned for the paper's tables: all that differs is here, and
is written into the mission files. The paper prints no gains; every number is ours (assumed).
"""

from collections.abc import Mapping
from typing import Any

STUDY_GAINS: Mapping[str, Mapping[str, Any]] = {
    "forward": {
        "r_diagonal": [3.0, 3.0, 3.0, 3.0, 0.02, 0.05, 0.05],
        "ramp_cycles": 80,
        "kp": [20.0, 0.0, 1.5, 0.5, 25.0, 25.0],
        "ki": [2.0, 0.0, 0.05, 0.1, 4.0, 4.0],
        "kd": [0.0, 0.0, 0.0, 0.2, 50.0, 50.0],
        "integral_limit": [4.0, 0.0, 0.6, 0.3, 2.0, 2.0],
        "demand_limit": [4.4, 0.0, 1.0, 0.8, 10.0, 10.0],
        "increment_share": 1.0,
    },
    "reverse": {
        "ramp_cycles": 80,
        "kp": [20.0, 0.0, 4.0, 0.5, 40.0, 40.0],
        "ki": [0.8, 0.0, 0.1, 0.1, 10.0, 10.0],
        "kd": [0.0, 0.0, 10.0, 0.2, 70.0, 70.0],
        "integral_limit": [4.0, 0.0, 0.6, 0.3, 2.0, 2.0],
        "demand_limit": [4.4, 0.0, 1.0, 0.8, 10.0, 8.5],
        "increment_share": 1.0,
    },
    "hover": {
        "ramp_cycles": 160,
        "kp": [30.0, 0.0, 8.0, 0.5, 40.0, 40.0],
        "ki": [2.0, 0.0, 0.25, 0.1, 4.0, 4.0],
        "kd": [0.0, 0.0, 30.0, 0.2, 70.0, 70.0],
        "integral_limit": [4.0, 0.0, 0.6, 0.3, 2.0, 2.0],
        "demand_limit": [4.4, 0.0, 1.0, 0.8, 10.0, 8.5],
        "increment_share": 1.0,
    },
    "supervisor": {
        "range_rh_lower_m": 0.6,
    },
    "bumpless": {
        "ramp_smooth": False,
        "integrator_alignment": True,
        "integral_at_switch": "rescale",
        "ramp_increment_price": 3.0,
    },
    "allocation": {
        "increment_price": 0.0,
        "fins_brake": True,
        "shaft_smoothing": 0.07,
    },
    "guidance": {
        "pitch_look_ahead_m": 0.0,
        "pitch_max_deg": 20.0,
        "reverse_speed_slope_per_s": 0.07,
        "reverse_speed_offset_mps": 0.07,
        "schedule_min": 0.01,
        "flow_drift": 1.0,
        "error_filter_s": [1.0, 0.0, 2.0, 0.5, 1.0, 1.0],
        "rate_filter_s": [0.0, 0.0, 3.0, 0.5, 1.0, 1.0],
    },
    "docking": {
        "enabled": False,
    },
}
