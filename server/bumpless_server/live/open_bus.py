"""Whether strangers may speak on the bus: who shares a network with it and needs no key."""

import re
from collections.abc import Sequence

_PLAIN_LOCAL = re.compile(r"\w+/(127\.[\d.]+|localhost|\[::1\]):\d+")
_KEYED = ("tls/", "quic/")


def bus_notice(listen: Sequence[str], connect: Sequence[str], asks_for_keys: bool = False) -> str:
    """One sentence while the bus reaches a network without keys; "" when only key holders can.

    `asks_for_keys`: whoever comes over TLS must show a certificate; else its encryption keeps nobody out.
    """
    bare = [
        endpoint
        for endpoint in (*listen, *connect)
        if not _PLAIN_LOCAL.match(endpoint) and not (asks_for_keys and endpoint.startswith(_KEYED))
    ]
    if not bare:
        return ""
    return f"The bus has no keys: whoever reaches {', '.join(bare)} can command the vehicle and speak for it"
