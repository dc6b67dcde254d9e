"""Where an autopilot begins: in F, settled, actuators at rest, at the start that its plan tells."""

from bumpless.contract.enums import FORWARD, TRANSIT
from bumpless.control.effectiveness.step import reset_estimator
from bumpless.jit import jit

_LONG_AGO = -1_000_000_000  # cycle


@jit
def reset_state(settings, plan, s):
    """Bring a zeroed STATE to the start of a mission."""
    mode, navigation, now, minus = settings.modes[0], s.navigation, s.switching.now, s.switching.minus
    for k in range(6):
        navigation.eta[k] = plan.start[k]
        s.pid.K_I[k] = mode.K_I[k]
        now.Q[k] = minus.Q[k] = mode.Q[k]
    for k in range(3):
        navigation.target[k] = plan.target[k]
    for i in range(now.R.shape[0]):
        now.R[i] = minus.R[i] = mode.R[i]
        s.belief.effectiveness[i] = 1.0
    now.lam = minus.lam = mode.lam
    now.increment_share = minus.increment_share = mode.increment_share
    s.switching.ramp_cycle, s.switching.kappa = _LONG_AGO, 1.0
    s.supervisor.mode = s.supervisor.previous_mode = FORWARD
    s.supervisor.switch_cycle = _LONG_AGO
    s.guidance.reference[0] = plan.start_speed
    s.guidance.reference[2], s.guidance.reference[5] = plan.start[2], plan.start[5]
    if settings.docking.enabled == 1:
        s.docking.stage, s.docking.side, s.docking.heading = TRANSIT, 1, plan.target[3]
    reset_estimator(s.estimator)
