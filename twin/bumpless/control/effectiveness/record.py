"""What the estimator remembers, and the numbers it is tuned with.

None of the numbers knows a vehicle: forces are held against the model's own, noise against the sensors'.
They were chosen on the plants of `study.plants` for no false alarm first and a short delay second.
"""

import numpy as np

from bumpless.config.capacity import MAX_ACTUATORS as _n

f8, i8 = np.float64, np.int64

SLOTS = 4  # onsets under test at a time; the first is renewed whenever nothing speaks for it
SLOT_S = 4.0  # s between the others: a jump is looked for over the last 8 to 12 s
LEARN_S = 10.0  # s of baseline before the first alarm: trim, buoyancy and drag are unknown at the start
PERSIST_S = 0.4  # s for which one actuator must stand out
MARGIN = 3.0  # by which its evidence must exceed any other's
LEAST_LOSS = 0.15  # smaller jumps are left to the baseline
LARGEST_STD = 0.2  # an estimate less certain than this raises no alarm
HEALTHY_LOSS, HEALTHY_S = 0.1, 2.0  # a fault is over when the loss stays below for this time
MEMORY_S = 20.0  # fading memory of a loss that is followed, and of the measured noise

MODEL_NOISE = 0.03  # white, in shares of the forces at work, sqrt(s)
DRIFT = 0.01  # of the unexplained wrench, in shares of the forces at work, 1/sqrt(s)
DRAG_STD = 0.2  # relative error of the hull's damping, one for each component
FORCE_MEAN_S = 5.0  # over which the forces at work are averaged
FIRST_STD = 10.0  # of the unexplained wrench at the start, in floors
FLOOR_MPS2, FLOOR_RADPS2, FLOOR_TILT_RAD = 0.005, 0.01, 0.005  # least error, in accelerations and attitude
OUTLIER = 4.0  # standard deviations at which an innovation is cut
QUIETEST, LOUDEST = 0.02, 50.0  # measured noise variance against the sensors' own


BELIEF = np.dtype(  # what the allocator is told: nothing of a loss until it is known, then a growing share
    [
        ("effectiveness", f8, _n),
        ("fault_share", f8),  # how far a known fault is blended in
    ],
    align=True,
)

# Components are [X Y Z K M N]; momentum in N s and N m s.
ESTIMATOR = np.dtype(
    [
        ("started", i8),
        ("time", f8),  # s since the baseline began to learn
        ("samples", i8),  # of the velocity log since then
        # baseline: per component [momentum, unexplained wrench, relative error of the damping]
        ("x", f8, (6, 3)),
        ("P", f8, (6, 3, 3)),
        ("R", f8, 6),  # variance of the measured momentum, as found
        ("R_0", f8, 6),  # as the sensors' own figures have it
        ("floor", f8, 6),  # least error of the model, N and N m
        ("size", f8, 6),  # forces at work, mean of magnitudes
        # the model's forces in the last cycle
        ("force_before", f8, 6),
        ("drag_before", f8, 6),
        ("wrench_before", f8, (_n, 6)),
        # hypotheses: true minus estimated baseline for a whole loss of actuator i since an onset
        ("s", f8, (SLOTS, _n, 6, 3)),
        ("information", f8, (SLOTS, _n)),
        ("correlation", f8, (SLOTS, _n)),
        ("slot", i8),  # the youngest
        ("slot_time", f8),
        ("evidence", f8, _n),  # log-likelihood ratio of the best onset against no change
        ("suspect", i8),
        ("suspect_time", f8),
        # diagnosed faults
        ("faulty", i8, _n),
        ("loss", f8, _n),  # 1 - effectiveness; 0 unless faulty
        ("own_s", f8, (_n, 6, 3)),
        ("own_information", f8, _n),
        ("healthy_time", f8, _n),
        ("share", f8, _n),  # of the loss that the allocator has been told so far
    ],
    align=True,
)

ESTIMATOR_WORK = np.dtype(  # of one cycle
    [
        ("nu_r", f8, 6),
        ("momentum", f8, 6),  # measured
        ("force", f8, 6),
        ("drag", f8, 6),
        ("wrench", f8, (_n, 6)),  # of each actuator at full effectiveness
        ("drag_mean", f8, 6),  # over the cycle
        ("wrench_mean", f8, 6),
        ("innovation", f8, 6),
        ("variance", f8, 6),  # of the innovation
        ("K", f8, (6, 3)),
    ],
    align=True,
)
