"""The vehicle's own checklist of the ways out of a mode agrees with what it then does."""

import numpy as np
import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import PAUSED
from bumpless.sim.twin import simulate
from bumpless.telemetry.context import make_context
from bumpless.telemetry.exits import exits


def told(result) -> list[pb.Exits]:
    """The checklist of every cycle."""
    context = make_context(result.vehicle, result.parameters)
    return [exits(row, context, pb.Stamp()) for row in result.log]


def test_a_checklist_met_to_the_last_is_a_switch_and_no_other_is(ts100, published):
    """Protects the inspector from a guess: of the published automaton the guards are the whole truth."""
    result = simulate(published, ts100)
    lists, modes = told(result), result.log["mode"]
    switches = np.flatnonzero(np.diff(modes)) + 1
    assert len(switches) >= 2
    for k, before in enumerate(lists[:-1]):
        met = [exit_ for exit_ in before.exits if all(guard.met for guard in exit_.guards)]
        # a row is written after its own decision: what is met in it is taken in the next cycle
        if met and modes[k + 1] == modes[k]:
            nearly = [abs(g.value - g.limit) < 0.1 for e in met for g in e.guards if g.unit == "m"]
            assert all(nearly), f"cycle {k}: all met and no switch"
    for k in switches:
        taken = [e for e in lists[k - 1].exits if e.to == modes[k]]
        short = [min((sum(not g.met for g in e.guards) for e in taken), default=9)]
        assert min(short) <= 1, f"cycle {k}: switched to {modes[k]} with its checklist far from met"


def test_what_a_switch_waits_for_is_foretold(ts100, published):
    """Protects "in about 4 s": right to a third of the time it tells, wherever it tells one below 10 s."""
    result = simulate(published, ts100)
    lists, modes = told(result), result.log["mode"]
    first = int(np.flatnonzero(np.diff(modes))[0]) + 1
    errors = []
    for k in range(max(0, first - 160), first - 20):
        for exit_ in lists[k].exits:
            if exit_.to == modes[first] and 1.0 < exit_.expected_s < 10.0:
                errors.append(abs(exit_.expected_s - (first - k) * 0.05) / exit_.expected_s)
    assert errors and float(np.median(errors)) < 0.33


@pytest.mark.parametrize("stage", [1, 3])
def test_docking_tells_what_its_gate_waits_for(ts100, docking, stage):
    """Protects: on the approach line the conditions of the gate are named, elsewhere none is invented."""
    result = simulate(docking, ts100)
    rows = np.flatnonzero(result.log["stage"] == stage)
    lists = told(result)
    names = {guard.name for k in rows for exit_ in lists[k].exits for guard in exit_.guards}
    assert names == (set() if stage == 1 else names)
    if stage == 3:
        assert {"way to go", "gate passed", "depth error", "heading error", "aside"} <= names


def test_a_pause_freezes_the_supervisor_and_has_no_exits(ts100, published):
    """Protects: what cannot happen is not shown as about to happen."""
    result = simulate(published, ts100)
    row = result.log[200].copy()
    context = make_context(ts100, result.parameters)
    assert exits(row, context, pb.Stamp()).exits
    row["phase"] = PAUSED
    assert not exits(row, context, pb.Stamp()).exits
