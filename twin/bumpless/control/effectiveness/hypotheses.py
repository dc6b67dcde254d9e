"""Which actuator's loss, begun when, explains the innovations best: a generalised likelihood ratio.

For every actuator and a few onsets the baseline's error under a whole loss is carried along (s, linear in
the loss), hence the innovation h it would cause. From these information C = sum h^2 / S and correlation
D = sum h e / S the loss is D / C, with evidence l D - l^2 C / 2 against no change.
An actuator that stands out is diagnosed: the loss enters the model, and its error is followed from then on
with fading memory (Friedland's separate bias filter), so that the estimate sharpens and follows.
Drag, trim and buoyancy are learnt by the baseline and cannot be mistaken for a fault unless they jump.

Source: Willsky and Jones 1976, IEEE Trans. Autom. Control 21(1); Friedland 1969, the same 14(4).
"""

from bumpless.control.effectiveness.record import (
    HEALTHY_LOSS,
    HEALTHY_S,
    LARGEST_STD,
    LEARN_S,
    LEAST_LOSS,
    MARGIN,
    MEMORY_S,
    PERSIST_S,
    SLOT_S,
    SLOTS,
)
from bumpless.jit import inline, jit
from bumpless.physics.lag import decay


@jit
def forget(e, slot, i):
    """Begin a new onset of actuator i in `slot`: until now nothing has happened."""
    e.information[slot, i] = e.correlation[slot, i] = 0.0
    for k in range(6):
        for j in range(3):
            e.s[slot, i, k, j] = 0.0


@jit
def begin_hypotheses(e, n):
    """Nothing is under test; what is diagnosed stays so."""
    for i in range(n):
        e.evidence[i] = 0.0
        for slot in range(SLOTS):
            forget(e, slot, i)
        for k in range(6):
            for j in range(3):
                e.own_s[i, k, j] = 0.0
    e.slot_time, e.suspect, e.suspect_time = 0.0, -1, 0.0


@inline
def carry(s, drag, wrench, dt):
    """Advance s (6, 3), the baseline's error under a whole loss of `wrench` (6,), over dt seconds."""
    for k in range(6):
        s[k, 0] += dt * (s[k, 1] + s[k, 2] * drag[k] - wrench[k])


@jit
def predict_hypotheses(dt, n, e, w):
    """Advance every hypothesis over one cycle."""
    for i in range(n):
        for k in range(6):
            w.wrench_mean[k] = 0.5 * (w.wrench[i, k] + e.wrench_before[i, k])
        for slot in range(SLOTS):
            carry(e.s[slot, i], w.drag_mean, w.wrench_mean, dt)
        if e.faulty[i] == 1:
            carry(e.own_s[i], w.drag_mean, w.wrench_mean, dt)


@jit
def weigh(s, w):
    """(information, correlation) of this sample for the hypothesis s (6, 3), which is corrected by it."""
    information = correlation = 0.0
    for k in range(6):
        h = s[k, 0]
        information += h * h / w.variance[k]
        correlation += h * w.innovation[k] / w.variance[k]
        for j in range(3):
            s[k, j] -= w.K[k, j] * h
    return information, correlation


@jit
def believe_loss(e, i, s, change):
    """Change the loss of actuator i within 0 to 1, and the baseline by what that explains."""
    change = min(max(change, -e.loss[i]), 1.0 - e.loss[i])
    e.loss[i] += change
    for k in range(6):
        for j in range(3):
            e.x[k, j] += change * s[k, j]


@jit
def follow_faults(elapsed, n, e, w):
    """Sharpen the loss of every diagnosed actuator; one that has recovered is no longer faulty."""
    for i in range(n):
        if e.faulty[i] == 1:
            information, correlation = weigh(e.own_s[i], w)
            e.own_information[i] = decay(elapsed, MEMORY_S) * e.own_information[i] + information
            if e.own_information[i] > 0.0:
                believe_loss(e, i, e.own_s[i], correlation / e.own_information[i])
            e.healthy_time[i] = e.healthy_time[i] + elapsed if e.loss[i] < HEALTHY_LOSS else 0.0
            if e.healthy_time[i] > HEALTHY_S:
                believe_loss(e, i, e.own_s[i], -1.0)
                e.faulty[i] = 0


@jit
def weigh_hypotheses(model, e, w):
    """Take in this sample's innovations; fills e.evidence (n,). Returns (actuator, slot) that stands out
    most, or (-1, 0), and the evidence of the next best actuator."""
    best, best_slot, top, second = -1, 0, 0.0, 0.0
    for i in range(model.n_u):
        trust = model.trust[i]
        e.evidence[i] = 0.0
        own_slot = 0
        for slot in range(SLOTS):
            information, correlation = weigh(e.s[slot, i], w)
            e.information[slot, i] += information
            e.correlation[slot, i] += correlation
            evidence, change = evidence_of(e, slot, i)
            certain = e.information[slot, i] * LARGEST_STD**2 >= 1.0
            if certain and abs(change) >= LEAST_LOSS and trust * evidence > e.evidence[i]:
                e.evidence[i] = trust * evidence
                own_slot = slot
        if e.evidence[i] > top:
            second = top
            best, best_slot, top = i, own_slot, e.evidence[i]
        elif e.evidence[i] > second:
            second = e.evidence[i]
    return best, best_slot, second


@inline
def evidence_of(e, slot, i):
    """(log-likelihood ratio, change of loss) of actuator i with the onset of `slot`."""
    c, d = e.information[slot, i], e.correlation[slot, i]
    if c <= 0.0:
        return 0.0, 0.0
    change = min(max(d / c, -e.loss[i]), 1.0 - e.loss[i])
    return change * d - 0.5 * change * change * c, change


@jit
def diagnose(threshold, elapsed, n, best, slot, second, e):
    """Raise the alarm on actuator `best` once it has stood out long enough."""
    stands_out = (
        best >= 0
        and e.time > LEARN_S
        and e.evidence[best] >= threshold
        and e.evidence[best] - second >= MARGIN
    )
    if not stands_out:
        e.suspect, e.suspect_time = -1, 0.0
        return
    if best != e.suspect:
        e.suspect, e.suspect_time = best, 0.0
    e.suspect_time += elapsed
    if e.suspect_time < PERSIST_S:
        return
    _, change = evidence_of(e, slot, best)
    believe_loss(e, best, e.s[slot, best], change)
    e.own_information[best] = e.information[slot, best]
    for k in range(6):
        for j in range(3):
            e.own_s[best, k, j] = e.s[slot, best, k, j]
    e.faulty[best], e.healthy_time[best] = 1, 0.0
    e.suspect, e.suspect_time = -1, 0.0
    for i in range(n):
        for s in range(SLOTS):
            forget(e, s, i)


@jit
def next_onset(elapsed, n, e):
    """Give up onsets: the oldest for a new one every SLOT_S; all while the baseline learns; and in slot 0
    that of any actuator for which not even the least loss is likelier than none (Page's cumulative sum)."""
    e.slot_time += elapsed
    turn = e.slot_time >= SLOT_S
    if turn:
        e.slot_time = 0.0
        e.slot = e.slot % (SLOTS - 1) + 1
    for i in range(n):
        d = abs(e.correlation[0, i]) if e.faulty[i] == 1 else e.correlation[0, i]
        if d <= 0.5 * LEAST_LOSS * e.information[0, i]:
            forget(e, 0, i)
        if turn:
            forget(e, e.slot, i)
        if e.time <= LEARN_S:
            for slot in range(SLOTS):
                forget(e, slot, i)
