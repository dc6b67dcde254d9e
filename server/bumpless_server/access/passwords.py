"""Passwords as Argon2id hashes: made and compared, never kept."""

from functools import cache

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

SHORTEST, LONGEST = 10, 200


class WeakPassword(ValueError):
    """A password that may not be one; the rule is in the text."""


@cache
def _hasher() -> PasswordHasher:
    """Source: RFC 9106, the second recommended choice: 64 MiB, three passes."""
    return PasswordHasher(time_cost=3, memory_cost=64 * 1024, parallelism=4)


@cache
def _nobody() -> str:
    return _hasher().hash("what nobody has for a password")


def check_rule(name: str, password: str) -> str:
    """The password, when it may be one. Raises WeakPassword."""
    if not SHORTEST <= len(password) <= LONGEST:
        raise WeakPassword(f"a password has {SHORTEST} to {LONGEST} characters")
    if password.lower() == name.lower() or len(set(password)) < 4:
        raise WeakPassword("this password is guessed at once")
    return password


def hashed(password: str) -> str:
    """What is kept of a password."""
    return _hasher().hash(password)


def matches(password: str, kept: str | None) -> bool:
    """Whether it is the password of `kept`. Takes as long for somebody who does not exist (None)."""
    try:
        return _hasher().verify(kept or _nobody(), password) and kept is not None
    except (VerificationError, InvalidHashError):
        return False
