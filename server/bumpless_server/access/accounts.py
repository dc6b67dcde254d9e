"""Accounts and tokens, kept in one file that only its owner may read.

The command line and a running server write the same file, each behind a lock, and the server reads it anew
when it has changed: what is revoked there counts from the next request on. Secrets are kept as hashes only.
"""

import fcntl
import hashlib
import json
import logging
import os
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from bumpless.contract.names import NameRule
from bumpless_server.access import passwords
from bumpless_server.access.who import Role, public_id
from bumpless_server.data_dir import write_whole

log = logging.getLogger(__name__)

NAME = NameRule(r"[a-z][a-z0-9._-]{0,39}", "1 to 40 of a-z, 0-9, '.', '_' and '-', a letter first")
TOKEN_NAME = NameRule(
    r"[A-Za-z0-9][A-Za-z0-9._ -]{0,59}", "1 to 60 of letters, digits, ' ', '.', '_' and '-', no sign first"
)
PREFIX = "bmp_"  # so that a token that lies about is found
MOST = 200  # accounts, and tokens
DAY_S = 86_400.0


class AccountsError(RuntimeError):
    """It can't be done; the text is one line for the person who asked."""


@dataclass(frozen=True)
class Account:
    """A person. `changed_s` (UNIX): sessions from before a change of password or role are over."""

    name: str
    role: str
    password: str = field(repr=False)
    since_s: float
    changed_s: float

    @property
    def rank(self) -> Role:
        return Role.of(self.role)


@dataclass(frozen=True)
class Token:
    """A script's key, made by an account and never worth more than it. `until_s` 0: until it is revoked."""

    id: str
    name: str
    user: str
    role: str
    sha256: str = field(repr=False)
    since_s: float
    until_s: float


@dataclass(frozen=True)
class _Kept:
    accounts: dict[str, Account] = field(default_factory=dict)
    tokens: dict[str, Token] = field(default_factory=dict)


class Accounts:
    """Who may come in. Usable from any thread."""

    def __init__(self, folder: Path, now: Callable[[], float] = time.time) -> None:
        self._folder, self._path, self._now = folder, folder / "accounts.json", now
        self._lock = threading.Lock()
        self._stamp: tuple[int, int, int] | None = None
        self._kept = _Kept()
        self.trouble = ""  # why the file can't be read; "" when it can

    def any(self) -> bool:
        """Is there an account at all? A file that can't be read may hold some: the door stays shut."""
        return bool(self._fresh().accounts) or bool(self.trouble)

    def all(self) -> list[Account]:
        """By name."""
        return sorted(self._fresh().accounts.values(), key=lambda one: one.name)

    def get(self, name: str) -> Account | None:
        """One account."""
        return self._fresh().accounts.get(name)

    def tokens(self) -> list[Token]:
        """Those in force, by name."""
        return sorted(self._fresh().tokens.values(), key=lambda one: (one.name, one.id))

    def add(self, name: str, role: str, password: str) -> Account:
        """A new account; the first one must be able to make others. Raises AccountsError, ValueError."""
        NAME.check(name, "name")
        Role.of(role)
        made = Account(name, role, _hashed(name, password), self._now(), self._now())
        with self._changing() as kept:
            if name in kept.accounts:
                raise AccountsError(f"there is an account {name!r} already")
            if not kept.accounts and role != Role.engineer.name:
                raise AccountsError("the first account must be an engineer's: others are made by engineers")
            if len(kept.accounts) >= MOST:
                raise AccountsError(f"there are {MOST} accounts already")
            kept.accounts[name] = made
        return made

    def change(self, name: str, role: str | None = None, password: str | None = None) -> Account:
        """Another role or password; ends the account's sessions. Raises AccountsError, ValueError."""
        if role is not None:
            Role.of(role)
        hash_ = _hashed(name, password) if password is not None else None
        with self._changing() as kept:
            known = _known(kept, name)
            new = replace(
                known, role=role or known.role, password=hash_ or known.password, changed_s=self._now()
            )
            kept.accounts[name] = new
            _still_an_engineer(kept)
        return new

    def remove(self, name: str) -> None:
        """An account, its sessions and its tokens. Raises AccountsError."""
        with self._changing() as kept:
            del kept.accounts[_known(kept, name).name]
            _still_an_engineer(kept)
            for token in [one for one in kept.tokens.values() if one.user == name]:
                del kept.tokens[token.id]

    def verify(self, name: str, password: str) -> Account | None:
        """The account whose password this is. Slow on purpose; as slow for names that nobody has."""
        account = self.get(name)
        right = passwords.matches(password, account.password if account else None)
        return account if right else None

    def new_token(self, user: str, name: str, role: str, days: float = 0.0) -> tuple[Token, str]:
        """A token and its secret, which is shown once. Raises AccountsError, ValueError."""
        TOKEN_NAME.check(name, "token name")
        secret = PREFIX + secrets.token_urlsafe(32)
        with self._changing() as kept:
            if Role.of(role) > _known(kept, user).rank:
                raise AccountsError(f"a token of {user} can't be worth more than {user}")
            if len(kept.tokens) >= MOST:
                raise AccountsError(f"there are {MOST} tokens already")
            if any(one.name == name for one in kept.tokens.values()):
                raise AccountsError(f"there is a token {name!r} already")
            until_s = self._now() + days * DAY_S if days else 0.0
            token = Token(public_id(secret), name, user, role, _sha256(secret), self._now(), until_s)
            kept.tokens[token.id] = token
        return token, secret

    def revoke(self, token: str) -> Token:
        """End a token by its id or name. Raises AccountsError."""
        with self._changing() as kept:
            for one in kept.tokens.values():
                if token in (one.id, one.name):
                    return kept.tokens.pop(one.id)
        raise AccountsError(f"there is no token {token!r}")

    def by_token(self, secret: str) -> Token | None:
        """The token with this secret, when it is in force; its role is at most its account's."""
        kept = self._fresh()
        token = kept.tokens.get(public_id(secret))
        if token is None or not secrets.compare_digest(token.sha256, _sha256(secret)):
            return None
        account = kept.accounts.get(token.user)
        if account is None or (token.until_s and token.until_s <= self._now()):
            return None
        return replace(token, role=min(Role.of(token.role), account.rank).name)

    def _fresh(self) -> _Kept:
        """What the file says now; what it said before, where it can't be read: nobody new comes in."""
        with self._lock:
            try:
                stamp = _stamp(self._path)
                if stamp != self._stamp:
                    self._stamp = stamp
                    self._kept, self.trouble = _read(self._path), ""
            except (OSError, ValueError, TypeError, KeyError) as error:
                self.trouble = f"{self._path} cannot be read: {error}"
                log.error("%s", self.trouble)
            return self._kept

    @contextmanager
    def _changing(self) -> Iterator[_Kept]:
        """The file's content, to be changed; written when nothing was raised."""
        self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        descriptor = os.open(self._folder / "lock", os.O_RDWR | os.O_CREAT, 0o600)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX)
            try:
                kept = _read(self._path)
            except (ValueError, TypeError, KeyError) as error:
                raise AccountsError(f"{self._path} cannot be read: {error}") from error
            yield kept
            told = {name: list(map(asdict, found.values())) for name, found in vars(kept).items()}
            write_whole(self._path, json.dumps(told, indent=1).encode(), mode=0o600)
        finally:
            os.close(descriptor)


def _hashed(name: str, password: str) -> str:
    return passwords.hashed(passwords.check_rule(name, password))


def _sha256(secret: str) -> str:
    return hashlib.sha256(secret.encode("utf-8", "surrogateescape")).hexdigest()


def _known(kept: _Kept, name: str) -> Account:
    if name not in kept.accounts:
        raise AccountsError(f"there is no account {name!r}")
    return kept.accounts[name]


def _still_an_engineer(kept: _Kept) -> None:
    if kept.accounts and all(one.rank < Role.engineer for one in kept.accounts.values()):
        raise AccountsError("the last engineer stays one: nobody else could change accounts")


def _stamp(path: Path) -> tuple[int, int, int] | None:
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _read(path: Path) -> _Kept:
    try:
        told: dict[str, Any] = json.loads(path.read_bytes())
    except FileNotFoundError:
        return _Kept()
    accounts = [Account(**one) for one in told["accounts"]]
    tokens = [Token(**one) for one in told["tokens"]]
    for one in (*accounts, *tokens):
        Role.of(one.role)
    return _Kept({one.name: one for one in accounts}, {one.id: one for one in tokens})
