"""What counts as slower or worse than the committed figures: `python -m tests.bench --check`.

Two runs of one tree on a shared machine differ by up to a third in the median of a ratio, seldom in its
better quartile. A ratio has therefore fallen when even its better quartile is worse than the committed
median by more than RATIO_TOLERANCE. Shares come from problems that are the same each time, so little may
change them. Times and real-time factors depend on the machine: they are shown, never compared.
"""

from collections.abc import Iterable

from tests.bench.figure import Figure, short

RATIO_TOLERANCE = 0.4
SHARE_TOLERANCE = 0.05


def regressions(figures: Iterable[Figure], committed: dict) -> list[str]:
    """One line for every ratio or share that is worse than in the committed figures, or lost its goal.

    A goal that the committed figures miss too is no regression: the table says that it is missed.
    """
    known = {row["key"]: row for row in committed["figures"]}
    said = []
    for f in figures:
        if f.key not in known or not (f.ratio or f.unit == "%"):
            continue
        before, now = known[f.key], f.value
        if f.ratio:
            now = f.high if f.better == "higher" else f.low
        tolerance = RATIO_TOLERANCE if f.ratio else SHARE_TOLERANCE
        if is_worse(now, before["value"], tolerance, f.better):
            said.append(f"{f.title}: {short(f.value)} {f.unit}, was {short(before['value'])}")
        elif before["met"] and not f.reached(now):
            said.append(f"{f.title}: {short(f.value)} {f.unit}, no longer {f.goal}")
    return said


def is_worse(now: float, before: float, tolerance: float, better: str) -> bool:
    """Whether `now` is worse than `before` by more than a share `tolerance` of it."""
    return now < before * (1.0 - tolerance) if better == "higher" else now > before * (1.0 + tolerance)
