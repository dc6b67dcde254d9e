"""Compile and load compiled code without looking for garbage.

Both make objects by the hundred thousand that stay, and Python would look through all of them again and
again: an eighth of the first compilation, a sixth of loading what was compiled. Memory of a first compilation
grows by half for as long as it lasts.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """Within: no search for garbage, unless another thread ends its own such stretch first."""
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()
