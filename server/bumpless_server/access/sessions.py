"""Sessions of people who have logged in: random keys in cookies, kept as hashes, ended by time or by hand."""

import hashlib
import json
import logging
import secrets
import threading
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from bumpless_server.access.accounts import Account, Accounts
from bumpless_server.access.who import public_id
from bumpless_server.data_dir import write_whole

log = logging.getLogger(__name__)

LONGEST_S = 30 * 86_400.0  # however much it is used
SAVE_EVERY_S = 300.0
MOST = 500


@dataclass(frozen=True)
class Session:
    """One browser. `id` names it and opens nothing; times are UNIX s."""

    id: str
    user: str
    since_s: float
    seen_s: float
    address: str


class Sessions:
    """Who is logged in, also after a restart. Usable from any thread."""

    def __init__(
        self, path: Path, accounts: Accounts, idle_s: float, now: Callable[[], float] = time.time
    ) -> None:
        self._path, self._accounts, self._idle_s, self._now = path, accounts, idle_s, now
        self._lock = threading.Lock()
        self._sessions = _read(path)  # by the hash of the key
        self._saved_s = 0.0

    def begin(self, account: Account, address: str) -> str:
        """Log somebody in; the key for its cookie."""
        key = secrets.token_urlsafe(32)
        made = Session(public_id(key), account.name, self._now(), self._now(), address)
        with self._lock:
            self._sessions[_hash(key)] = made
            while len(self._sessions) > MOST:
                del self._sessions[min(self._sessions, key=lambda one: self._sessions[one].seen_s)]
            self._save()
        return key

    def find(self, key: str) -> tuple[Session, Account] | None:
        """The session of a cookie, while it lasts. Asking is use."""
        if not key:
            return None
        hash_ = _hash(key)
        with self._lock:
            session = self._sessions.get(hash_)
            account = self._good(session)
            if session is None or account is None:
                return None
            self._sessions[hash_] = session = replace(session, seen_s=self._now())
            if self._now() - self._saved_s > SAVE_EVERY_S:
                self._save()
            return session, account

    def all(self) -> list[Session]:
        """Those that last, the latest used first."""
        with self._lock:
            return sorted(
                (one for one in self._sessions.values() if self._good(one)), key=lambda one: -one.seen_s
            )

    def end(self, session_id: str) -> Session | None:
        """Log somebody out, by the session's public id."""
        with self._lock:
            for hash_, one in self._sessions.items():
                if one.id == session_id:
                    del self._sessions[hash_]
                    self._save()
                    return one
        return None

    def end_all_of(self, user: str) -> list[Session]:
        """Log an account out everywhere."""
        with self._lock:
            ended = {hash_: one for hash_, one in self._sessions.items() if one.user == user}
            for hash_ in ended:
                del self._sessions[hash_]
            self._save()
        return list(ended.values())

    def ends_s(self, session: Session) -> float:
        """When it is over if it is not used again, UNIX s."""
        return min(session.seen_s + self._idle_s, session.since_s + LONGEST_S)

    def _good(self, session: Session | None) -> Account | None:
        """The account of a session that lasts: not expired, and no older than the account's last change."""
        if session is None or self._now() >= self.ends_s(session):
            return None
        account = self._accounts.get(session.user)
        return account if account is not None and session.since_s >= account.changed_s else None

    def _save(self) -> None:
        """A disk that takes nothing ends no session: it is only forgotten at a restart."""
        self._sessions = {hash_: one for hash_, one in self._sessions.items() if self._good(one)}
        self._saved_s = self._now()
        told = {hash_: asdict(one) for hash_, one in self._sessions.items()}
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            write_whole(self._path, json.dumps(told).encode(), mode=0o600)
        except OSError as error:
            log.error("the sessions cannot be kept: %s", error)


def _hash(key: str) -> str:
    return hashlib.sha256(key.encode("utf-8", "surrogateescape")).hexdigest()


def _read(path: Path) -> dict[str, Session]:
    """Sessions from before; none where they can't be read: people log in once more."""
    try:
        return {hash_: Session(**one) for hash_, one in json.loads(path.read_bytes()).items()}
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, TypeError, AttributeError) as error:
        log.error("the sessions of before cannot be read: %s", error)
        return {}
