"""How a vehicle node's process ends: the server that started it acts on the code."""

STOPPED, FAILED, TAKEN = 0, 1, 3  # asked for; could not go on; the vehicle id is alive already
