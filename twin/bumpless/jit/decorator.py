"""The one decorator for compiled code, and a compile cache that cannot go stale.

Numba's file cache notices a change of the file that holds a function, but not of the files that
hold the functions it calls. The cache folder is therefore named by a digest of every source file
that holds compiled code, of all that these import from `bumpless`, and of the versions that matter.
"""

import hashlib
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import numpy as np

from bumpless.jit.blas import skip_blas
from bumpless.jit.cache import claim, usable
from bumpless.jit.flags import compare_by_what_was_set

try:
    from bumpless.jit.parts import Function
except ImportError:
    Function = None


def compiled_sources(root: Path = Path(__file__).parents[1]) -> list[Path]:
    """Every file under `root` (the package `bumpless`) that compiled code can depend on, sorted."""
    return sorted(Path(path) for path in _read(str(root)))


def _read(root: str) -> dict[str, bytes]:
    """What those files hold, by path. Every start pays for this: hence bytes and one search of each file."""
    texts: dict[str, bytes] = {}
    for folder, _, names in os.walk(root):
        for name in names:
            if name.endswith(".py"):
                with open(path := os.path.join(folder, name), "rb") as file:
                    texts[path] = file.read()
    waiting = [path for path, text in texts.items() if _is_compiled(text)]
    found: dict[str, bytes] = {}
    while waiting:
        path = waiting.pop()
        if path in texts and path not in found:
            text = found[path] = texts[path]
            for name in _NAMED.finditer(text):
                if _IMPORT.search(text, max(0, name.start() - 40), name.start()):
                    module = os.path.join(root, *name[1].decode("ascii", "replace").split("."))
                    waiting += [module + ".py", os.path.join(module, "__init__.py")]
    return found


_NAMED = re.compile(rb"bumpless\.([\w.]+)")
_IMPORT = re.compile(rb"^\s*(?:from|import) \Z", re.MULTILINE)
_SEED = re.compile(rb"^\s*(from bumpless\.jit import|(from|import) numba)", re.MULTILINE)


def _is_compiled(text: bytes) -> bool:
    return (b"numba" in text or b"bumpless.jit" in text) and _SEED.search(text) is not None


def _digest() -> str:
    h = hashlib.sha256(f"{numba.__version__} {np.__version__} {sys.version}".encode())
    for _, text in sorted(_read(str(Path(__file__).parents[1])).items()):
        h.update(text)
    return h.hexdigest()[:16]


def cache_folder() -> Path:
    """Where compiled code of this very source tree is kept."""
    base = os.environ.get("BUMPLESS_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    return Path(base).expanduser() / "bumpless" / f"numba-{_digest()}"


if not os.environ.get("NUMBA_CACHE_DIR"):
    numba.config.CACHE_DIR = str(claim(usable(cache_folder())))  # type: ignore[attr-defined]
skip_blas()
compare_by_what_was_set()


_OPTIONS = {"nopython": True, "nogil": True, "error_model": "numpy"}


def jit(function: Callable[..., Any]) -> Any:
    """Compile on first call, without the GIL, cached on disk; NumPy's rules for division by zero.

    The function works on arrays that its caller holds and makes none (Numba refuses to compile one that
    does), therefore no references are counted: an atomic addition and a call for every array and view.
    """
    return _made(function, {**_OPTIONS, "_nrt": False})


def inline(function: Callable[..., Any]) -> Any:
    """`jit` for the smallest functions, and those within a loop over actuators: a part of every caller."""
    return _made(function, {**_OPTIONS, "_nrt": False, "forceinline": True})


def allocating(function: Callable[..., Any]) -> Any:
    """`jit` for the few functions that make or return arrays, and so must count references to them."""
    return _made(function, _OPTIONS)


def _made(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    if Function is not None:
        return Function(function, options)
    return numba.njit(cache=True, **options)(function)
