"""A small valid mission to start from."""

import pytest

from bumpless.config.vehicle import Vehicle, load_vehicle

GOOD = """\
version: 1
name: short
vehicle: ts100
duration_s: 60
start: {position_ned_m: [0, 0, 2], heading_deg: 0}
legs:
  - {to_ned_m: [20, 0, 2.5], speed_mps: 0.7}
target: {position_ned_m: [22, 0, 2.5], heading_deg: 90, standoff_m: 1.5}
"""


@pytest.fixture(scope="session")
def good() -> str:
    """YAML of a valid mission for ts100."""
    return GOOD


@pytest.fixture(scope="session")
def ts100() -> Vehicle:
    """The vehicle of the paper."""
    return load_vehicle("ts100")
