"""All that an autopilot knows of a mission; what is true besides is the simulation's (`sim.truth`)."""

import numpy as np

from bumpless.config.capacity import MAX_WAYPOINTS
from bumpless.physics.faults import FAULTS

f8, i8 = np.float64, np.int64

PLAN = np.dtype(
    [
        ("n_legs", i8),
        ("waypoint", f8, (MAX_WAYPOINTS, 3)),  # NED, m; leg i goes from i to i + 1
        ("speed", f8, MAX_WAYPOINTS),  # of leg i, m/s
        ("target", f8, 4),  # planned marker position NED, approach heading
        ("standoff", f8),  # m before the marker
        ("dock", i8),  # 1: there is a dock to enter
        ("dock_entry", f8),  # m from its entry to the marker
        ("dock_depth", f8),  # m from its entry to where its latch closes behind the nose
        ("dock_end", f8),  # m from its entry to its stop
        ("heading_tolerance", f8),  # rad by which the approach heading may turn into the current
        ("dock_turns", i8),  # 1: the dock lies behind the marker on whatever approach heading
        ("dock_half", f8),  # half its width, m
        ("dock_radius", f8),  # of the circle about the marker that holds it, m
        ("nose", f8),  # of the vehicle, along x_b, m
        ("start", f8, 6),  # eta
        ("start_speed", f8),  # surge through water, m/s
        ("cycles", i8),  # longest duration
        ("hold_cycles", i8),  # in a row in H within d_RH^U that complete the mission; 0: never
        ("faults", FAULTS),  # that it is told of; only a fault-tolerant allocator looks
    ],
    align=True,
)
