"""Who asks: what the guard found out about a request, for rights, control and audit."""

import hashlib
from dataclasses import dataclass
from enum import IntEnum

ID_CHARS = 12


class Role(IntEnum):
    """What somebody may do; each role may all that the ones below it may."""

    observer = 1  # sees
    operator = 2  # commands: missions, starts, pauses, alarms, runs
    engineer = 3  # changes parameters and accounts

    @classmethod
    def of(cls, name: str) -> "Role":
        """By its name. Raises ValueError with the names there are."""
        try:
            return cls[name]
        except KeyError:
            known = ", ".join(role.name for role in cls)
            raise ValueError(f"{name!r} is no role; there are {known}") from None


@dataclass(frozen=True)
class Who:
    """Somebody known. `client` names a browser's session or a script's token to others and opens nothing."""

    name: str  # of the account; "" while no accounts are asked for
    role: Role
    client: str
    shown: str  # for others' eyes: the account, or which browser
    session: str = ""  # the key of its session, kept inside
    open: bool = False  # no accounts are asked for


def public_id(secret: str) -> str:
    """What stands for a session or token where others see it."""
    return hashlib.sha256(secret.encode("utf-8", "surrogateescape")).hexdigest()[:ID_CHARS]
