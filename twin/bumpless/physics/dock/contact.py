"""Contact of a hull of revolution with a dock's cone, tube, rim, back and end stop.

The hull is a row of rings of points that are fixed to it, the dock's edges are points too (`edges`): the
springs between them and the other's wall have a potential, so without damping and friction contact conserves
energy exactly. The wall is solid. A ring belongs inside the funnel or outside of it, whichever takes less
energy: so none slips through a thin wall, and crossing from one to the other makes no energy.
"""

from math import pi, sqrt

import numpy as np

from bumpless.jit import jit
from bumpless.physics.dock.edges import N_EDGES, edge, touch_edge
from bumpless.physics.dock.frame import N_FRAME, fill_frame, in_dock, press
from bumpless.physics.dock.record import HULL_RINGS, MAX_RINGS
from bumpless.physics.dock.walls import depth_outside, depth_within, inner_radius

N_WORK = N_FRAME  # scratch floats that `dock_contact` needs
POINTS = 12  # of a ring
COS, SIN = np.cos(2.0 * pi * np.arange(POINTS) / POINTS), np.sin(2.0 * pi * np.arange(POINTS) / POINTS)


def hull_rings(x: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """HULL_RINGS record, shape (1,), of a profile from nose to tail: x (m, body axis), radius (m)."""
    out = np.zeros(1, HULL_RINGS)
    at = np.linspace(0, len(x) - 1, MAX_RINGS).round().astype(int)
    out[0]["n"], out[0]["x"], out[0]["radius"] = MAX_RINGS, x[at], radius[at]
    return out


@jit
def dock_contact(dock, rings, eta, nu, time, out, work):
    """Fill the CONTACT record `out`: wrench of the dock on a hull at eta, nu (6,). work: N_WORK floats."""
    frame = work
    for k in range(6):
        out.wrench[k] = 0.0
    out.force = out.energy = 0.0
    fill_frame(dock, eta, time, frame)
    a, b, c = in_dock(frame, rings.x[0], 0.0, 0.0)
    out.nose_depth, out.nose_offset = a, sqrt(b * b + c * c)
    last, end = rings.n - 1, dock.cone_length + dock.tube_length
    reach = end + dock.entry_radius + dock.wall + abs(rings.x[0]) + abs(rings.x[last])
    if frame[9] ** 2 + frame[10] ** 2 + frame[11] ** 2 >= reach * reach:
        return
    beside, widest = dock.entry_radius + dock.wall, 0.0
    for i in range(rings.n):
        r = rings.radius[i]
        widest = max(widest, r)
        a, b, c = in_dock(frame, rings.x[i], 0.0, 0.0)
        aside = sqrt(b * b + c * c)
        if a + r <= 0.0 or a - r >= end + dock.wall or aside - r >= beside:
            continue
        if a + r >= end or aside + r >= inner_radius(dock, a + r):
            touch_ring(dock, frame, rings.x[i], r, nu, out)
    reach = widest + (rings.x[0] - rings.x[last]) / last
    for k in range(N_EDGES):
        depth, radius = edge(dock, k)
        near = False
        for i in range(rings.n):
            a, b, c = in_dock(frame, rings.x[i], 0.0, 0.0)
            near |= (a - depth) ** 2 + (sqrt(b * b + c * c) - radius) ** 2 < reach * reach
        if near:
            touch_edge(dock, rings, k, frame, nu, out)


@jit
def touch_ring(dock, frame, x, r, nu, out):
    """Add to `out` what the dock does to the ring of radius r at x, body axes."""
    count = POINTS if r > 0.0 else 1
    inside = outside = 0.0
    for j in range(count):
        a, b, c = in_dock(frame, x, r * COS[j], r * SIN[j])
        rho = sqrt(b * b + c * c)
        inside += depth_within(dock, a, rho)[0] ** 2
        outside += depth_outside(dock, a, rho)[0] ** 2
    if inside == 0.0 or outside == 0.0:
        return
    for j in range(count):
        y, z = r * COS[j], r * SIN[j]
        a, b, c = in_dock(frame, x, y, z)
        rho = sqrt(b * b + c * c)
        if inside <= outside:
            delta, g_a, g_rho = depth_within(dock, a, rho)
        else:
            delta, g_a, g_rho = depth_outside(dock, a, rho)
        if delta > 0.0:
            g_b, g_c = (g_rho * b / rho, g_rho * c / rho) if rho > 0.0 else (0.0, 0.0)
            press(dock, frame, nu, x, y, z, delta, g_a, g_b, g_c, out)
