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
def estimate_effectiveness(settings, sensors, model, m, a):
    """Advance a.estimator by one cycle from the measurement m and the navigation's estimate in `a`.

    Signals used: velocity over ground and turning rates as measured, actuator feedback, and the estimated
    attitude, velocity and current. Commands are not needed: lags stand in the feedback.
    """
    e, n, dt = a.estimator, model.n_u, settings.dt
    if model_forces(model, m, a, e) == 0:
        e.started = 0
        return
    if e.started == 0:
        if m.velocity_valid == 0:
            return
        begin_baseline(sensors, model, e)
        begin_hypotheses(e, n)
    else:
        e.time += dt
        predict_baseline(dt, n, e)
        predict_hypotheses(dt, n, e)
        if m.velocity_valid == 1:
            elapsed = dt * max(1, sensors.dvl_period)
            correct_baseline(elapsed, e)
            follow_faults(elapsed, n, e)
            best, slot, second = weigh_hypotheses(model, e)
            diagnose(settings.fault_evidence, elapsed, n, best, slot, second, e)
            next_onset(elapsed, n, e)
    for k in range(6):
        e.force_before[k], e.drag_before[k] = e.force[k], e.drag[k]
        for i in range(n):
            e.wrench_before[i, k] = e.wrench[i, k]


@jit
def believe_estimate(settings, n, a):
    """Fill a.effectiveness (8,) and a.fault_share: each diagnosed loss is blended in over
    settings.effectiveness_blend seconds, and out again when the fault is over."""
    e = a.estimator
    step = settings.dt / settings.effectiveness_blend if settings.effectiveness_blend > 0.0 else 1.0
    for i in range(n):
        wanted = 1.0 if e.faulty[i] == 1 else 0.0
        e.share[i] += min(max(wanted - e.share[i], -step), step)
        a.fault_share = max(a.fault_share, e.share[i])
        if settings.degraded_map == 1:
            a.effectiveness[i] = 1.0 - e.share[i] * e.loss[i]
