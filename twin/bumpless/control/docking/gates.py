"""Gates: is the vehicle fit to join the line, to go past the gate, to go on?

Beyond the paper. `view` is the DOCKING_OUTPUT of this cycle: left, aside, off, deep and age. The approach
cone about the line is half as wide as cone_base + cone_slope * left.
"""

from math import cos, sin

from bumpless.contract.enums import (
    OFF_DEPTH,
    OFF_HEADING,
    OFF_LINE,
    OVERSHOT,
    STUCK_AT_GATE,
    TARGET_LOST,
    TOO_SLOW,
)
from bumpless.control.docking.swerve import SLIP_MOST
from bumpless.jit import jit

_NEAR_OFF = 0.35  # rad of heading error that wave off behind the gate
_FAR_OFF = 0.7  # and anywhere
_BESIDE = 1e3  # m of room for a nose that is not before the dock
NOSE_GUARD = 0.15  # m that the nose keeps before the dock's face


@jit
def cone(settings, left):
    """Half width of the approach cone `left` m before the observation point, m."""
    return settings.cone_base + settings.cone_slope * max(left, 0.0)


@jit
def can_join(settings, d_fr_l, view):
    """Whether the approach line can be joined from here going ahead. d_fr_l: where R begins, m."""
    room = view.left - d_fr_l - 3.0 * abs(view.aside) - 1.5 * settings.turn_radius * view.off
    return room > 0.0 and view.off < 0.9


@jit
def is_on_line(d_fr_l, view):
    """Whether the way round has reached the approach line with room to brake."""
    return view.left > d_fr_l + 1.0 and abs(view.aside) < 0.2 + 0.06 * view.left and view.off < 0.35


@jit
def gate_open(settings, view):
    """Whether the vehicle is fit to go past the gate: deep, straight and in line, the target in sight."""
    before = max(view.left - settings.gate_distance, 0.0)
    return (
        view.deep < settings.gate_depth
        and view.off < settings.gate_heading + 0.05 * before
        and abs(view.aside) < settings.gate_lateral + 0.1 * before
        and view.age < settings.lost_far
    )


@jit
def fit_to_brake(settings, view):
    """Whether F may hand over to R: in the cone, about straight and about deep."""
    return view.off < 0.8 and abs(view.aside) < cone(settings, view.left) and is_deep(settings, view)


@jit
def is_deep(settings, view):
    """Whether the depth is near enough for the rest to be made up on the line."""
    return view.deep < 4.0 * settings.gate_depth


@jit
def nose_room(plan, navigation, heading):
    """Way of the nose to the plane of the dock's face, m, as believed; far where the nose is beside the dock.

    heading: of the approach, rad; a dock that doesn't turn with it keeps the target's own.
    """
    axis = heading if plan.dock_turns == 1 else plan.target[3]
    eta, target = navigation.eta, navigation.target
    dx = eta[0] + plan.nose * cos(eta[5]) - target[0]
    dy = eta[1] + plan.nose * sin(eta[5]) - target[1]
    c, s = cos(axis), sin(axis)
    return -(c * dx + s * dy) if abs(-s * dx + c * dy) < plan.dock_half + 2.0 * NOSE_GUARD else _BESIDE


@jit
def fault_of(dt, settings, view, docking):
    """WaveOffReason that ends an approach now, in R or H; 0: none."""
    near = max(view.left, 0.0)
    patience = settings.lost_near if view.left < settings.gate_distance else settings.lost_far
    if view.age > patience:
        return TARGET_LOST
    if view.left < -settings.overshoot or view.room < NOSE_GUARD:
        return OVERSHOT
    if abs(view.aside) > cone(settings, near):
        return OFF_LINE
    if (near < settings.gate_distance and view.off > _NEAR_OFF) or view.off > _FAR_OFF:
        return OFF_HEADING
    if near < settings.gate_distance - 1.0 and view.deep > 3.0 * settings.gate_depth:
        return OFF_DEPTH
    if docking.gate_cycles * dt > settings.patience:
        return STUCK_AT_GATE
    fast = -docking.surge_lag > settings.lag_near and view.left < settings.gate_distance + 1.0
    if abs(docking.surge_lag) > settings.lag_most or fast or is_brake_weak(settings, docking):
        return TOO_SLOW
    return 0


@jit
def is_brake_weak(settings, docking):
    """Whether the vehicle is faster than commands astern should have left it, or a shaft sticks."""
    share = settings.unbraked_share * docking.braked
    return docking.unbraked > max(settings.unbraked_most, share) or abs(docking.slip) > SLIP_MOST


@jit
def is_out_in_hover(settings, view):
    """Whether H is outside the limits that are not waited out."""
    return abs(view.aside) > settings.hover_lateral or view.off > settings.hover_heading


@jit
def is_drifting_off(settings, view, docking):
    """Whether H is off the line and goes on drifting away from it."""
    return abs(view.aside) > settings.hover_lateral and view.aside * docking.lateral_rate > 0.0
