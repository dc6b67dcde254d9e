"""Who may use the console: same-origin requests with a session; a shared token when one is set.

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

from bumpless_server.access.who import Role, Who, public_id
from bumpless_server.settings import Settings

COOKIE = "bumpless_session"
SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
LOOPBACK_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})


def session_cookie(request: HTTPConnection) -> str | None:
    """The session a request or websocket carries, which the guard has checked before any route sees it."""
    return request.cookies.get(COOKIE)


class Auth:
    """Pure decisions on headers; bumpless_server.web.guard applies them to every request and WebSocket."""

    def __init__(self, settings: Settings, key: bytes) -> None:
        token = settings.token.get_secret_value() if settings.token is not None else ""
        self._key = hashlib.sha256(key + token.encode()).digest()  # a new token ends all sessions
        self._token = token
        self._names = {name.lower() for name in settings.allowed_hosts}
        if settings.loopback:
            self._names |= LOOPBACK_NAMES | {settings.host.lower()}
        self._any_host = not settings.loopback and not settings.allowed_hosts

    @property
    def open(self) -> bool:
        """True when no token is asked for."""
        return not self._token

    def new_session(self) -> str:
        """Value of a session cookie that this server will accept, also after a restart."""
        nonce = secrets.token_urlsafe(18)
        return f"{nonce}.{self._sign(nonce)}"

    def is_session(self, cookie: str) -> bool:
        """True for a cookie that `new_session` made."""
        nonce, _, signature = cookie.partition(".")
        return bool(nonce) and hmac.compare_digest(signature.encode(), self._sign(nonce).encode())

    def is_token(self, given: str) -> bool:
        """True for the shared token."""
        return bool(self._token) and hmac.compare_digest(given.encode(), self._token.encode())

    def has_session(self, headers: Mapping[str, str]) -> bool:
        """True when the request carries our cookie."""
        return self.is_session(_cookie(headers))

    def who(self, headers: Mapping[str, str], address: str) -> Who:
        """Who asks, of a request that is not refused."""
        cookie = _cookie(headers)
        client = public_id(cookie if self.is_session(cookie) else address)
        shown = f"Browser {client[:4]}" if self.is_session(cookie) else f"a program at {address}"
        return Who("", Role.engineer, client, shown, open=True)

    def refusal(
        self, method: str, headers: Mapping[str, str], websocket: bool = False
    ) -> tuple[int, str] | None:
        """(status, reason) when a request must not be served; None when it may.

        `headers` have lower-case names.
        """
        if not self._host_is_ours(headers.get("host", "")):
            return 421, "this server is not reached by that host name"
        origin = headers.get("origin")
        changes = websocket or method not in SAFE_METHODS
        if changes and not self._is_same_origin(headers):
            return 403, "requests from another origin are refused"
        identified = self.has_session(headers) or self._has_bearer(headers)
        if websocket and origin is not None and not identified:
            return 403, "no session: open the console's page first"
        if not self.open and not identified:
            return 401, "a token is needed"
        return None

    def _sign(self, nonce: str) -> str:
        return hmac.new(self._key, nonce.encode(), hashlib.sha256).hexdigest()

    def _has_bearer(self, headers: Mapping[str, str]) -> bool:
        kind, _, value = headers.get("authorization", "").partition(" ")
        return kind.lower() == "bearer" and self.is_token(value.strip())

    def _host_is_ours(self, host: str) -> bool:
        return self._any_host or _host_name(host) in self._names

    def _is_same_origin(self, headers: Mapping[str, str]) -> bool:
        origin = headers.get("origin")
        if origin is None:  # not a browser, or an old one that says where it comes from otherwise
            return headers.get("sec-fetch-site", "none") in ("none", "same-origin")
        return _netloc(origin) == headers.get("host", "").lower() != ""

    def wrong_bearer(self, headers: Mapping[str, str]) -> bool:
        """True when the request tries a token that is not ours."""
        return bool(self._token) and "authorization" in headers and not self._has_bearer(headers)


def _cookie(headers: Mapping[str, str]) -> str:
    """The session's cookie; "" without one."""
    try:
        cookie = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
    except CookieError:
        return ""
    return cookie.value if cookie is not None else ""


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
