"""The closed loop, compiled: one cycle at a time for the live node, a whole run for everything else.

Both are the same function, `fly`, so what is fast is also what flies.
"""

from bumpless.contract.enums import IDLE
from bumpless.control.autopilot import autopilot_cycle
from bumpless.jit import jit
from bumpless.physics.dock.latch import move_marker
from bumpless.physics.plant import step_plant
from bumpless.physics.sensors import measure
from bumpless.sim.row import write_row

SUBSTEPS = 2  # Runge-Kutta steps per control period


@jit
def closed_loop(handle, onboard, world, noise, row):
    """One control cycle of autopilot and plant; fills `row`.

    ONBOARD is what the vehicle knows, WORLD what is true; the measurement is the only way from the one to the
    other, the commands the only way back. noise (N_NOISE,): this cycle's standard normal samples. While idle
    the plant is moored.
    """
    phase, truth, plant, state = onboard.orders.phase, world.truth, world.plant, onboard.state
    if phase != IDLE:
        dock = truth.environment.dock
        if dock.period > 0.0:
            move_marker(dock, plant.time, truth.target)
        measure(world.sensors, truth.errors, truth.target, plant, state.clock.cycle, noise, world.measurement)
        world.measurement.captured = dock.captured
    autopilot_cycle(handle, onboard, world.measurement)
    write_row(onboard, world, phase, row)
    if phase != IDLE:
        u, dt = state.allocation.u, onboard.settings.dt
        step_plant(world.model, truth.environment, truth.faults, plant, u, dt, SUBSTEPS, noise)


@jit
def fly(handle, onboard, world, noise, log):
    """Up to len(log) cycles, ending with the one that changes the phase: rows written.

    The records come as arrays of one, noise is (len(log), N_NOISE). Handed over as records they cost the
    live cycle four times what it takes to fly: NumPy describes each of some 300 fields at each call.
    """
    begun = onboard[0].orders.phase
    for k in range(log.shape[0]):
        closed_loop(handle, onboard[0], world[0], noise[k], log[k])
        if onboard[0].orders.phase != begun:
            return k + 1
    return log.shape[0]
