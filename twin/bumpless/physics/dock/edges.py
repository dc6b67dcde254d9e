"""The dock's edges against the hull: rims and throat, which stick into a flank between the hull's rings.

An edge is a circle of points that are fixed to the dock; the depth of one in the hull is r(x) - d, its radius
there less the distance from its axis, and no more than the way out of either end. So these springs too have a
potential.
"""

from math import pi, sqrt

import numpy as np

from bumpless.jit import inline, jit
from bumpless.physics.dock.frame import in_body, press

POINTS = 48  # of an edge
COS, SIN = np.cos(2.0 * pi * np.arange(POINTS) / POINTS), np.sin(2.0 * pi * np.arange(POINTS) / POINTS)
N_EDGES = 4  # rim inside and outside, throat, outer edge of the back


@inline
def edge(dock, i):
    """(a, rho) of edge i, m, in dock axes."""
    if i == 0:
        return 0.0, dock.entry_radius
    if i == 1:
        return 0.0, dock.entry_radius + dock.wall
    if i == 2:
        return dock.cone_length, dock.tube_radius
    return dock.cone_length + dock.tube_length + dock.wall, dock.tube_radius + dock.wall


@inline
def depth_in_hull(rings, x, d):
    """(delta, d delta/dx, d delta/dd) of a point at x and d off the axis, body axes, m."""
    last = rings.n - 1
    ahead, behind = rings.x[0] - x, x - rings.x[last]
    if ahead <= 0.0 or behind <= 0.0:
        return 0.0, 0.0, 0.0
    i = min(last - 1, int(ahead / (rings.x[0] - rings.x[last]) * last))
    while i > 0 and rings.x[i] < x:
        i -= 1
    while i < last - 1 and rings.x[i + 1] > x:
        i += 1
    slope = (rings.radius[i] - rings.radius[i + 1]) / (rings.x[i] - rings.x[i + 1])
    delta = rings.radius[i] + slope * (x - rings.x[i]) - d
    if delta <= 0.0:
        return 0.0, 0.0, 0.0
    if ahead < delta and ahead <= behind:
        return ahead, -1.0, 0.0
    if behind < delta:
        return behind, 1.0, 0.0
    return delta, slope, -1.0


@jit
def touch_edge(dock, rings, i, frame, nu, out):
    """Add to `out` what edge i of the dock does to the hull."""
    a, rho = edge(dock, i)
    for j in range(POINTS):
        x, y, z = in_body(frame, a, rho * COS[j], rho * SIN[j])
        d = sqrt(y * y + z * z)
        delta, g_x, g_d = depth_in_hull(rings, x, d)
        if delta <= 0.0:
            continue
        g_y, g_z = (g_d * y / d, g_d * z / d) if d > 0.0 else (0.0, 0.0)
        # the hull moves against the edge's way in it
        g_a = -(frame[0] * g_x + frame[1] * g_y + frame[2] * g_z)
        g_b = -(frame[3] * g_x + frame[4] * g_y + frame[5] * g_z)
        g_c = -(frame[6] * g_x + frame[7] * g_y + frame[8] * g_z)
        press(dock, frame, nu, x, y, z, delta, g_a, g_b, g_c, out)
