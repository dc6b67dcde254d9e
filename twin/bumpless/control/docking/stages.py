"""The docking automaton: TRANSIT -> ENTRY -> APPROACH, and BACK after a wave-off, until HOLD.

Beyond the paper. Each function decides one stage for this cycle and returns the mode to fly. H to F along a
leg that crosses the dock can't happen: F is flown in TRANSIT and ENTRY, which keep clear of the dock, and in
APPROACH before `break_off`.

supervisor: SUPERVISOR_SETTINGS, whose thresholds d_FR^L, d_RH^L and d_RH^U apply along the line;
view: DOCKING_OUTPUT; docking: DOCKING_STATE.
"""

from math import hypot

from bumpless.contract.enums import (
    APPROACH,
    BACK,
    CREEP,
    CURRENT,
    ENTRY,
    FORWARD,
    HOVER,
    NOT_SEEN,
    OFF_DEPTH,
    OFF_LINE,
    REVERSE,
    TOO_SLOW,
    TRANSIT,
)
from bumpless.control.docking.entry import keep_out
from bumpless.control.docking.gates import (
    can_join,
    cone,
    fault_of,
    fit_to_brake,
    gate_open,
    is_brake_weak,
    is_deep,
    is_drifting_off,
    is_on_line,
    is_out_in_hover,
    nose_room,
)
from bumpless.control.docking.heading import along_across, choose_heading, follow_current, holdable, turned
from bumpless.control.docking.line import place_on_line
from bumpless.control.docking.swerve import is_past
from bumpless.control.docking.waveoff import begin_approach, begin_entry, give_up, wave_off
from bumpless.control.guidance.station import observation_point
from bumpless.jit import jit
from bumpless.physics.frames import wrap

_DECIDE_S = 8.0  # of current estimate before the approach heading is chosen
_TURN_STEP, _TURNS = 0.05, 6  # rad, how many each way: approach headings tried to join the line at once
_NO_FLOW = 0.04  # m/s along the hull: with less of it nothing brings back what drifts off,
_IN_VAIN = 3  # and patience ends so many times as fast
_WAITED_S = 240.0  # after which a way back that doesn't arrive is over
_WATCHED_M = 6.0  # before the switch, from which on in F a weak brake is told from a turn that has just ended


@jit
def see_line(dt, plan, navigation, detected, point, docking, view):
    """Fill the observation point (3,), NED m, and what of DOCKING_OUTPUT the automaton goes by."""
    eta = navigation.eta
    observation_point(navigation.target, docking.heading, plan.standoff, point)
    place_on_line(eta, point, docking.heading, view)
    view.off = abs(wrap(eta[5] - docking.heading))
    view.deep = abs(eta[2] - navigation.target[2])
    view.room = nose_room(plan, navigation, docking.heading)
    view.age, view.detected = docking.fix_age * dt, detected


@jit
def in_transit(clock, settings, supervisor, plan, navigation, leg, point, view, docking):
    """On the last leg and near: choose the approach heading, and join the line or fly round to it."""
    eta, target = navigation.eta, navigation.target
    far = hypot(target[0] - eta[0], target[1] - eta[1])
    reach = settings.entry_distance + 2.0 * settings.turn_radius
    known = clock.time > _DECIDE_S and far < reach
    if leg < plan.n_legs - 1 or not (known or far < settings.entry_distance):
        return FORWARD
    docking.heading = choose_heading(settings, plan, navigation.current)
    see_at(plan, navigation, docking.heading, point, view)
    if not holdable(settings, navigation.current, docking.heading):
        give_up(clock.cycle, settings, CURRENT, view, docking)
        return HOVER
    if join_near(settings, supervisor.d_fr_l, plan, navigation, point, view, docking):
        begin_approach(clock.cycle, docking)
    else:
        begin_entry(clock.cycle, settings, plan, navigation, point, docking)
    return FORWARD


@jit
def join_near(settings, d_fr_l, plan, navigation, point, view, docking):
    """Whether the line can be joined from here, at docking.heading or at one a little off it that is within
    the tolerance and can be held: the line then turns on the way (`follow_current`). Fills the heading."""
    wanted = docking.heading
    for k in range(2 * _TURNS + 1):
        off = _TURN_STEP * ((k + 1) // 2) * (1 - 2 * (k % 2))
        heading = turned(plan.target[3], plan.heading_tolerance, wanted + off)
        see_at(plan, navigation, heading, point, view)
        if can_join(settings, d_fr_l, view) and (k == 0 or holdable(settings, navigation.current, heading)):
            docking.heading = heading
            return True
    see_at(plan, navigation, wanted, point, view)
    return False


@jit
def see_at(plan, navigation, heading, point, view):
    """Fill the observation point (3,) and where the vehicle is on its line, as at a heading, rad."""
    observation_point(navigation.target, heading, plan.standoff, point)
    place_on_line(navigation.eta, point, heading, view)
    view.off = abs(wrap(navigation.eta[5] - heading))


@jit
def in_entry(cycle, supervisor, view, docking):
    """On the way round: begin the approach once on the line."""
    if is_on_line(supervisor.d_fr_l, view):
        begin_approach(cycle, docking)
    return FORWARD


@jit
def approach_ahead(cycle, settings, supervisor, view, docking):
    """In F on the line: brake where fit to, break off where not."""
    docking.cleared = 1 if view.detected == 1 and gate_open(settings, view) else 0
    if view.detected == 1 and view.left <= supervisor.d_fr_l and fit_to_brake(settings, view):
        return REVERSE
    if view.left <= supervisor.d_fr_l + _WATCHED_M and is_brake_weak(settings, docking):
        wave_off(cycle, settings, TOO_SLOW, view, docking)
        return REVERSE
    if abs(docking.surge_lag) > 2.0 * settings.lag_most:
        give_up(cycle, settings, TOO_SLOW, view, docking)
        return HOVER
    if view.left <= settings.break_off:
        off = OFF_LINE if is_deep(settings, view) else OFF_DEPTH
        wave_off(cycle, settings, NOT_SEEN if view.detected == 0 else off, view, docking)
        return REVERSE
    return FORWARD


@jit
def watch_gate(settings, mode, along, view, docking):
    """Open the gate, and count how long it stays shut, or how long H is out of its limits."""
    if view.left > settings.gate_distance or docking.cleared == 0:
        docking.cleared = 1 if gate_open(settings, view) else 0
        if docking.cleared == 0 and view.left < settings.gate_distance + 0.5:
            docking.gate_cycles += 1
    elif mode == HOVER:
        out = is_out_in_hover(settings, view)
        in_vain = abs(along) < _NO_FLOW and is_drifting_off(settings, view, docking)
        worse = _IN_VAIN if in_vain else 1
        docking.gate_cycles = docking.gate_cycles + worse if out else max(docking.gate_cycles - 2, 0)


@jit
def approach_near(cycle, dt, settings, supervisor, mode, current, view, docking):
    """In R and H on the line."""
    watch_gate(settings, mode, along_across(current, docking.heading)[0], view, docking)
    reason = fault_of(dt, settings, view, docking)
    if reason > 0:
        wave_off(cycle, settings, reason, view, docking)
        return REVERSE
    if mode == REVERSE:
        return HOVER if view.left <= supervisor.d_rh_l and docking.cleared == 1 else REVERSE
    return REVERSE if view.left >= supervisor.d_rh_u else HOVER


@jit
def go_around(cycle, settings, plan, navigation, blind, point, view, docking):
    """At the hold point: approach again from here or from the line's beginning, or give up."""
    if docking.tried >= settings.tries or docking.reason == TOO_SLOW:
        give_up(cycle, settings, docking.reason, view, docking)
        return HOVER
    heading = choose_heading(settings, plan, navigation.current)
    if not holdable(settings, navigation.current, heading):
        give_up(cycle, settings, CURRENT, view, docking)
        return HOVER
    straight = abs(wrap(heading - docking.heading)) < 0.1 and view.off < 0.6
    if not blind and straight and abs(view.aside) < 0.8 * cone(settings, view.left):
        begin_approach(cycle, docking)
        return REVERSE
    if view.left < settings.hold_distance - 0.5:
        docking.back_to = settings.hold_distance
        return REVERSE
    docking.heading = heading
    observation_point(navigation.target, heading, plan.standoff, point)
    begin_entry(cycle, settings, plan, navigation, point, docking)
    return FORWARD


@jit
def on_way_back(cycle, dt, settings, plan, navigation, point, view, docking):
    """Waved off: back to the hold point, then round again."""
    waited = (cycle - docking.stage_cycle) * dt
    if is_past(settings, plan, navigation, docking):
        give_up(cycle, settings, docking.reason, view, docking)
        return HOVER
    blind = view.age > settings.lost_far
    slow = abs(navigation.nu[0]) < 0.1 or view.left > docking.back_to + 2.0
    arrived = view.left >= docking.back_to - 0.2 and slow
    if not arrived and not (waited > _WAITED_S and view.left > keep_out(settings, plan)):
        return REVERSE
    docking.gate_cycles += 1
    if blind and docking.gate_cycles * dt < settings.patience:
        return REVERSE
    return go_around(cycle, settings, plan, navigation, blind, point, view, docking)


@jit
def next_stage(clock, dt, settings, supervisor, plan, navigation, leg, mode, point, view, docking):
    """Advance stage, approach heading and tries by one cycle; returns the mode to fly.

    settings: DOCKING_SETTINGS; leg: being flown; mode: in force; point (3,): the observation point, kept in
    step with the heading.
    """
    cycle = clock.cycle
    follow_current(dt, settings, plan, navigation.current, view.left, docking)
    view.off = abs(wrap(navigation.eta[5] - docking.heading))
    if docking.stage == TRANSIT:
        mode = in_transit(clock, settings, supervisor, plan, navigation, leg, point, view, docking)
    elif docking.stage == ENTRY:
        mode = in_entry(cycle, supervisor, view, docking)
    elif docking.stage == APPROACH and mode == FORWARD:
        mode = approach_ahead(cycle, settings, supervisor, view, docking)
    elif docking.stage == APPROACH:
        mode = approach_near(cycle, dt, settings, supervisor, mode, navigation.current, view, docking)
    elif docking.stage == BACK:
        mode = on_way_back(cycle, dt, settings, plan, navigation, point, view, docking)
    elif docking.stage != CREEP:
        mode = HOVER
    observation_point(navigation.target, docking.heading, plan.standoff, point)
    place_on_line(navigation.eta, point, docking.heading, view)
    return mode
