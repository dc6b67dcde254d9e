"""A campaign ready to fly: its missions, vehicles and parameters loaded, and what identifies them."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.draws import draw, even_draw, flight_seed
from bumpless.campaign.plain import plain
from bumpless.config.declare import as_table
from bumpless.config.mission import Mission
from bumpless.config.parameters import Parameters, as_dict, with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless.contract.version import software_version
from bumpless.jit.decorator import cache_folder

_SAID = ("tune", "title", "summary")  # of a campaign, what changes no flight


@dataclass(frozen=True)
class Setup:
    """What the flights of one mission have in common."""

    mission: Mission
    vehicle: Vehicle
    parameters: Parameters


@dataclass(frozen=True)
class Prepared:
    """Picklable: this is what workers are sent."""

    campaign: Campaign
    setups: tuple[Setup, ...]
    even: bool = False  # draws are spread evenly over the flights, not left to chance

    def setup(self, number: int) -> Setup:
        """What flight `number` flies."""
        return self.setups[number % len(self.setups)]

    def values(self, number: int) -> dict[str, Any]:
        """The draw of flight `number`."""
        drawn = even_draw if self.even else draw
        return drawn(self.campaign.draw, self.campaign.seed, number)

    def seed(self, number: int) -> int:
        """The seed of flight `number`."""
        return flight_seed(self.campaign.seed, number)

    def with_parameters(self, changes: Mapping[str, Any]) -> "Prepared":
        """The same campaign with other numbers in every setup's parameters."""
        setups = (replace(s, parameters=with_overrides(s.parameters, changes)) for s in self.setups)
        return replace(self, setups=tuple(setups))

    def identity(self) -> dict[str, str]:
        """Hashes of all that decides a flight. Equal identities give equal flights."""
        declared = as_table(self.campaign)
        return {
            "campaign": digest({key: plain(value) for key, value in declared.items() if key not in _SAID}),
            "missions": digest([s.mission.sha256 for s in self.setups]),
            "vehicle": digest([s.vehicle.sha256 for s in self.setups]),
            "parameters": digest([as_dict(s.parameters) for s in self.setups]),
            "software": software(),
        }


def software() -> str:
    """Version and state of the sources that fly, with Python, NumPy and Numba."""
    return f"{software_version()} {cache_folder().name.removeprefix('numba-')}"


def digest(value: Any) -> str:
    """SHA-256 of plain data."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()
