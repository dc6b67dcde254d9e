"""Start viser where only our proxy can reach it: loopback, a free port, a secret in the handshake.

viser has no authentication and checks no Origin, so any page open in a browser on this machine could read
the scene from its port. The proxy adds two headers to the inner handshake: the secret, and the operator's
session, which `SESSION` then carries into viser's own callbacks.
"""

import contextvars
import hmac
import http
import secrets
import threading
from typing import Any

SECRET_HEADER = "X-Scene-Key"
SESSION_HEADER = "X-Scene-Session"
SESSION: contextvars.ContextVar[str] = contextvars.ContextVar("scene_session", default="")

_patching = threading.Lock()


def stop_viser(server: Any) -> None:
    """Stop viser without its farewell on the operator's terminal. Blocks a moment."""
    import rich

    with _patching:
        plain_print, rich.print = rich.print, lambda *_, **__: None
        try:
            server.stop()
        finally:
            rich.print = plain_print


def start_viser() -> tuple[Any, str]:
    """A running ViserServer and the secret that opens its websocket. Blocks a moment: call in a thread."""
    import rich
    import viser
    import websockets.asyncio.server as wss

    secret = secrets.token_urlsafe(24)
    plain_serve, plain_print = wss.serve, rich.print

    def guarded_serve(
        handler: Any, host: str, port: int, *, process_request: Any = None, **options: Any
    ) -> Any:
        def check(connection: Any, request: Any) -> Any:
            offered = request.headers.get(SECRET_HEADER, "")
            if hmac.compare_digest(offered.encode(), secret.encode()):
                return None
            return connection.respond(http.HTTPStatus.FORBIDDEN, "forbidden\n")

        async def with_session(connection: Any) -> None:
            SESSION.set(connection.request.headers.get(SESSION_HEADER, ""))
            await handler(connection)

        return plain_serve(with_session, host, port, process_request=check, **options)

    with _patching:
        wss.serve = guarded_serve
        rich.print = lambda *_, **__: None  # it would announce an address that nobody may use
        try:
            server = viser.ViserServer("127.0.0.1", 0, verbose=False)
        finally:
            wss.serve, rich.print = plain_serve, plain_print
    # A client may ask viser to tunnel the scene to a foreign host; there is no setting against it.
    server.request_share_url = lambda verbose=True: None
    return server, secret
