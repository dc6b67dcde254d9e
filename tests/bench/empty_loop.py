"""How late the machine itself wakes a thread that does nothing: `python -m tests.bench.empty_loop SECONDS`.

The same pacing and priority as the node's loop, 20 Hz. Printed: p99, ms. No node can be better than that.
"""

import sys

from bumpless.node.pacing import WallClock
from bumpless.node.priority import raise_thread

PERIOD_NS = 50_000_000


def lateness_p99_ms(seconds: float) -> float:
    """Of an empty cycle's start after its deadline."""
    raise_thread()
    clock, late = WallClock(PERIOD_NS), []
    clock.start()
    for _ in range(max(1, int(seconds * 1e9 / PERIOD_NS))):
        late.append(clock.wait())
    return sorted(late)[int(0.99 * (len(late) - 1))] / 1e6


if __name__ == "__main__":
    print(lateness_p99_ms(float(sys.argv[1])))
