"""`bumpless serve`: the console server on a terminal, from the address it prints to a clean Ctrl-C."""

import errno
import logging
import signal
import socket
import sys

from bumpless_server.settings import Settings

GRACEFUL_S = 3  # a stalled browser must not hold up the end
WS_MAX_BYTES = 64 * 1024 * 1024  # viser's first message holds the whole scene


def run(settings: Settings) -> int:
    """Serve until Ctrl-C or a termination signal; the exit code. Faults are one line on stderr."""
    import uvicorn

    from bumpless.config.vehicle import VehicleError
    from bumpless_server.console import Console
    from bumpless_server.data_dir import DataDirError
    from bumpless_server.live.bus import BusError
    from bumpless_server.web.app import create_app

    _set_up_logging()
    # A terminal that is closed and a service manager end the server as Ctrl-C does.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    # uvicorn takes SIGTERM over while it serves, but no SIGHUP; an exception in its tasks can be lost.
    signal.signal(signal.SIGHUP, lambda number, frame: signal.raise_signal(signal.SIGTERM))
    try:
        listener = _listen(settings.host, settings.port)
    except OSError as error:
        return _fault(_why(error, settings))
    console = None
    try:
        console = Console(settings)
        console.start()
        config = uvicorn.Config(
            create_app(settings, console),
            log_config=None,
            access_log=False,
            ws_per_message_deflate=False,
            ws_max_size=WS_MAX_BYTES,
            timeout_graceful_shutdown=GRACEFUL_S,
        )
        _announce(settings, listener)
        uvicorn.Server(config).run(sockets=[listener])
    except (BusError, DataDirError, VehicleError) as error:
        return _fault(str(error))
    except KeyboardInterrupt:
        pass
    finally:
        listener.close()
        if console is not None and console.started:
            print("Stopping the vehicle node and closing files ...", flush=True)
            console.stop()
    return 0


def _listen(host: str, port: int) -> socket.socket:
    """A listening socket, so that a taken port is known before anything else is started."""
    family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    return socket.create_server(address[:2], family=family, backlog=128)


def _why(error: OSError, settings: Settings) -> str:
    if error.errno == errno.EADDRINUSE:
        return f"port {settings.port} on {settings.host} is taken; choose another with --port"
    return f"cannot serve on {settings.host} port {settings.port}: {error.strerror or error}"


def _announce(settings: Settings, listener: socket.socket) -> None:
    host, port = settings.host, listener.getsockname()[1]
    if not settings.loopback and settings.token is None:
        logging.getLogger("server").warning(
            "everyone who reaches %s can command the vehicle; set BUMPLESS_TOKEN to ask for a token", host
        )
    shown = {"0.0.0.0": "localhost", "::": "localhost"}.get(host, f"[{host}]" if ":" in host else host)
    print(f"Bumpless is at http://{shown}:{port}/  (Ctrl-C ends it)", flush=True)


def _fault(text: str) -> int:
    print(f"bumpless: {text}", file=sys.stderr, flush=True)
    return 1


def _set_up_logging() -> None:
    logging.basicConfig(
        level=logging.INFO, format="%(asctime)s %(levelname)-7s %(message)s", datefmt="%H:%M:%S"
    )
    for chatty in ("uvicorn", "uvicorn.error", "websockets", "viser"):
        logging.getLogger(chatty).setLevel(logging.WARNING)
