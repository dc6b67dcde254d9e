"""ASGI middleware that lets only allowed requests and WebSockets in, whatever route they are for."""

import json
from http.cookies import SimpleCookie
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bumpless_server.web.auth import COOKIE, Auth
from bumpless_server.web.guesses import Guesses
from bumpless_server.web.known import KEY

PAGE = "/"
OPEN_PATHS = frozenset({"/api/health"})  # for container health checks
SECURITY_HEADERS = {
    "x-content-type-options": "nosniff",
    "x-frame-options": "SAMEORIGIN",
    "referrer-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
}
LOGIN = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Bumpless</title>
<body style="font:16px system-ui;max-width:28rem;margin:20vh auto;padding:0 1rem">
<h1>Bumpless</h1><p>This console asks for its access token.</p>
<form method="get" action="/"><label>Token <input name="token" type="password" autofocus></label>
<button>Open</button></form></body></html>"""


class Guard:
    """Checks host, origin, session and token, and hands out the session cookie with the page."""

    def __init__(self, app: ASGIApp, auth: Auth, guesses: Guesses) -> None:
        self._app, self._auth, self._guesses = app, auth, guesses

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve, or refuse before the route sees anything."""
        if scope["type"] == "websocket":
            headers = Headers(scope=scope)
            if self._auth.refusal("GET", headers, websocket=True) is not None:
                await receive()
                await send({"type": "websocket.close", "code": 1008, "reason": "refused"})
                return
            scope[KEY] = self._auth.who(headers, _address(scope))
            await self._app(scope, receive, send)
        elif scope["type"] == "http":
            await self._http(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    async def _http(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers, path = Headers(scope=scope), scope["path"]
        address = _address(scope)
        tries = self._auth.wrong_bearer(headers) or (path == PAGE and b"token=" in scope["query_string"])
        if tries and (wait_s := self._guesses.wait_s(address)):
            await _refuse(send, 429, f"too many wrong tokens; try again in {wait_s:.0f} s")
            return
        if self._auth.wrong_bearer(headers):
            self._guesses.wrong(address)
        is_page = path == PAGE and scope["method"] in ("GET", "HEAD")
        refusal = self._auth.refusal(scope["method"], headers)
        if refusal is not None and refusal[0] == 401:
            if is_page:
                await self._log_in(scope, send, address)
                return
            if path in OPEN_PATHS:
                refusal = None
        if refusal is not None:
            await _refuse(send, *refusal)
            return
        scope[KEY] = self._auth.who(headers, address)
        cookie = is_page and not self._auth.has_session(headers)

        async def send_more(message: Message) -> None:
            if message["type"] == "http.response.start":
                out = MutableHeaders(scope=message)
                for name, value in SECURITY_HEADERS.items():
                    out.setdefault(name, value)
                if cookie:
                    out.append("set-cookie", self._cookie(scope))
            await send(message)

        await self._app(scope, receive, send_more)

    async def _log_in(self, scope: Scope, send: Send, address: str) -> None:
        """The page of a server with a token: ask for it, or take it and go to the console."""
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
        if self._auth.is_token(given):
            # The redirect takes the token out of the address bar.
            await _answer(send, 303, b"", [("location", PAGE), ("set-cookie", self._cookie(scope))])
        else:
            if given:
                self._guesses.wrong(address)
            body = LOGIN.replace("asks for", "does not know that token; it asks for") if given else LOGIN
            await _answer(send, 401, body.encode(), [("content-type", "text/html; charset=utf-8")])

    def _cookie(self, scope: Scope) -> str:
        jar = SimpleCookie()
        jar[COOKIE] = self._auth.new_session()
        secure = {"secure": "1"} if scope.get("scheme") == "https" else {}
        jar[COOKIE].update({"path": "/", "httponly": "1", "samesite": "Strict", **secure})
        return jar[COOKIE].OutputString()


def _address(scope: Scope) -> str:
    return (scope.get("client") or ("somebody", 0))[0]


async def _refuse(send: Send, status: int, reason: str) -> None:
    body = json.dumps({"detail": reason, "problems": []}).encode()
    await _answer(send, status, body, [("content-type", "application/json")])


async def _answer(send: Send, status: int, body: bytes, headers: list[tuple[str, str]]) -> None:
    raw = [(name.encode(), value.encode("latin-1")) for name, value in headers]
    raw += [(name.encode(), value.encode()) for name, value in SECURITY_HEADERS.items()]
    raw.append((b"content-length", str(len(body)).encode()))
    await send({"type": "http.response.start", "status": status, "headers": raw})
    await send({"type": "http.response.body", "body": body})
