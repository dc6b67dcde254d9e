"""From hover into a dock that can be entered: along its axis, slowly, with its own gates. Beyond the paper.

The gates count while the nose is before the entry; inside, the funnel leads and only time is limited.
view: DOCKING_OUTPUT; docking: DOCKING_STATE.
"""

from bumpless.contract.enums import (
    APPROACH,
    CAPTURED,
    CREEP,
    HOVER,
    OFF_DEPTH,
    OFF_HEADING,
    OFF_LINE,
    REVERSE,
    STUCK_AT_GATE,
    TARGET_LOST,
)
from bumpless.control.docking.heading import along_across
from bumpless.control.docking.line import steer
from bumpless.control.docking.waveoff import enter, wave_off
from bumpless.jit import inline, jit


@inline
def before_entry(plan, nose, view):
    """Way from the nose, `nose` m ahead of O_b, to the dock's entry, m; negative inside."""
    return view.left + plan.standoff - nose - plan.dock_entry


@jit
def creep_fault(dt, settings, cycle, outside, view, docking):
    """WaveOffReason that ends the way in; 0: none. outside: the nose is before the entry."""
    if (cycle - docking.stage_cycle) * dt > settings.creep_time:
        return STUCK_AT_GATE
    if not outside:
        return 0
    if view.age > settings.lost_near:
        return TARGET_LOST
    if abs(view.aside) > settings.creep_lateral:
        return OFF_LINE
    if view.off > settings.creep_heading:
        return OFF_HEADING
    return OFF_DEPTH if view.deep > settings.creep_depth else 0


@jit
def creep_mode(cycle, dt, settings, plan, nose, mode, view, docking):
    """Begin the way in after a stable hover, end it by a wave-off; returns the mode to fly."""
    if docking.stage == APPROACH and docking.still * dt >= settings.creep_after:
        enter(cycle, CREEP, docking)
        docking.cleared = 1
    elif docking.stage == CREEP:
        outside = before_entry(plan, nose, view) > 0.0
        reason = creep_fault(dt, settings, cycle, outside, view, docking)
        if reason > 0:
            wave_off(cycle, settings, reason, view, docking)
            return REVERSE
        return HOVER
    return mode


@jit
def creep_references(dt, settings, plan, navigation, u_d, view, docking):
    """(u goal, z goal, psi_d) on the way in: over ground at the creep's speed, bow along the axis."""
    along, _ = along_across(navigation.current, docking.heading)
    psi_d = steer(dt, settings, navigation.current, u_d - along, True, settings.crab_near, view, docking)
    return settings.creep_speed, navigation.target[2], psi_d


@jit
def note_capture(cycle, docking):
    """The latch has closed: nothing is left to do, whatever the stage was."""
    if docking.stage > 0 and docking.stage != CAPTURED:
        enter(cycle, CAPTURED, docking)


@jit
def note_still(in_place, docking):
    """Count the cycles in a row in place before a dock to enter."""
    docking.still = docking.still + 1 if in_place else 0
