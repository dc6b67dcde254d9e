"""Percentiles of a duration over a process's whole life, in fixed memory."""

from array import array

_SUB_BITS = 4  # 16 bins for each doubling: an edge is at most 6.25 % above the value
_LONGEST = (1 << 44) - 1  # ns, almost five hours


class Histogram:
    """Counts nanoseconds in bins of about 6 % width; one thread adds, others may read."""

    def __init__(self) -> None:
        self._counts = array("q", bytes(8 * (_bin(_LONGEST) + 1)))
        self.total = 0
        self.maximum = 0  # ns

    def add(self, duration_ns: int) -> None:
        """Count one duration; below zero counts as zero."""
        held = min(max(duration_ns, 0), _LONGEST)
        self._counts[_bin(held)] += 1
        self.total += 1
        if duration_ns > self.maximum:
            self.maximum = duration_ns

    def percentile(self, share: float) -> int:
        """Upper edge of the bin that holds the `share` quantile, at most the maximum, ns; 0 when empty."""
        wanted, seen = share * self.total, 0
        for index, count in enumerate(self._counts):
            seen += count
            if count and seen >= wanted:
                return min(_upper_edge(index), self.maximum)
        return self.maximum


def _bin(value: int) -> int:
    shift = max(0, value.bit_length() - _SUB_BITS - 1)
    return (shift << _SUB_BITS) + (value >> shift)


def _upper_edge(index: int) -> int:
    shift = max(0, (index >> _SUB_BITS) - 1)
    mantissa = index - (shift << _SUB_BITS)
    return ((mantissa + 1) << shift) - 1
