"""The flight that all tests of logs look at, without views."""

import pytest

from tests.runs.flights import Flight, make_flight


@pytest.fixture(scope="session")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    """See `make_flight`."""
    return make_flight(tmp_path_factory.mktemp("log"))
