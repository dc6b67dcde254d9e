"""How much room the records have."""

MAX_ACTUATORS = 8  # commands: an actuator may take several
MAX_WAYPOINTS, N_MODES = 64, 3
MAX_FAULTS, MAX_OUTAGES = 8, 16
MAX_CAMERAS, MAX_FRAMES = 2, 64  # a wide and a near one; frames on their way through the detector
MAX_PROFILE, MAX_WEIGHTS = 8, 8  # depths of a current's profile; weights that were put on or moved
