"""A light vehicle whose clock is off by TRUST_OFFSET_S."""

import os
import sys
import time

from tests.node.light import run

OFFSET_NS = round(float(os.environ["TRUST_OFFSET_S"]) * 1e9)
TRUE_NS = time.time_ns

if __name__ == "__main__":
    time.time_ns = lambda: TRUE_NS() + OFFSET_NS
    sys.exit(run(*sys.argv[1:]))
