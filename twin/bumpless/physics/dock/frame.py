"""Where hull and dock are to each other, computed once for every point that may touch; and a push at a point.

A frame is floats: the hull's axes in dock axes (9, row by row), place of O_b (3) and the dock's velocity (3).
"""

from math import cos, pi, sin, sqrt

from bumpless.jit import inline, jit
from bumpless.jit.memory import floats
from bumpless.physics.frames import body_to_ned, ned_to_body

N_FRAME = 15


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


@jit
def fill_frame(dock, eta, time, frame):
    """Fill frame (N_FRAME,) of a hull at eta (6,)."""
    place, moving, axis = frame[9:12], frame[12:15], floats(3)
    dock_place(dock, time, place, moving)
    for k in range(3):
        place[k] = eta[k] - place[k]
    ned_to_body(0.0, dock.pitch, dock.heading, place, place)
    ned_to_body(0.0, dock.pitch, dock.heading, moving, moving)
    for j in range(3):
        for k in range(3):
            axis[k] = 1.0 if k == j else 0.0
        body_to_ned(eta[3], eta[4], eta[5], axis, axis)
        ned_to_body(0.0, dock.pitch, dock.heading, axis, axis)
        for k in range(3):
            frame[3 * k + j] = axis[k]


@inline
def in_dock(frame, x, y, z):
    """(a, b, c) in dock axes of a point in body axes."""
    return (
        frame[9] + frame[0] * x + frame[1] * y + frame[2] * z,
        frame[10] + frame[3] * x + frame[4] * y + frame[5] * z,
        frame[11] + frame[6] * x + frame[7] * y + frame[8] * z,
    )


@inline
def in_body(frame, a, b, c):
    """(x, y, z) in body axes of a point in dock axes."""
    a, b, c = a - frame[9], b - frame[10], c - frame[11]
    return (
        frame[0] * a + frame[3] * b + frame[6] * c,
        frame[1] * a + frame[4] * b + frame[7] * c,
        frame[2] * a + frame[5] * b + frame[8] * c,
    )


@jit
def press(dock, frame, nu, x, y, z, delta, g_a, g_b, g_c, out):
    """Add to the CONTACT record `out` what the dock does at the point (x, y, z) of the hull, `delta` deep.

    g: how the depth grows as the hull's point moves, dock axes. Normal force: Hunt and Crossley 1975,
    F = k delta (1 + c delta'), never pulling. Friction: Coulomb's, smooth through zero slip.
    """
    out.energy += 0.5 * dock.stiffness * delta * delta
    steep = sqrt(g_a * g_a + g_b * g_b + g_c * g_c)
    if steep <= 0.0:
        return  # as deep on every side: no way out is shorter
    n_a, n_b, n_c = -g_a / steep, -g_b / steep, -g_c / steep  # the way out
    u = nu[0] + nu[4] * z - nu[5] * y
    v = nu[1] + nu[5] * x - nu[3] * z
    w = nu[2] + nu[3] * y - nu[4] * x
    v_a = frame[0] * u + frame[1] * v + frame[2] * w - frame[12]
    v_b = frame[3] * u + frame[4] * v + frame[5] * w - frame[13]
    v_c = frame[6] * u + frame[7] * v + frame[8] * w - frame[14]
    leaving = v_a * n_a + v_b * n_b + v_c * n_c
    normal = dock.stiffness * delta * steep * max(0.0, 1.0 - dock.damping * leaving * steep)
    v_a, v_b, v_c = v_a - leaving * n_a, v_b - leaving * n_b, v_c - leaving * n_c
    slip = sqrt(v_a * v_a + v_b * v_b + v_c * v_c + dock.slip_speed * dock.slip_speed)
    drag = dock.friction * normal / slip if slip > 0.0 else 0.0
    f_a, f_b, f_c = normal * n_a - drag * v_a, normal * n_b - drag * v_b, normal * n_c - drag * v_c
    f_x = frame[0] * f_a + frame[3] * f_b + frame[6] * f_c
    f_y = frame[1] * f_a + frame[4] * f_b + frame[7] * f_c
    f_z = frame[2] * f_a + frame[5] * f_b + frame[8] * f_c
    out.wrench[0] += f_x
    out.wrench[1] += f_y
    out.wrench[2] += f_z
    out.wrench[3] += y * f_z - z * f_y
    out.wrench[4] += z * f_x - x * f_z
    out.wrench[5] += x * f_y - y * f_x
    out.force += normal
