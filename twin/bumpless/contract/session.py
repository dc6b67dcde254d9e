"""How both sides of the bus configure Zenoh: explicit endpoints, no multicast, quick to notice a loss."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import zenoh

LEASE_MS = 1000  # a frozen peer is missed within about this time
RETRY = {"period_init_ms": 250, "period_max_ms": 500, "period_increase_factor": 2}  # to reach an endpoint
STALLED_PEER_US = 200_000  # how long a blocking put waits for a peer that doesn't read


def settings_of(
    mode: str, connect: Sequence[str] = (), listen: Sequence[str] = (), timestamps: bool = False
) -> dict[str, Any]:
    """What a session in `mode` ("peer", "client" or "router") is told, as Zenoh's configuration files say it.

    `timestamps`: samples carry one; the cache of what a vehicle says sorts by it.
    """
    return {
        "mode": mode,
        "connect": {"endpoints": list(connect), "retry": RETRY},
        "listen": {"endpoints": list(listen)},
        "scouting": {"multicast": {"enabled": False}},
        "transport": {
            "shared_memory": {"enabled": False},
            "link": {
                "tx": {
                    "lease": LEASE_MS,
                    "queue": {"congestion_control": {"block": {"wait_before_close": STALLED_PEER_US}}},
                },
            },
        },
        "timestamping": {"enabled": timestamps},
        "adminspace": {"enabled": True},  # read only; a node asks it who is linked with whom
    }


def session_config(
    mode: str, connect: Sequence[str] = (), listen: Sequence[str] = (), timestamps: bool = False
) -> zenoh.Config:
    """Configuration of a session in `mode` ("peer" or "client"); see `settings_of`."""
    return zenoh.Config.from_json5(json.dumps(settings_of(mode, connect, listen, timestamps)))


def session_file(path: Path) -> zenoh.Config:
    """A Zenoh configuration of one's own, taken as it is. Raises OSError, or ValueError if it is none."""
    text = path.read_text()
    try:
        return zenoh.Config.from_json5(text)
    except zenoh.ZError as error:
        raise ValueError(f"{path} is no Zenoh configuration: {str(error)[:200]}") from error


def endpoints_of(config: zenoh.Config) -> tuple[list[str], list[str]]:
    """(connect, listen) endpoints of a configuration, whatever the mode they stand under."""
    return _endpoints(config, "connect"), _endpoints(config, "listen")


def _endpoints(config: zenoh.Config, side: str) -> list[str]:
    told: Any = json.loads(config.get_json(f"{side}/endpoints"))
    if isinstance(told, dict):  # one list for each mode
        told = told.get(json.loads(config.get_json("mode")) or "peer") or []
    return [one if isinstance(one, str) else str(one.get("endpoint", one)) for one in told or []]


def asks_for_keys(config: zenoh.Config) -> bool:
    """Whether both ends of its TLS links must show a certificate."""
    return json.loads(config.get_json("transport/link/tls/enable_mtls")) is True
