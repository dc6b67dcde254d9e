"""The flight that the tests of views look at, with Foxglove's topics in its log."""

import pytest

from bumpless_server.views.foxglove import Foxglove
from tests.runs.flights import Flight, make_flight


@pytest.fixture(scope="session")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    """See `make_flight`."""
    return make_flight(tmp_path_factory.mktemp("log"), [Foxglove()])
