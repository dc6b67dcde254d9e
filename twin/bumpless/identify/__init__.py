"""What a vehicle's thrust, lift and drag truly are, from the log of a flight.

    found = identify([flight_of(run)], vehicle)
    vehicle = learned(vehicle, found)

Thrust and drag balance in steady flight, so neither is known from it; a start, a brake and a turn tell them
apart. What a flight doesn't tell is said to be unknown and changes nothing. `scales` says what may be found,
`forces` what the file's model makes of the flight, `momentum` holds it against how the vehicle moved, and
`learned` writes what was found into the vehicle's file. docs/identification.md has the whole.
"""

from bumpless.identify.fit import Estimate, Found, identify
from bumpless.identify.flight import Flight, flight_of
from bumpless.identify.learned import Change, changes, learned, learned_text

__all__ = [
    "Change",
    "Estimate",
    "Flight",
    "Found",
    "changes",
    "flight_of",
    "identify",
    "learned",
    "learned_text",
]
