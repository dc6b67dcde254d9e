"""A small, repeatable share of `make fuzz` in every run of the suite."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from bumpless_server.access.who import Role
from tests.fuzz.fuzz import fuzz
from tests.fuzz.served import Fuzzed, fuzzed

CASES = 300


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Fuzzed]:
    with fuzzed(tmp_path_factory.mktemp("fuzz")) as running:
        yield running


@pytest.mark.parametrize("role", list(Role))
def test_requests_that_nobody_would_make_surprise_nobody(served: Fuzzed, role: Role) -> None:
    """Protects: no 5xx, no undeclared answer, no hang and no right exceeded, as any role."""
    tally = fuzz(served.running.url, served.document, role, served.tokens[role], served.known, CASES)
    assert tally.cases > CASES // 2
    assert not tally.faults, "\n".join(tally.lines())
