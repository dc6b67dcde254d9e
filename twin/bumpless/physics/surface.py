"""The water's surface: what of the hull is out of it floats nothing.

Archimedes: buoyancy is the weight of the water that the hull's sections displace, each cut at the surface
above its middle. Left out: that fins and screws lose their grip in air, and that added mass and drag fall.
"""

from math import acos, cos, pi, sin, sqrt

from bumpless.jit import inline, jit

GRAVITY = 9.80665  # m/s^2, of waves


@inline
def share_out(depth, radius):
    """Share of a circle that is above the surface, its middle at `depth`, m."""
    h = depth / radius
    if h >= 1.0:
        return 0.0
    if h <= -1.0:
        return 1.0
    return (acos(h) - h * sqrt(1.0 - h * h)) / pi


@inline
def elevation(environment, time, north, east):
    """Height of the surface over still water, m: of the wave whose orbital motion `add_wave` has."""
    if environment.wave_height <= 0.0 or environment.wave_period <= 0.0:
        return 0.0
    omega = 2.0 * pi / environment.wave_period
    along = north * cos(environment.wave_direction) + east * sin(environment.wave_direction)
    return 0.5 * environment.wave_height * cos(omega * omega / GRAVITY * along - omega * time)


@jit
def lose_buoyancy(model, environment, time, eta, tau):
    """Take from tau (6,) the buoyancy of what is out of the water at eta (6,); nothing of a hull below it."""
    rings, last = model.rings, model.rings.n - 1
    st, ct = sin(eta[4]), cos(eta[4])
    longest = max(abs(rings.x[0]), abs(rings.x[last])) if last > 0 else 0.0
    if eta[2] >= abs(st) * longest + model.half_height + 0.5 * environment.wave_height:
        return
    whole, lost, moment = 0.0, 0.0, 0.0
    if last <= 0:
        surface = elevation(environment, time, eta[0], eta[1])
        whole, lost = 1.0, share_out(eta[2] + surface, model.half_height)
    for i in range(rings.n):
        x, area = rings.x[i], rings.radius[i] ** 2
        whole += area
        if area > 0.0:
            surface = elevation(
                environment, time, eta[0] + x * ct * cos(eta[5]), eta[1] + x * ct * sin(eta[5])
            )
            out = area * share_out(eta[2] - x * st + surface, rings.radius[i])
            lost, moment = lost + out, moment + out * x
    push, turn = model.buoyancy * lost / whole, model.buoyancy * moment / whole
    side, down = ct * sin(eta[3]), ct * cos(eta[3])
    tau[0] -= push * st
    tau[1] += push * side
    tau[2] += push * down
    tau[4] -= turn * down
    tau[5] += turn * side
