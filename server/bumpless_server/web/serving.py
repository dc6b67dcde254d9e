"""How the application is served: uvicorn with limits on what a client may hold."""

from collections.abc import Callable

import uvicorn
from fastapi import FastAPI

from bumpless_server.settings import Settings
from bumpless_server.web.connection import bounded_protocol

GRACEFUL_S = 3  # a stalled browser must not hold up the end
WS_MAX_BYTES = 256 * 1024  # of what a browser may say at once; what we say has no such bound
WS_MAX_QUEUE = 8  # of its messages wait
WS_PING_S, WS_PONG_S = 5.0, 10.0  # a browser that vanished without a word is given up after the sum


def server_config(
    app: FastAPI, note: Callable[[str, str], None], settings: Settings, graceful_s: int = GRACEFUL_S
) -> uvicorn.Config:
    """uvicorn's configuration for `app`; `note(kind, example)` hears of clients that broke a limit."""
    return uvicorn.Config(
        app,
        http=bounded_protocol(note),
        log_config=None,
        access_log=False,
        ws_per_message_deflate=False,  # made large messages eight times slower
        ws_max_size=WS_MAX_BYTES,
        ws_max_queue=WS_MAX_QUEUE,
        ws_ping_interval=WS_PING_S,
        ws_ping_timeout=WS_PONG_S,
        timeout_graceful_shutdown=graceful_s,
        server_header=False,
        # who says from where and how a request came: only a proxy that was named
        proxy_headers=bool(settings.proxies),
        forwarded_allow_ips=list(settings.proxies),
        ssl_certfile=settings.tls_cert,
        ssl_keyfile=settings.tls_key,
    )
