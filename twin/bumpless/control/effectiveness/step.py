"""One cycle of the estimator, and what the allocator is told of it."""

from bumpless.control.effectiveness.baseline import (
    begin_baseline,
    correct_baseline,
    model_forces,
    predict_baseline,
)
from bumpless.control.effectiveness.hypotheses import (
    begin_hypotheses,
    diagnose,
    follow_faults,
    next_onset,
    predict_hypotheses,
    weigh_hypotheses,
)
from bumpless.jit import jit
from bumpless.physics.faults import blend_faults


@jit
def reset_estimator(e):
    """Every actuator is whole and nothing has been seen."""
    e.started = 0
    for i in range(e.loss.shape[0]):
        e.loss[i] = e.share[i] = e.evidence[i] = 0.0
        e.faulty[i] = 0
    for k in range(6):
        e.x[k, 1] = 0.0


@jit
def estimate_effectiveness(dt, evidence, sensors, model, m, navigation, e, w):
    """Advance the ESTIMATOR e by one cycle from the measurement m and the NAVIGATION_STATE.

    Signals used: velocity over ground and turning rates as measured, actuator feedback, and the estimated
    attitude, velocity and current. Commands are not needed: lags stand in the feedback. evidence: the
    log-likelihood ratio that raises an alarm. w: ESTIMATOR_WORK.
    """
    n = model.n_u
    if model_forces(model, m, navigation, e.loss, w) == 0:
        e.started = 0
        return
    if e.started == 0:
        if m.velocity_valid == 0:
            return
        begin_baseline(sensors, model, w.momentum, e)
        begin_hypotheses(e, n)
    else:
        e.time += dt
        predict_baseline(dt, n, e, w)
        predict_hypotheses(dt, n, e, w)
        if m.velocity_valid == 1:
            elapsed = dt * max(1, sensors.dvl_period)
            correct_baseline(elapsed, e, w)
            follow_faults(elapsed, n, e, w)
            best, slot, second = weigh_hypotheses(model, e, w)
            diagnose(evidence, elapsed, n, best, slot, second, e)
            next_onset(elapsed, n, e)
    for k in range(6):
        e.force_before[k], e.drag_before[k] = w.force[k], w.drag[k]
        for i in range(n):
            e.wrench_before[i, k] = w.wrench[i, k]


@jit
def believe_faults(settings, dt, time, faults, e, belief):
    """Fill the BELIEF: known or estimated effectiveness when fault tolerant, nominal otherwise.

    settings: ALLOCATION_SETTINGS; faults: those it is told of, at `time`, s; e: ESTIMATOR.
    """
    belief.fault_share = 0.0
    for i in range(belief.effectiveness.shape[0]):
        belief.effectiveness[i] = 1.0
    if settings.fault_tolerant == 1 and settings.estimate == 1:
        believe_estimate(settings, dt, e, belief)
    elif settings.fault_tolerant == 1:
        belief.fault_share = blend_faults(faults, time, belief.effectiveness)
        if settings.degraded_map == 0:
            for i in range(belief.effectiveness.shape[0]):
                belief.effectiveness[i] = 1.0


@jit
def believe_estimate(settings, dt, e, belief):
    """Blend each diagnosed loss into the BELIEF over settings.effectiveness_blend seconds, and out again when
    the fault is over."""
    step = dt / settings.effectiveness_blend if settings.effectiveness_blend > 0.0 else 1.0
    for i in range(belief.effectiveness.shape[0]):
        wanted = 1.0 if e.faulty[i] == 1 else 0.0
        e.share[i] += min(max(wanted - e.share[i], -step), step)
        belief.fault_share = max(belief.fault_share, e.share[i])
        if settings.degraded_map == 1:
            belief.effectiveness[i] = 1.0 - e.share[i] * e.loss[i]
