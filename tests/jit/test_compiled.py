"""The two faces of compiled functions: a part of compiled callers, a dispatcher to Python."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numba.core.errors import NumbaError

from bumpless.jit import allocating, jit

ROOT = Path(__file__).parents[2]


@jit
def doubled(values, out):
    for i in range(values.size):
        out[i] = 2.0 * values[i]


@jit
def quadrupled(values, out):
    doubled(values, out)
    doubled(out, out)


def test_a_part_is_compiled_within_its_caller_and_alone_only_for_python():
    """Protects: nothing is compiled that nobody calls, and both faces compute the same."""
    values, out = np.arange(4.0), np.zeros(4)
    quadrupled(values, out)
    assert (out == 4.0 * values).all()
    assert not doubled.signatures and len(quadrupled.signatures) == 1
    doubled(values, out)
    assert (out == 2.0 * values).all() and len(doubled.signatures) == 1


FALLBACK = """
import sys
sys.modules["bumpless.jit.parts"] = None
from bumpless.jit.clock import monotonic
from bumpless.jit import jit

@jit
def inner():
    return monotonic()

@jit
def outer():
    return inner()

assert type(outer).__name__ == "CPUDispatcher" and outer() > 0.0
"""


def test_another_numba_compiles_in_its_own_way(tmp_path):
    """Protects: Numba's internals may change; then compilation takes longer and nothing else."""
    (tmp_path / "probe.py").write_text(FALLBACK)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, str(tmp_path / "probe.py")], check=True, env=environment)


@jit
def summed(count):
    return np.ones(count).sum()


@allocating
def summed_on_the_heap(count):
    return np.ones(count).sum()


def test_only_functions_that_say_so_allocate():
    """Protects: nothing in the control cycle takes memory, however long it flies: that does not compile."""
    assert summed_on_the_heap(3) == 3.0
    with pytest.raises(NumbaError):
        summed(3)
