"""Entering stages, waving off and going round again. Beyond the paper."""

from bumpless.contract.enums import (
    APPROACH,
    BACK,
    ENTRY,
    HOLD,
    OFF_DEPTH,
    OFF_HEADING,
    OFF_LINE,
    OVERSHOT,
)
from bumpless.control.docking.entry import choose_way, keep_out
from bumpless.jit import jit

_SHORT_BACK = 3.0  # m, way back for what a little room mends, and m more per m of offset:
_SHORT_BACK_SLOPE = 5.0


@jit
def enter(cycle, stage, docking):
    """Begin `stage` in this cycle."""
    docking.stage, docking.stage_cycle, docking.gate_cycles, docking.cleared = stage, cycle, 0, 0


@jit
def begin_approach(cycle, docking):
    """Begin another approach along the line."""
    enter(cycle, APPROACH, docking)
    docking.tried += 1
    docking.drift = 0.0


@jit
def begin_entry(cycle, settings, plan, navigation, point, docking):
    """Fly round to the beginning of the approach line; point (3,): the observation point, NED."""
    enter(cycle, ENTRY, docking)
    choose_way(settings, keep_out(settings, plan), navigation.eta, navigation.target, point, docking)


@jit
def wave_off(cycle, settings, reason, view, docking):
    """Back off along the approach line for a WaveOffReason: as far as it and the offset ask for."""
    enter(cycle, BACK, docking)
    docking.reason, docking.back_to = reason, settings.hold_distance
    if reason == OFF_LINE or reason == OFF_HEADING or reason == OVERSHOT or reason == OFF_DEPTH:
        short = _SHORT_BACK + _SHORT_BACK_SLOPE * abs(view.aside)
        docking.back_to = min(short, settings.hold_distance)


@jit
def give_up(cycle, settings, reason, view, docking):
    """Hold station on the approach line for good, no nearer than the hold point."""
    enter(cycle, HOLD, docking)
    docking.reason, docking.back_to = reason, max(view.left, settings.hold_distance)
