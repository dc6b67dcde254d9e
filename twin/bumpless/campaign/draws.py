"""Draw by number: what differs in flight i, from a random stream of its own for every quantity.

The share of a quantity is a hash of campaign seed, flight and name. So a draw does not depend on what was
drawn before, in which order or where, and a quantity added to a campaign leaves the others as they were.
"""

import hashlib
from collections.abc import Mapping

from bumpless.campaign.distributions import Distribution, Value
from bumpless.campaign.even import even_shares

FLIGHT = "flight"  # the stream from which the flight's own seed comes


def bits(seed: int, number: int, name: str) -> int:
    """64 random bits of one quantity in one flight."""
    text = f"{seed}/{number}/{name}".encode()
    return int.from_bytes(hashlib.blake2b(text, digest_size=8).digest(), "little")


def share(seed: int, number: int, name: str) -> float:
    """Uniform in [0, 1)."""
    return (bits(seed, number, name) >> 11) * 2.0**-53


def flight_seed(seed: int, number: int) -> int:
    """Seed of the flight's sensors, gusts and biases."""
    return bits(seed, number, FLIGHT) >> 32


def draw(table: Mapping[str, Distribution], seed: int, number: int) -> dict[str, Value]:
    """The values of flight `number`, by quantity."""
    return {name: distribution.at(share(seed, number, name)) for name, distribution in table.items()}


def even_draw(table: Mapping[str, Distribution], seed: int, number: int) -> dict[str, Value]:
    """The same, spread evenly over the flights; each value depends on all names in the table."""
    shares = even_shares(seed, number, len(table)) if table else ()
    return {name: table[name].at(float(share)) for name, share in zip(sorted(table), shares, strict=True)}
