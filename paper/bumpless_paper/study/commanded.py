"""What actuators give because they are told to: the true wrench without the passive part of the fins.

A fin in a stream that comes from aside lifts without being told to; the published allocator leaves that out
of its map (alpha = delta), so that fins steady the hull, and cannot be judged by it. Lag, thrust, lift and
slew of the true plant stay in.
"""

import numpy as np

from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.actuators import total_wrench
from bumpless.physics.frames import ned_to_body
from bumpless.sim.twin import Result, Twin, parameters_for
from bumpless_paper.study.fly import Job, alteration_for


@jit
def passive_wrenches(model, eta, nu, current, effectiveness, out):
    """out (n, 6) = wrench of all actuators at rest, N and N m, in the flow of each of n rows.

    model: MODEL of the true plant; eta, nu (n, 6); current (n, 3), NED m/s; effectiveness (n, 8).
    """
    rest, water, nu_r = floats(8), floats(3), floats(6)
    for k in range(8):
        rest[k] = 0.0
    for i in range(len(eta)):
        ned_to_body(eta[i, 3], eta[i, 4], eta[i, 5], current[i], water)
        for k in range(3):
            nu_r[k], nu_r[3 + k] = nu[i, k] - water[k], nu[i, 3 + k]
        total_wrench(model, rest, effectiveness[i], nu_r, out[i])


def commanded_error(job: Job, result: Result) -> float:
    """RMS of tau_d minus what the actuators gave as told, over the controllable channels, N and N m."""
    twin = Twin(result.vehicle, parameters_for(result.vehicle, result.mission))
    twin.start(result.mission, job.seed, None, alteration_for(job))
    model = np.array([twin.world["model"]]).view(np.recarray)[0]
    log = result.log
    passive = np.zeros((len(log), 6))
    rows = (np.ascontiguousarray(log[name]) for name in ("eta", "nu", "current", "effectiveness"))
    passive_wrenches(model, *rows, passive)
    served = [k for k, name in enumerate("XYZKMN") if name in result.vehicle.controllable]
    error = (log["tau_d"] - (log["tau"] - passive))[:, served]
    return float(np.sqrt(np.mean(np.sum(error**2, axis=1))))
