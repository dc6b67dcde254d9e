"""Small campaigns, and one real Dask cluster of two processes for all of them."""

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import pytest

from bumpless.campaign.cluster import opened
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import parse_campaign

if TYPE_CHECKING:
    from distributed import Client

HEAD = """version: 1
name: small
missions: [docking]
count: {count}
seed: 7
"""
DRAW = """draw:
  current_speed_mps: {uniform: [0, 0.1]}
  current_relative_deg: {uniform: [0, 360]}
  lag: {loguniform: [0.5, 2]}
"""


@pytest.fixture
def campaign() -> Callable[..., Prepared]:
    """Makes a campaign of `count` docking flights in drawn currents, with more text under it."""

    def made(count: int = 6, more: str = "", draw: str = DRAW) -> Prepared:
        return parse_campaign(HEAD.format(count=count) + draw + more)

    return made


@pytest.fixture(scope="package")
def cluster() -> Iterator["Client"]:
    """A client of two worker processes."""
    with opened(workers=2) as client:
        yield client
