"""How much room the records have."""

MAX_ACTUATORS = 8  # commands: an actuator may take several
MAX_WAYPOINTS, N_MODES = 64, 3
MAX_FAULTS, MAX_OUTAGES = 8, 16
