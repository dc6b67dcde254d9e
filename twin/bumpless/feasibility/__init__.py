"""What a vehicle can do of a mission, from the very model and rules that fly it: before it is flown.

`station_keeping` says which headings can hold station in a current, for how long and why not; `check_mission`
says what of a mission can't work or is unlikely to, with the nearest change that would.
"""

from bumpless.feasibility.finding import HARD, SOFT, Finding, Mend
from bumpless.feasibility.holding import arcs
from bumpless.feasibility.mission import check_mission, station_of
from bumpless.feasibility.station import ACCEPT, REFUSE, WARN, Station, station_keeping

__all__ = [
    "ACCEPT",
    "HARD",
    "REFUSE",
    "SOFT",
    "WARN",
    "Finding",
    "Mend",
    "Station",
    "arcs",
    "check_mission",
    "station_keeping",
    "station_of",
]
