"""How sure a share is that was counted."""

from math import sqrt

Z_95 = 1.959963984540054  # normal quantile of 97.5 %


def share_interval(count: int, of: int) -> tuple[float, float]:
    """95 % interval of a share of which `count` in `of` were seen. Source: Wilson 1927, score interval."""
    if of == 0:
        return 0.0, 1.0
    p, z2 = count / of, Z_95**2
    middle = (p + z2 / (2 * of)) / (1 + z2 / of)
    half = Z_95 / (1 + z2 / of) * sqrt(p * (1 - p) / of + z2 / (4 * of**2))
    return max(0.0, middle - half), min(1.0, middle + half)
