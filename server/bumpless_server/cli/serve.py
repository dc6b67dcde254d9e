"""`bumpless serve`: the console server on a terminal, from the address it prints to a clean Ctrl-C."""

import contextlib
import errno
import logging
import os
import signal
import socket
import sys

from bumpless_server.settings import Settings


def run(settings: Settings) -> int:
    """Serve until Ctrl-C or a termination signal; the exit code. Faults are one line on stderr."""
    import uvicorn

    from bumpless.config.vehicle import VehicleError
    from bumpless_server.access.accounts import AccountsError
    from bumpless_server.console import Console
    from bumpless_server.data_dir import DataDirError
    from bumpless_server.live.bus import BusError
    from bumpless_server.web.app import create_app
    from bumpless_server.web.serving import server_config

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
        config = server_config(create_app(settings, console), console.tally.note, settings)
        _announce(settings, listener)
        uvicorn.Server(config).run(sockets=[listener])
    except (AccountsError, BusError, DataDirError, VehicleError) as error:
        return _fault(str(error))
    except OSError as error:
        return _fault(f"cannot be started: {error}")
    except KeyboardInterrupt:
        pass
    finally:
        listener.close()
        if console is not None and console.started:
            _say("Stopping the vehicle node and closing files ...")
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
    if settings.plain_http and not settings.loopback:
        logging.getLogger("server").warning(
            "passwords come to %s without TLS: publish its port to loopback alone", host
        )
    scheme = "https" if settings.tls_cert else "http"
    shown = {"0.0.0.0": "localhost", "::": "localhost"}.get(host, f"[{host}]" if ":" in host else host)
    _say(f"Bumpless is at {scheme}://{shown}:{port}/  (Ctrl-C ends it)")


def _say(text: str) -> None:
    """A line for the terminal. Its reader may be gone, as `tee` is after the same Ctrl-C."""
    try:
        print(text, flush=True)
    except OSError:
        # what is still in the buffer must not fail once more when the interpreter ends
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _fault(text: str) -> int:
    with contextlib.suppress(OSError):
        print(f"bumpless: {text}", file=sys.stderr, flush=True)
    return 1


def _set_up_logging() -> None:
    logging.basicConfig(
        level=logging.INFO, format="%(asctime)s %(levelname)-7s %(message)s", datefmt="%H:%M:%S"
    )
    for chatty in ("uvicorn", "uvicorn.error", "websockets", "viser"):
        logging.getLogger(chatty).setLevel(logging.WARNING)
