"""Logging in and out, and, for engineers, who may: accounts, sessions and tokens."""

import asyncio
from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from fastapi.concurrency import run_in_threadpool

from bumpless_server.access.accounts import Account, Token
from bumpless_server.access.sessions import Session
from bumpless_server.access.who import Role, Who
from bumpless_server.web.answers.control import Me
from bumpless_server.web.answers.people import (
    ChangedUser,
    Login,
    MadeToken,
    NewToken,
    NewUser,
    OwnPassword,
    SessionAnswer,
    TokenAnswer,
    UserAnswer,
)
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.auth import new_cookie
from bumpless_server.web.errors import Refusal
from bumpless_server.web.guesses import Guesses
from bumpless_server.web.known import Asking, address_of
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)

MOST_AT_ONCE = 20  # who log in; each costs 64 MiB for a moment, so one comes after the other


class Door:
    """Checks passwords, one at a time: guesses are counted before the next one is looked at."""

    def __init__(self, request: Request, console: Served) -> None:
        self._request, self._console = request, console
        self._guesses: Guesses = request.app.state.guesses
        self.address = address_of(request.scope)

    async def verify(self, name: str, password: str) -> Account:
        """The account, or a refusal."""
        state = self._request.app.state
        state.logging_in = getattr(state, "logging_in", 0) + 1
        try:
            if state.logging_in > MOST_AT_ONCE:
                raise Refusal(503, "too many log in at once; try again in a few seconds")
            if not hasattr(state, "door"):
                state.door = asyncio.Lock()
            async with state.door:
                if wait_s := self._guesses.wait_s(self.address, name):
                    raise Refusal(429, f"too many wrong guesses; try again in {wait_s:.0f} s")
                account = await run_in_threadpool(self._console.accounts.verify, name, password)
                if account is None:
                    self._guesses.wrong(self.address, "a password", name)
                    raise Refusal(401, "this name and this password do not belong together")
                return account
        finally:
            state.logging_in -= 1

    def note(self, who: str, verb: str, **details: object) -> None:
        """Write down what somebody did."""
        self._console.audit.note(verb, who, self.address, details)

    def let_in(self, account: Account, response: Response) -> None:
        """A session in a cookie."""
        key = self._console.sessions.begin(account, self.address)
        secure = self._request.scope.get("scheme") == "https"
        response.headers.append("set-cookie", new_cookie(key, secure))


async def _door(request: Request, console: Served) -> Door:
    return Door(request, console)


AtDoor = Annotated[Door, Depends(_door)]


def me_of(who: Who) -> Me:
    """Who somebody is, for its own eyes."""
    return Me(accounts=not who.open, name=who.name, shown=who.shown, role=who.role.name, client=who.client)


@router.get("/me")
async def me(asking: Asking) -> Me:
    """Who one is here, and what one may do."""
    return me_of(asking)


@router.post("/login", status_code=204)
async def log_in(console: Served, door: AtDoor, given: Login) -> Response:
    """Begin a session, in a cookie."""
    if not console.accounts.any():
        raise Refusal(409, "nobody has an account here: nobody has to log in")
    account = await door.verify(given.name, given.password)
    response = Response(status_code=204)
    await run_in_threadpool(door.let_in, account, response)
    await run_in_threadpool(door.note, account.name, "log_in")
    return response


@router.post("/logout", status_code=204)
def log_out(console: Served, door: AtDoor, asking: Asking) -> Response:
    """End this session."""
    response = Response(status_code=204)
    if not asking.open and console.sessions.end(asking.client):
        console.lease.forget(asking.client)
        door.note(asking.name, "log_out")
    response.headers.append("set-cookie", new_cookie("", secure=False))
    return response


@router.put("/me/password", status_code=204)
async def own_password(door: AtDoor, console: Served, asking: Asking, given: OwnPassword) -> Response:
    """Change one's own password; every other session of the account is over."""
    if asking.open or not asking.session:
        raise Refusal(409, "only somebody who has logged in has a password to change")
    await door.verify(asking.name, given.old)
    account = await run_in_threadpool(console.accounts.change, asking.name, None, given.new)
    response = Response(status_code=204)
    await run_in_threadpool(door.let_in, account, response)
    await run_in_threadpool(door.note, asking.name, "change_own_password")
    return response


@router.get("/users")
def users(console: Served) -> list[UserAnswer]:
    """All accounts."""
    return [_user(console, one) for one in console.accounts.all()]


@router.post("/users", status_code=201)
def add_user(console: Served, door: AtDoor, asking: Asking, new: NewUser) -> UserAnswer:
    """A new account. With the first one, everybody has to log in."""
    made = console.accounts.add(new.name, new.role, new.password)
    door.note(asking.shown, "add_user", name=new.name, role=new.role)
    return _user(console, made)


@router.put("/users/{name}")
def change_user(console: Served, door: AtDoor, asking: Asking, name: str, changed: ChangedUser) -> UserAnswer:
    """Another role or password; the account's sessions are over."""
    before = console.accounts.get(name)
    if before is None:
        raise Refusal(404, f"there is no account {name!r}")
    after = console.accounts.change(name, changed.role, changed.password)
    _end_all_of(console, name)
    roles = [before.role, after.role]
    door.note(asking.shown, "change_user", name=name, role=roles, password=changed.password is not None)
    return _user(console, after)


@router.delete("/users/{name}", status_code=204)
def remove_user(console: Served, door: AtDoor, asking: Asking, name: str) -> Response:
    """Remove an account with its sessions and tokens."""
    if console.accounts.get(name) is None:
        raise Refusal(404, f"there is no account {name!r}")
    console.accounts.remove(name)
    _end_all_of(console, name)
    door.note(asking.shown, "remove_user", name=name)
    return Response(status_code=204)


@router.get("/sessions")
def sessions(console: Served, asking: Asking) -> list[SessionAnswer]:
    """Who is logged in, the latest seen first."""
    return [_session(console, one, asking) for one in console.sessions.all()]


@router.delete("/sessions/{session}", status_code=204)
def end_session(console: Served, door: AtDoor, asking: Asking, session: str) -> Response:
    """Log a browser out; its stream ends with it."""
    ended = console.sessions.end(session)
    if ended is None:
        raise Refusal(404, f"there is no session {session!r}")
    console.lease.forget(ended.id)
    door.note(asking.shown, "end_session", user=ended.user, session=ended.id)
    return Response(status_code=204)


@router.get("/tokens")
def tokens(console: Served) -> list[TokenAnswer]:
    """All tokens, without their secrets."""
    return [_token(one) for one in console.accounts.tokens()]


@router.post("/tokens", status_code=201)
def make_token(console: Served, door: AtDoor, asking: Asking, new: NewToken) -> MadeToken:
    """A token for a script (`Authorization: Bearer ...`), worth at most what its maker is."""
    if not asking.name:
        raise Refusal(409, "a token belongs to an account: make one first")
    if Role.of(new.role) > asking.role:
        raise Refusal(403, f"a token of {asking.shown} can't be worth more than {asking.role.name}")
    token, secret = console.accounts.new_token(asking.name, new.name, new.role, new.days)
    door.note(asking.shown, "make_token", name=new.name, role=new.role, days=new.days)
    return MadeToken(**_token(token).model_dump(), secret=secret)


@router.delete("/tokens/{token}", status_code=204)
def revoke_token(console: Served, door: AtDoor, asking: Asking, token: str) -> Response:
    """Revoke a token by its id."""
    if all(one.id != token for one in console.accounts.tokens()):
        raise Refusal(404, f"there is no token {token!r}")
    revoked = console.accounts.revoke(token)
    console.lease.forget(revoked.id)
    door.note(asking.shown, "revoke_token", name=revoked.name)
    return Response(status_code=204)


def _end_all_of(console: Served, name: str) -> None:
    for session in console.sessions.end_all_of(name):
        console.lease.forget(session.id)


def _when(unix_s: float) -> datetime:
    return datetime.fromtimestamp(unix_s, UTC)


def _user(console: Served, account: Account) -> UserAnswer:
    return UserAnswer(
        name=account.name,
        role=account.rank.name,
        since=_when(account.since_s),
        sessions=sum(one.user == account.name for one in console.sessions.all()),
        tokens=sum(one.user == account.name for one in console.accounts.tokens()),
    )


def _session(console: Served, session: Session, asking: Who) -> SessionAnswer:
    return SessionAnswer(
        id=session.id,
        user=session.user,
        since=_when(session.since_s),
        seen=_when(session.seen_s),
        ends=_when(console.sessions.ends_s(session)),
        address=session.address,
        mine=session.id == asking.client,
    )


def _token(token: Token) -> TokenAnswer:
    return TokenAnswer(
        id=token.id,
        name=token.name,
        user=token.user,
        role=Role.of(token.role).name,
        since=_when(token.since_s),
        until=_when(token.until_s) if token.until_s else None,
    )
