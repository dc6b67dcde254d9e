"""Start without SciPy's linear algebra.

Numba imports `scipy.linalg` to see whether there is a BLAS to call: a quarter of the time to a process' first
control cycle. Nothing compiled here multiplies by BLAS, so the question is answered beforehand.
"""

from typing import Any


def skip_blas() -> None:
    """Tell Numba, before it looks, that there is no BLAS: compiled `np.dot` and `@` are then refused."""
    from numba.np import linalg

    module: Any = linalg
    if hasattr(module, "ensure_blas"):
        module.ensure_blas = _refuse


def _refuse() -> None:
    raise ImportError("compiled code of Bumpless calls no BLAS; see bumpless.jit.blas")
