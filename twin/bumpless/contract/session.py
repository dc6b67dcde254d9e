"""How both sides of the bus configure Zenoh: explicit endpoints, no multicast, quick to notice a loss."""

import json
from collections.abc import Sequence

import zenoh

LEASE_MS = 1000  # a frozen peer is missed within about this time
RETRY = {"period_init_ms": 250, "period_max_ms": 1000, "period_increase_factor": 2}  # to reach an endpoint
STALLED_PEER_US = 200_000  # how long a blocking put waits for a peer that doesn't read


def session_config(
    mode: str, connect: Sequence[str] = (), listen: Sequence[str] = (), timestamps: bool = False
) -> zenoh.Config:
    """Configuration of a session in `mode` ("peer" or "client").

    `timestamps`: samples carry one; the cache of a vehicle's events sorts by it.
    """
    config = zenoh.Config()
    for key, value in {
        "mode": mode,
        "connect/endpoints": list(connect),
        "connect/retry": RETRY,
        "listen/endpoints": list(listen),
        "scouting/multicast/enabled": False,
        "transport/shared_memory/enabled": False,
        "transport/link/tx/lease": LEASE_MS,
        "transport/link/tx/queue/congestion_control/block/wait_before_close": STALLED_PEER_US,
        "timestamping/enabled": timestamps,
        "adminspace/enabled": True,  # read only; a node asks it who is linked with whom
    }.items():
        config.insert_json5(key, json.dumps(value))
    return config
