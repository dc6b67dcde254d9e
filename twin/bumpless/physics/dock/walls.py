"""How deep a point is in a dock's wall, from within the funnel and from outside of it.

Both depths are continuous everywhere, at corners too: else a hull that slides over one would be given energy.
In dock axes a point is at (a, rho), along the axis and off it. A gradient points where the depth grows.
"""

from math import sqrt

from bumpless.jit import inline


@inline
def slopes(dock):
    """(slope, c) of the cone: how fast it closes in, -dR/da, and the cosine of its half angle."""
    slope = (dock.entry_radius - dock.tube_radius) / dock.cone_length
    return slope, 1.0 / sqrt(1.0 + slope * slope)


@inline
def inner_radius(dock, a):
    """Inner radius of the funnel at depth a, m."""
    return max(dock.tube_radius, dock.entry_radius - slopes(dock)[0] * a)


@inline
def depth_within(dock, a, rho):
    """(delta, d delta/da, d delta/d rho) of a point that belongs inside the funnel: its way back there, m.

    The wall has no outside here, and the stop no back. Where wall and stop meet it is the way to the corner.
    """
    if a <= 0.0:
        return 0.0, 0.0, 0.0
    slope, c = slopes(dock)
    cone = (rho - dock.entry_radius + slope * a) * c
    wall, g_a, g_rho = rho - dock.tube_radius, 0.0, 1.0
    if cone < wall:
        wall, g_a, g_rho = cone, slope * c, c
    if a < wall:
        wall, g_a, g_rho = a, 1.0, 0.0  # back before the rim is shorter
    over = a - dock.cone_length - dock.tube_length
    if over <= 0.0:
        return (wall, g_a, g_rho) if wall > 0.0 else (0.0, 0.0, 0.0)
    if wall <= 0.0:
        return over, 1.0, 0.0
    delta = sqrt(over * over + wall * wall)
    return delta, (over + wall * g_a) / delta, wall * g_rho / delta


@inline
def depth_outside(dock, a, rho):
    """The same of a point that belongs outside: the dock is solid, from rim to back."""
    back = dock.cone_length + dock.tube_length + dock.wall - a
    if a <= 0.0 or back <= 0.0:
        return 0.0, 0.0, 0.0
    slope, c = slopes(dock)
    cone = (dock.entry_radius - slope * a + dock.wall - rho) * c
    wall, g_a, g_rho = dock.tube_radius + dock.wall - rho, 0.0, -1.0
    if cone > wall:
        wall, g_a, g_rho = cone, -slope * c, -c
    if wall <= 0.0:
        return 0.0, 0.0, 0.0
    if a < wall and a <= back:
        return a, 1.0, 0.0
    if back < wall:
        return back, -1.0, 0.0
    return wall, g_a, g_rho
