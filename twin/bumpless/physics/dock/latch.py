"""A dock as the plant meets it: contact, its motion, and the latch that closes behind a nose deep enough.

The latch is a one-way stop: it lets the nose go deeper and pulls it back, along the axis, once it comes out
beyond the capture depth. The same spring and damping as of a contact, F = k g (1 + c g').
"""

from math import cos, sin, sqrt

from bumpless.jit import inline, jit
from bumpless.jit.memory import floats
from bumpless.physics.dock.contact import N_WORK, dock_contact
from bumpless.physics.dock.frame import N_FRAME, dock_place, fill_frame, in_dock
from bumpless.physics.frames import body_to_ned, ned_to_body

MARGIN = 0.1  # m before a touch from which on steps are finer


@inline
def can_touch(dock, rings, eta):
    """Whether there is a dock near enough to be touched by a hull at eta (6,): cheap, and wide."""
    if dock.present == 0:
        return False
    reach = dock.cone_length + dock.tube_length + dock.entry_radius + 2.0 * dock.wall
    reach += abs(rings.x[0]) + abs(rings.x[rings.n - 1])
    distance2 = 0.0
    for k in range(3):
        reach += abs(dock.amplitude[k])
        distance2 += (eta[k] - dock.entry[k]) ** 2
    return distance2 < reach * reach


@jit
def steps_near(dock, rings, eta, nu, dt, substeps):
    """Runge-Kutta steps for the next dt seconds: `substeps`, or those of a hull that may touch by then."""
    if not can_touch(dock, rings, eta):
        return substeps
    frame, speed2 = floats(N_FRAME), nu[0] * nu[0] + nu[1] * nu[1] + nu[2] * nu[2]
    fill_frame(dock, eta, 0.0, frame)
    margin = MARGIN + dt * sqrt(speed2)
    for k in range(3):
        margin += 2.0 * abs(dock.amplitude[k])
    back = dock.cone_length + dock.tube_length + dock.wall + margin
    beside = dock.entry_radius + dock.wall + margin
    for i in range(rings.n):
        r = rings.radius[i]
        a, b, c = in_dock(frame, rings.x[i], 0.0, 0.0)
        if -margin - r < a < back + r and b * b + c * c < (beside + r) * (beside + r):
            return max(substeps, dock.steps)
    return substeps


@jit
def feel_dock(dock, rings, eta, nu, time, tau):
    """Add to tau (6,) what the dock does to a hull at eta, nu (6,); fills dock.felt.

    rings: HULL_RINGS, the nose first.
    """
    work, felt = floats(N_WORK), dock.felt
    dock_contact(dock, rings, eta, nu, time, felt, work)
    if dock.captured == 1:
        pull_latch(dock, rings, eta, nu, time, felt)
    felt.peak = max(felt.peak, felt.force)
    for k in range(6):
        tau[k] += felt.wrench[k]


@jit
def pull_latch(dock, rings, eta, nu, time, felt):
    """Add the latch's pull to felt.wrench, and the energy it stores."""
    gap = dock.capture_depth - felt.nose_depth
    if gap <= 0.0:
        return
    axis, v, middle, moving = floats(3), floats(3), floats(3), floats(3)
    x = rings.x[0]
    v[0], v[1], v[2] = nu[0], nu[1] + nu[5] * x, nu[2] - nu[4] * x
    body_to_ned(eta[3], eta[4], eta[5], v, v)
    dock_place(dock, time, middle, moving)
    dock_axis(dock, axis)
    opening = 0.0
    for k in range(3):
        opening -= (v[k] - moving[k]) * axis[k]
    pull = dock.stiffness * gap * max(0.0, 1.0 + dock.damping * opening)
    ned_to_body(eta[3], eta[4], eta[5], axis, axis)
    for k in range(3):
        felt.wrench[k] += pull * axis[k]
    felt.wrench[4] -= x * pull * axis[2]
    felt.wrench[5] += x * pull * axis[1]
    felt.energy += 0.5 * dock.stiffness * gap * gap


@inline
def dock_axis(dock, axis):
    """Fill axis (3,): unit vector into the dock, NED."""
    axis[0], axis[1] = cos(dock.heading) * cos(dock.pitch), sin(dock.heading) * cos(dock.pitch)
    axis[2] = -sin(dock.pitch)


@jit
def close_latch(dock):
    """Capture a nose that is deep enough and in the tube; once closed it stays closed."""
    felt = dock.felt
    if felt.nose_depth >= dock.capture_depth and felt.nose_offset <= dock.tube_radius:
        dock.captured = 1


@jit
def move_marker(dock, time, target):
    """Put the marker, target (3,) NED, m, where the moving dock has it at `time`, s."""
    velocity = floats(3)
    dock_place(dock, time, target, velocity)
    for k in range(3):
        target[k] += dock.marker[k]
