"""What a process loads before its first control cycle."""

import subprocess
import sys
from typing import Any

from numba.core.compiler import Flags

_FIRST_CYCLE = """
import sys
from bumpless.config.vehicle import load_vehicle
from bumpless.sim.twin import Twin
Twin(load_vehicle("ts100")).step()
print([name for name in ("scipy.linalg", "numpy.f2py") if name in sys.modules])
"""


def test_a_first_cycle_loads_no_linear_algebra() -> None:
    """Protects the start of a vehicle's node: Numba would load SciPy's BLAS, which nothing here calls."""
    done = subprocess.run([sys.executable, "-c", _FIRST_CYCLE], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "[]"


def test_flags_are_equal_by_effect_and_found_again() -> None:
    """Protects Numba's look-up of overloads: flags set to the default, set alike, set otherwise."""
    left: Any = Flags()
    right: Any = Flags()
    right.nrt = Flags.options["nrt"].default
    assert left == right and hash(left) == hash(right)
    left.nrt = right.nrt = True
    assert left == right and {left: "found"}[right] == "found"
    right.nrt = False
    assert left != right
