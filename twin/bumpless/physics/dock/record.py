"""The dock as compiled code reads it, what touching it does, and the hull as rings that can touch.

Dock axes: origin in the middle of the entry, a along the axis into the dock, b to the right of it, c down.
"""

import numpy as np

f8, i8 = np.float64, np.int64
MAX_RINGS = 24

CONTACT = np.dtype(  # as last computed; zero away from the dock
    [
        ("wrench", f8, 6),  # of the dock on the hull, body axes about O_b, N and N m
        ("force", f8),  # sum of the normal forces, N
        ("peak", f8),  # largest of them in this control period, N
        ("energy", f8),  # stored in the contacts, sum of k delta^2 / 2, J
        ("nose_depth", f8),  # of the nose behind the entry, m; negative before it
        ("nose_offset", f8),  # of the nose from the axis, m
    ],
    align=True,
)

DOCK = np.dtype(
    [
        ("present", i8),  # 1 when there is a dock to enter
        ("entry", f8, 3),  # middle of the entry at rest, NED, m
        ("heading", f8),  # of the axis into the dock, rad
        ("pitch", f8),  # of the axis, rad, positive nose up
        ("entry_radius", f8),  # m
        ("tube_radius", f8),  # m
        ("cone_length", f8),  # m
        ("tube_length", f8),  # m, to the stop at its end
        ("wall", f8),  # thickness, m
        ("capture_depth", f8),  # of the nose behind the entry from which the latch closes, m
        ("stiffness", f8),  # k, N/m, of one contact
        ("damping", f8),  # c of F = k delta (1 + c delta'), s/m
        ("friction", f8),  # mu
        ("slip_speed", f8),  # m/s below which friction fades, so that it stays smooth
        # a hung dock moves: position = entry + amplitude sin(2 pi t / period + phase)
        ("amplitude", f8, 3),  # north, east, down, m
        ("period", f8),  # s; 0: it stands still
        ("phase", f8),  # rad
        ("marker", f8, 3),  # the marker from the middle of the entry, NED, m
        ("force_most", f8),  # N, that dock and hull bear
        ("captured", i8),  # 1: the latch has closed
        ("steps", i8),  # Runge-Kutta steps that a control period near it takes at least
        ("felt", CONTACT),
    ],
    align=True,
)

HULL_RINGS = np.dtype([("n", i8), ("x", f8, MAX_RINGS), ("radius", f8, MAX_RINGS)], align=True)
