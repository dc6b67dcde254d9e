"""Who asks, and may it be served: same-origin requests of known people; everybody on this machine by default.

A browser sends cookies to every port of a host and lets any page open a WebSocket, so a cookie alone
proves nothing: the Origin must be our own as well. The Host is checked too, or a foreign name that
resolves to this machine would count as our own origin (DNS rebinding).
"""

import hashlib
import hmac
import secrets
from collections.abc import Mapping
from http.cookies import CookieError, SimpleCookie
from urllib.parse import urlsplit

from starlette.requests import HTTPConnection

from bumpless_server.access.accounts import Accounts
from bumpless_server.access.rights import Right
from bumpless_server.access.sessions import Sessions
from bumpless_server.access.who import Role, Who, public_id
from bumpless_server.settings import Settings

COOKIE = "bumpless_session"
SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
HEALTH = "/api/health"  # asked by the machine itself
LOOPBACK_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})

Headers = Mapping[str, str]  # names in lower case


def session_cookie(request: HTTPConnection) -> str | None:
    """The session a request or websocket carries, which the guard has checked before any route sees it."""
    return request.cookies.get(COOKIE)


class Auth:
    """Decisions on headers; bumpless_server.web.guard applies them to every request and WebSocket."""

    def __init__(self, settings: Settings, key: bytes, accounts: Accounts, sessions: Sessions) -> None:
        self._key = hashlib.sha256(key).digest()
        self._accounts, self._sessions = accounts, sessions
        self._demanded = settings.accounts_needed
        self._by_proxy_alone = bool(settings.proxies) and not settings.plain_http
        self._names = {name.lower() for name in settings.allowed_hosts}
        if settings.loopback:
            self._names |= LOOPBACK_NAMES | {settings.host.lower()}
        self._any_host = not settings.loopback and not settings.allowed_hosts

    @property
    def open(self) -> bool:
        """True while nobody has to log in: reached from this machine alone, and no account was made."""
        return not self._demanded and not self._accounts.any()

    def new_session(self) -> str:
        """A cookie for a browser that need not log in; it holds also after a restart."""
        nonce = secrets.token_urlsafe(18)
        return f"{nonce}.{self._sign(nonce)}"

    def is_session(self, cookie: str) -> bool:
        """True for a cookie that `new_session` made."""
        nonce, _, signature = cookie.partition(".")
        return bool(nonce) and hmac.compare_digest(signature.encode(), self._sign(nonce).encode())

    def has_session(self, headers: Headers) -> bool:
        """True when the request carries a cookie that counts."""
        cookie = cookie_of(headers)
        return self.is_session(cookie) if self.open else self._sessions.find(cookie) is not None

    def who(self, headers: Headers, address: str) -> Who | None:
        """Who asks; None for somebody who would have to log in."""
        if secret := _bearer(headers):
            if token := self._accounts.by_token(secret):
                shown = f"{token.name} ({token.user})"
                return Who(token.user, Role.of(token.role), token.id, shown)
            if not self.open:
                return None
        cookie = cookie_of(headers)
        if self.open:
            known = self.is_session(cookie)
            client = public_id(cookie if known else address)
            shown = f"Browser {client[:4]}" if known else f"a program at {address}"
            return Who("", Role.engineer, client, shown, cookie if known else "", open=True)
        if found := self._sessions.find(cookie):
            session, account = found
            return Who(account.name, account.rank, session.id, account.name, cookie)
        return None

    def bare(self, scheme: str, path: str) -> tuple[int, str] | None:
        """(status, reason) for a request that came past the proxy that ends TLS, or without its word."""
        if not self._by_proxy_alone or scheme in ("https", "wss") or path == HEALTH:
            return None
        return 403, "this server is reached by HTTPS, through its proxy"

    def foreign(self, method: str, headers: Headers, websocket: bool = False) -> tuple[int, str] | None:
        """(status, reason) for a request by another host name or from another page than ours."""
        if not self._host_is_ours(headers.get("host", "")):
            return 421, "this server is not reached by that host name"
        changes = websocket or method not in SAFE_METHODS
        if changes and not self._is_same_origin(headers):
            return 403, "requests from another origin are refused"
        return None

    def refusal(
        self, who: Who | None, right: Right, headers: Headers, websocket: bool = False
    ) -> tuple[int, str] | None:
        """(status, reason) when a request that comes from our own page must not be served."""
        if websocket and "origin" in headers and (who is None or not who.session):
            return 403, "no session: open the console's page first"
        if right.role is None:
            return None
        if who is None:
            return 401, "log in first"
        if who.role < right.role:
            return 403, f"this needs the role {right.role.name}; {who.shown} is {who.role.name}"
        return None

    def wrong_bearer(self, headers: Headers) -> bool:
        """True when the request tries a token that is not ours."""
        secret = _bearer(headers)
        return bool(secret) and not self.open and self._accounts.by_token(secret) is None

    def _sign(self, nonce: str) -> str:
        return hmac.new(self._key, nonce.encode(), hashlib.sha256).hexdigest()

    def _host_is_ours(self, host: str) -> bool:
        return self._any_host or _host_name(host) in self._names

    def _is_same_origin(self, headers: Headers) -> bool:
        origin = headers.get("origin")
        if origin is None:  # not a browser, or an old one that says where it comes from otherwise
            return headers.get("sec-fetch-site", "none") in ("none", "same-origin")
        return _netloc(origin) == headers.get("host", "").lower() != ""


def _bearer(headers: Headers) -> str:
    kind, _, value = headers.get("authorization", "").partition(" ")
    return value.strip() if kind.lower() == "bearer" else ""


def cookie_of(headers: Headers) -> str:
    """The session's cookie; "" without one."""
    try:
        cookie = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
    except CookieError:
        return ""
    return cookie.value if cookie is not None else ""


def new_cookie(value: str, secure: bool) -> str:
    """The header that gives a browser its session; "" takes it away."""
    jar = SimpleCookie()
    jar[COOKIE] = value
    jar[COOKIE].update({"path": "/", "httponly": "1", "samesite": "Strict"})
    if secure:
        jar[COOKIE]["secure"] = "1"
    if not value:
        jar[COOKIE]["max-age"] = "0"
    return jar[COOKIE].OutputString()


def _host_name(host: str) -> str:
    """Name or address in a Host header; "" when it is none."""
    try:
        return (urlsplit(f"//{host}").hostname or "").lower()
    except ValueError:
        return ""


def _netloc(origin: str) -> str:
    """Host and port in an Origin header; "" when it is none."""
    try:
        return urlsplit(origin).netloc.lower()
    except ValueError:
        return ""
