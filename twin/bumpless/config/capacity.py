"""How much room the records have."""

MAX_ACTUATORS, MAX_WAYPOINTS, N_MODES = 8, 64, 3
MAX_FAULTS, MAX_OUTAGES = 8, 16
