"""The compiled world: the one decorator, and a cache on disk that cannot go stale."""

from bumpless.jit.decorator import allocating, inline, jit

__all__ = ["allocating", "inline", "jit"]
