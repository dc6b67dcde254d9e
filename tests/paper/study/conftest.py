"""Every scenario flown once for all tests of the study."""

from collections.abc import Callable
from functools import cache

import pytest

from bumpless.sim.twin import Result
from bumpless_paper.study.fly import Job, fly


@pytest.fixture(scope="session")
def flight() -> Callable[[str], Result]:
    """The scenario's flight on the nominal plant, seed 1."""

    @cache
    def flown(name: str) -> Result:
        return fly(Job(name))

    return flown
