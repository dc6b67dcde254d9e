"""How much room the records have."""

MAX_ACTUATORS = 8  # commands: an actuator may take several
MAX_WAYPOINTS, N_MODES = 512, 3  # a plan of 511 legs is 16 kB, which no cycle copies
MAX_FAULTS, MAX_OUTAGES = 8, 16
MAX_CAMERAS, MAX_FRAMES = 2, 64  # a wide and a near one; frames on their way through the detector
MAX_PROFILE, MAX_WEIGHTS = 8, 8  # depths of a current's profile; weights that were put on or moved
