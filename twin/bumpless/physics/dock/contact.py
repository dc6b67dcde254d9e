"""Contact of a hull of revolution with a dock's cone, tube, rim and end stop.

The hull is a row of rings of points that are fixed to it, so that the springs between them and the wall have
a potential: without damping and friction contact conserves energy exactly. The wall is solid: a point inside
it is pushed back into the funnel when its ring's middle is within, off the outside when it is not, and back
before the rim where that is shorter. Normal force: Hunt and Crossley 1975, F = k delta (1 + c delta'),
never pulling. Friction: Coulomb's, smooth through zero slip.
"""

from math import cos, pi, sin, sqrt

import numpy as np

from bumpless.jit import inline, jit
from bumpless.physics.dock.record import HULL_RINGS, MAX_RINGS
from bumpless.physics.frames import body_to_ned, ned_to_body

N_WORK = 15  # scratch floats that `dock_contact` needs
POINTS = 12  # of a ring
COS, SIN = np.cos(2.0 * pi * np.arange(POINTS) / POINTS), np.sin(2.0 * pi * np.arange(POINTS) / POINTS)


def hull_rings(x: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """HULL_RINGS record, shape (1,), of a profile from nose to tail: x (m, body axis), radius (m)."""
    out = np.zeros(1, HULL_RINGS)
    at = np.linspace(0, len(x) - 1, MAX_RINGS).round().astype(int)
    out[0]["n"], out[0]["x"], out[0]["radius"] = MAX_RINGS, x[at], radius[at]
    return out


@jit
def dock_place(dock, time, position, velocity):
    """Fill position and velocity (3,), NED, of the middle of the entry at `time`."""
    for k in range(3):
        position[k], velocity[k] = dock.entry[k], 0.0
    if dock.period > 0.0:
        omega = 2.0 * pi / dock.period
        s, c = sin(omega * time + dock.phase), omega * cos(omega * time + dock.phase)
        for k in range(3):
            position[k] += dock.amplitude[k] * s
            velocity[k] = dock.amplitude[k] * c


@inline
def inner_radius(dock, a):
    """(R, slope): inner radius of the funnel at depth a, m, and how fast the wall closes in, -dR/da."""
    if a >= dock.cone_length:
        return dock.tube_radius, 0.0
    slope = (dock.entry_radius - dock.tube_radius) / dock.cone_length
    return dock.entry_radius - slope * a, slope


@inline
def penetration(dock, a, rho, within):
    """(delta, n_a, n_rho): depth of a point at (a, rho) in the dock's wall, m, and the way out of it.

    n points out of the wall, along the axis and along the radius; within: the way out is inwards. delta 0: no
    contact.
    """
    end = dock.cone_length + dock.tube_length
    if a < 0.0:
        return 0.0, 0.0, 0.0
    if a > end:
        if rho < dock.tube_radius + dock.wall and a < end + dock.wall:
            return a - end, -1.0, 0.0
        return 0.0, 0.0, 0.0
    radius, slope = inner_radius(dock, a)
    c = 1.0 / sqrt(1.0 + slope * slope)
    delta = (rho - radius if within else radius + dock.wall - rho) * c
    if delta <= 0.0:
        return 0.0, 0.0, 0.0
    if a < delta:
        return a, -1.0, 0.0
    return (delta, -slope * c, -c) if within else (delta, slope * c, c)


@jit
def dock_contact(dock, rings, eta, nu, time, out, work):
    """Fill the CONTACT record `out`: wrench of the dock on a hull at eta, nu (6,). work: N_WORK floats."""
    for k in range(6):
        out.wrench[k] = 0.0
    out.force = out.energy = 0.0
    end = dock.cone_length + dock.tube_length
    middle, moving, p, v, f = work[0:3], work[3:6], work[6:9], work[9:12], work[12:15]
    dock_place(dock, time, middle, moving)
    reach = (
        dock.cone_length
        + dock.tube_length
        + dock.entry_radius
        + dock.wall
        + abs(rings.x[0])
        + abs(rings.x[rings.n - 1])
    )
    distance2 = 0.0
    for k in range(3):
        distance2 += (eta[k] - middle[k]) ** 2
    near = distance2 < reach * reach
    for i in range(rings.n if near else 1):
        x, r = rings.x[i], rings.radius[i]
        # the ring's middle in dock axes
        p[0], p[1], p[2] = x, 0.0, 0.0
        body_to_ned(eta[3], eta[4], eta[5], p, p)
        for k in range(3):
            p[k] += eta[k] - middle[k]
        ned_to_body(0.0, dock.pitch, dock.heading, p, p)
        if i == 0:
            out.nose_depth, out.nose_offset = p[0], sqrt(p[1] * p[1] + p[2] * p[2])
            if not near:
                return
        aside = sqrt(p[1] * p[1] + p[2] * p[2])
        radius, _ = inner_radius(dock, max(p[0], 0.0))
        within = aside < radius + 0.5 * dock.wall
        room = min(radius, inner_radius(dock, max(p[0] + r, 0.0))[0]) if p[0] + r < end else 0.0
        if p[0] + r < 0.0 or (within and aside + r < room):
            continue  # before the entry, or clear of wall and stop however the ring is tilted
        for j in range(POINTS if r > 0.0 else 1):
            touch(dock, eta, nu, middle, moving, x, r * COS[j], r * SIN[j], within, out, f, v)


@jit
def touch(dock, eta, nu, middle, moving, x, y, z, within, out, f, v):
    """Add to `out` what the dock does to the point (x, y, z) of the hull, body axes. f, v: scratch (3,)."""
    p = f
    p[0], p[1], p[2] = x, y, z
    body_to_ned(eta[3], eta[4], eta[5], p, p)
    for k in range(3):
        p[k] += eta[k] - middle[k]
    ned_to_body(0.0, dock.pitch, dock.heading, p, p)
    rho = sqrt(p[1] * p[1] + p[2] * p[2])
    delta, n_a, n_rho = penetration(dock, p[0], rho, within)
    if delta <= 0.0:
        return
    n_b, n_c = (n_rho * p[1] / rho, n_rho * p[2] / rho) if rho > 0.0 else (0.0, 0.0)
    v[0] = nu[0] + nu[4] * z - nu[5] * y
    v[1] = nu[1] + nu[5] * x - nu[3] * z
    v[2] = nu[2] + nu[3] * y - nu[4] * x
    body_to_ned(eta[3], eta[4], eta[5], v, v)
    for k in range(3):
        v[k] -= moving[k]
    ned_to_body(0.0, dock.pitch, dock.heading, v, v)
    leaving = v[0] * n_a + v[1] * n_b + v[2] * n_c
    normal = dock.stiffness * delta * max(0.0, 1.0 - dock.damping * leaving)
    v[0], v[1], v[2] = v[0] - leaving * n_a, v[1] - leaving * n_b, v[2] - leaving * n_c
    slip = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + dock.slip_speed * dock.slip_speed)
    drag = dock.friction * normal / slip if slip > 0.0 else 0.0
    f[0], f[1], f[2] = normal * n_a - drag * v[0], normal * n_b - drag * v[1], normal * n_c - drag * v[2]
    body_to_ned(0.0, dock.pitch, dock.heading, f, f)
    ned_to_body(eta[3], eta[4], eta[5], f, f)
    out.wrench[0] += f[0]
    out.wrench[1] += f[1]
    out.wrench[2] += f[2]
    out.wrench[3] += y * f[2] - z * f[1]
    out.wrench[4] += z * f[0] - x * f[2]
    out.wrench[5] += x * f[1] - y * f[0]
    out.force += normal
    out.energy += 0.5 * dock.stiffness * delta * delta
