"""A small, repeatable share of `make fuzz` in every run of the suite."""

import json
from collections.abc import Iterator

import pytest

from bumpless_server.access.who import Role
from tests.fuzz.fuzz import fuzz
from tests.fuzz.served import Fuzzed, fuzzed

CASES = 160


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


def test_the_judge_sees_what_it_looks_for(served: Fuzzed) -> None:
    """Protects: a fuzzer that finds nothing because it looks at nothing."""
    document = json.loads(json.dumps(served.document))
    kept = ("/api/missions/{name}", "/api/users")
    document["paths"] = {path: document["paths"][path] for path in kept}
    for methods in document["paths"].values():
        for operation in methods.values():
            operation["responses"] = {"418": {"description": "what never comes"}}
    token = served.tokens[Role.engineer]
    tally = fuzz(served.running.url, document, Role.observer, token, served.known, 40)
    assert tally.faults["undeclared"] > 10 and tally.faults["right exceeded"] > 3
