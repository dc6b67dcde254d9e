"""Accounts, tokens and sessions: kept as hashes, revoked at once, in virtual time."""

import json
from pathlib import Path

import pytest

from bumpless_server.access import passwords
from bumpless_server.access.accounts import DAY_S, Accounts, AccountsError
from bumpless_server.access.passwords import WeakPassword
from bumpless_server.access.sessions import LONGEST_S, Sessions

PASSWORD = "correct horse battery"


class Clock:
    s = 1_000_000.0

    def __call__(self) -> float:
        return self.s


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def accounts(tmp_path: Path, clock: Clock, monkeypatch: pytest.MonkeyPatch) -> Accounts:
    """Ada the engineer and Ben the operator; hashes take no time."""
    monkeypatch.setattr(passwords, "hashed", lambda password: password[::-1])
    monkeypatch.setattr(passwords, "matches", lambda password, kept: password[::-1] == kept)
    made = Accounts(tmp_path / "access", clock)
    made.add("ada", "engineer", PASSWORD)
    made.add("ben", "operator", PASSWORD)
    return made


def test_a_password_is_kept_as_argon2id_and_compared_as_slowly_for_nobody(tmp_path: Path) -> None:
    """Protects: a stolen file gives no password, and the time of an answer tells no names."""
    accounts = Accounts(tmp_path / "access")
    accounts.add("ada", "engineer", PASSWORD)
    kept = (tmp_path / "access" / "accounts.json").read_text()
    assert PASSWORD not in kept and "$argon2id$v=19$m=65536,t=3,p=4$" in kept
    assert accounts.verify("ada", PASSWORD) is not None
    assert accounts.verify("ada", PASSWORD + "x") is None
    assert passwords.matches("what nobody has for a password", None) is False
    assert accounts.verify("nobody", PASSWORD) is None


def test_only_the_owner_may_read_what_is_kept(accounts: Accounts, tmp_path: Path) -> None:
    """Protects: other users of the machine read neither hashes nor sessions."""
    sessions = Sessions(tmp_path / "access" / "sessions.json", accounts, 60.0)
    account = accounts.get("ada")
    assert account is not None
    sessions.begin(account, "here")
    assert (tmp_path / "access").stat().st_mode & 0o077 == 0
    for file in (tmp_path / "access").iterdir():
        assert file.stat().st_mode & 0o077 == 0, file


@pytest.mark.parametrize("password", ["short", "aaaaaaaaaaaaaaa", "engineer-ada", "x" * 201])
def test_what_is_guessed_at_once_is_no_password(accounts: Accounts, password: str) -> None:
    """Protects: the weakest passwords are no passwords."""
    with pytest.raises(WeakPassword):
        accounts.add("engineer-ada", "observer", password)


def test_somebody_can_always_change_accounts(accounts: Accounts, tmp_path: Path) -> None:
    """Protects: the last engineer can't lock everybody out."""
    with pytest.raises(AccountsError, match="the first account must be an engineer's"):
        Accounts(tmp_path / "other").add("eve", "observer", PASSWORD)
    for action in (lambda: accounts.remove("ada"), lambda: accounts.change("ada", role="operator")):
        with pytest.raises(AccountsError, match="the last engineer"):
            action()
    assert [one.role for one in accounts.all()] == ["engineer", "operator"]


def test_a_change_on_the_command_line_counts_at_once(accounts: Accounts, tmp_path: Path) -> None:
    """Protects: a running server lets nobody in whom another process has just removed."""
    other = Accounts(tmp_path / "access")
    other.remove("ben")
    assert accounts.get("ben") is None


def test_a_broken_file_lets_nobody_new_in_and_is_not_overwritten(accounts: Accounts, tmp_path: Path) -> None:
    """Protects: damage closes the door instead of opening it."""
    path = tmp_path / "access" / "accounts.json"
    path.write_text('{"accounts": [{"name"')
    assert accounts.any() and Accounts(tmp_path / "access").any()  # nobody is let in without logging in
    assert Accounts(tmp_path / "access").get("ada") is None
    with pytest.raises(AccountsError, match="cannot be read"):
        accounts.add("eve", "observer", PASSWORD)
    assert path.read_text() == '{"accounts": [{"name"'


def test_a_token_is_shown_once_worth_no_more_than_its_account_and_ends(
    accounts: Accounts, clock: Clock, tmp_path: Path
) -> None:
    """Protects: what a script holds is bounded in rights and time, and can be taken away."""
    token, secret = accounts.new_token("ben", "nightly", "operator", days=1.0)
    assert secret not in (tmp_path / "access" / "accounts.json").read_text()
    assert accounts.by_token(secret) == token
    with pytest.raises(AccountsError, match="can't be worth more"):
        accounts.new_token("ben", "more", "engineer")
    accounts.change("ben", role="observer")
    found = accounts.by_token(secret)
    assert found is not None and found.role == "observer"
    clock.s += DAY_S
    assert accounts.by_token(secret) is None
    _, lasting = accounts.new_token("ben", "lasting", "observer")
    accounts.revoke("lasting")
    assert accounts.by_token(lasting) is None and accounts.by_token("bmp_x") is None
    _, of_ben = accounts.new_token("ben", "third", "observer")
    accounts.remove("ben")
    assert accounts.by_token(of_ben) is None


def test_a_session_ends_by_time_by_hand_and_with_its_account(
    accounts: Accounts, clock: Clock, tmp_path: Path
) -> None:
    """Protects: a stolen or forgotten cookie opens nothing for long, and nothing after a revocation."""
    path = tmp_path / "access" / "sessions.json"
    sessions = Sessions(path, accounts, 3600.0, clock)
    ben = accounts.get("ben")
    assert ben is not None
    keys = [sessions.begin(ben, "here") for _ in range(4)]
    assert keys[0] not in path.read_text()
    clock.s += 3500.0
    assert all(sessions.find(key) for key in keys[:3])
    clock.s += 3500.0
    assert sessions.find(keys[3]) is None and sessions.find(keys[0]) is not None
    assert sessions.end(sessions.all()[0].id) is not None
    assert len(sessions.all()) == 2
    assert Sessions(path, accounts, 1e6, clock).find(keys[1]) is not None  # after a restart
    accounts.change("ben", password=PASSWORD + "!")
    assert all(sessions.find(key) is None for key in keys) and sessions.find("") is None


def test_a_session_that_is_used_all_the_time_ends_too(accounts: Accounts, clock: Clock) -> None:
    """Protects: no cookie is for ever."""
    ada = accounts.get("ada")
    assert ada is not None
    sessions = Sessions(Path("/nowhere/x"), accounts, 2 * LONGEST_S, clock)
    key = sessions.begin(ada, "here")
    clock.s += LONGEST_S - 1
    assert sessions.find(key) is not None
    clock.s += 1
    assert sessions.find(key) is None


def test_what_is_kept_of_sessions_may_be_anything(accounts: Accounts, tmp_path: Path) -> None:
    """Protects: a damaged file of sessions costs a log-in, not the start."""
    path = tmp_path / "sessions.json"
    for content in ("[]", "{", '{"a": 1}', json.dumps({"a": {"id": "x"}})):
        path.write_text(content)
        assert Sessions(path, accounts, 60.0).all() == []
