"""ASGI middleware that lets only allowed requests and WebSockets in, whatever route they are for."""

import asyncio
import json

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bumpless_server.access.lease import Lease, NotHolder
from bumpless_server.access.rights import right_of
from bumpless_server.access.who import Who
from bumpless_server.live.tally import printable
from bumpless_server.web.auth import Auth, new_cookie
from bumpless_server.web.guesses import Guesses
from bumpless_server.web.known import KEY, address_of, author_of
from bumpless_server.web.turned_away import Refused, TurnAway, nobody_told

PAGE, LOGIN = "/", "/login"
RECHECK_S = 1.0  # between two looks at whether who listens may still
ENDED = 4401  # close code of a WebSocket whose session is over
SECURITY_HEADERS = {
    "x-content-type-options": "nosniff",
    "x-frame-options": "SAMEORIGIN",
    "referrer-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=(), usb=()",
}
OVER_TLS = {"strict-transport-security": "max-age=31536000"}


class Guard:
    """Checks host, origin, who asks, the role it takes and who holds control; writes down who asks."""

    def __init__(
        self, app: ASGIApp, auth: Auth, guesses: Guesses, lease: Lease, turn_away: TurnAway = nobody_told
    ) -> None:
        self._app, self._auth, self._guesses, self._lease = app, auth, guesses, lease
        self._turn_away = turn_away

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve, or refuse before the route sees anything."""
        if scope["type"] == "websocket":
            await self._websocket(scope, receive, send)
        elif scope["type"] == "http":
            await self._http(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    async def _websocket(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers, address = Headers(scope=scope), address_of(scope)
        who = self._auth.who(headers, address)
        refusal = (
            self._auth.bare(scope.get("scheme", ""), scope["path"])
            or self._auth.foreign("GET", headers, websocket=True)
            or self._auth.refusal(who, right_of("WS", scope["path"]), headers, websocket=True)
        )
        if refusal is not None or who is None:
            await self._told(scope, "WS", refusal or (403, "nobody is known"), who)
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": "refused"})
            return
        scope[KEY] = who

        async def heard() -> Message:
            """What the browser says, or its end when whom it belongs to is logged out meanwhile."""
            task = asyncio.ensure_future(receive())
            try:
                while not (await asyncio.wait({task}, timeout=RECHECK_S))[0]:
                    now = self._auth.who(headers, address)
                    if now is None or now.client != who.client:
                        await send({"type": "websocket.close", "code": ENDED, "reason": "logged out"})
                        return {"type": "websocket.disconnect", "code": ENDED}
                return task.result()
            finally:
                task.cancel()

        await self._app(scope, heard, send)

    async def _http(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers, method, path = Headers(scope=scope), scope["method"], scope["path"]
        address = address_of(scope)
        bare = self._auth.bare(scope.get("scheme", ""), path)
        if refusal := bare or self._auth.foreign(method, headers) or self._guessed(headers, address):
            await self._told(scope, method, refusal, None)
            await _refuse(send, *refusal)
            return
        who, right = self._auth.who(headers, address), right_of(method, path)
        if refusal := self._auth.refusal(who, right, headers):
            if refusal[0] == 401 and path == PAGE and method in ("GET", "HEAD"):
                await _answer(send, 303, b"", [("location", LOGIN)])
            else:
                await self._told(scope, method, refusal, who)
                await _refuse(send, *refusal)
            return
        if who is not None and right.control:
            try:
                self._lease.check(who)
            except NotHolder as error:
                await self._told(scope, method, (423, str(error)), who)
                await _refuse(send, 423, str(error))
                return
        scope[KEY] = who
        await self._app(scope, receive, self._with_headers(scope, send, headers, who))

    async def _told(self, scope: Scope, method: str, refusal: tuple[int, str], who: Who | None) -> None:
        """Let the audit know, before the answer goes."""
        author = author_of(who, Headers(scope=scope)) if who is not None else ""
        request = printable(f"{method} {scope['path']}")
        await self._turn_away(Refused(request, *refusal, author, address_of(scope)))

    def _guessed(self, headers: Headers, address: str) -> tuple[int, str] | None:
        """Note a wrong token; (status, reason) for somebody who has given too many."""
        if "authorization" not in headers or not self._auth.wrong_bearer(headers):
            return None
        if wait_s := self._guesses.wait_s(address):
            return 429, f"too many wrong guesses; try again in {wait_s:.0f} s"
        self._guesses.wrong(address, "a token")
        return 401, "this token is not in force"

    def _with_headers(self, scope: Scope, send: Send, headers: Headers, who: Who | None) -> Send:
        secure = scope.get("scheme") == "https"
        wants_cookie = scope["path"] == PAGE and scope["method"] in ("GET", "HEAD") and self._auth.open
        cookie = wants_cookie and who is not None and not who.session

        async def send_more(message: Message) -> None:
            if message["type"] == "http.response.start":
                out = MutableHeaders(scope=message)
                for name, value in (SECURITY_HEADERS | (OVER_TLS if secure else {})).items():
                    out.setdefault(name, value)
                if scope["path"].startswith("/api/"):
                    out.setdefault("cache-control", "no-store")
                if cookie:
                    out.append("set-cookie", new_cookie(self._auth.new_session(), secure))
            await send(message)

        return send_more


async def _refuse(send: Send, status: int, reason: str) -> None:
    body = json.dumps({"detail": reason, "problems": []}).encode()
    await _answer(send, status, body, [("content-type", "application/problem+json")])


async def _answer(send: Send, status: int, body: bytes, headers: list[tuple[str, str]]) -> None:
    raw = [(name.encode(), value.encode("latin-1")) for name, value in headers]
    raw += [(name.encode(), value.encode()) for name, value in SECURITY_HEADERS.items()]
    raw += [(b"content-length", str(len(body)).encode()), (b"cache-control", b"no-store")]
    if status == 401:
        raw.append((b"www-authenticate", b"Bearer"))
    await send({"type": "http.response.start", "status": status, "headers": raw})
    await send({"type": "http.response.body", "body": body})
