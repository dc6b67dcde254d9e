"""Is the dwell time long enough? Proposition 2 checked on the closed loop itself, by finite differences.

For each mode the compiled cycle (plant, navigation, PID, allocation) is linearised about its reference;
for each switch so is everything from the last cycle of one mode to the end of the ramp into the next. A
multiple quadratic Lyapunov function then gives the contraction rho, the jump mu and the smallest dwell.
Source: Gao et al. 2026, Proposition 2: stable if mu rho^N_dwell < 1.
"""

from bumpless.stability.dwell import Dwell, check_dwell, dwell_warning

__all__ = ["Dwell", "check_dwell", "dwell_warning"]
