"""Random requests by the OpenAPI document, valid and not, as each role; every answer is judged.

An answer is a fault when it is a 5xx, when its status, type or shape is not declared, when the role had no
right to it, or when it does not come in time.
"""

import collections
import contextlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import requests
import schemathesis
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from hypothesis.errors import Unsatisfiable
from schemathesis.generation import GenerationMode
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from bumpless_server.access.rights import right_of
from bumpless_server.access.who import Role

DECLARED = [status_code_conformance, content_type_conformance, response_schema_conformance]
HANG_S = 180.0  # flying a run again takes a while on a busy machine
REFUSED = (401, 403)
NOT_BY_ROLE = (405, 413, 421, 429)  # decided before or without the role
MOST_FAULTS = 20  # told


@dataclass
class Tally:
    """What came of the cases of one role."""

    role: Role
    cases: int = 0
    statuses: collections.Counter[int] = field(default_factory=collections.Counter)
    faults: collections.Counter[str] = field(default_factory=collections.Counter)
    examples: list[str] = field(default_factory=list)

    def fault(self, kind: str, case: Any, detail: str) -> None:
        """Note a fault; the first ones with the request that shows it."""
        self.faults[kind] += 1
        if len(self.examples) < MOST_FAULTS:
            self.examples.append(f"{kind}: {detail}\n    {case.as_curl_command()}"[:2000])

    def lines(self) -> Iterator[str]:
        """For people."""
        by_hundred = collections.Counter(f"{status // 100}xx" for status in self.statuses.elements())
        seen = ", ".join(f"{count} {name}" for name, count in sorted(by_hundred.items()))
        yield f"{self.role.name:<9} {self.cases:6} cases: {seen}; {sum(self.faults.values())} faults"
        for kind, count in self.faults.items():
            yield f"    {count} {kind}"
        yield from (f"  {example}" for example in self.examples)


def fuzz(
    url: str, document: dict[str, Any], role: Role, token: str, known: dict[str, list[str]], cases: int,
    start: int = 0,
) -> Tally:  # fmt: skip
    """Send `cases` requests, spread over all operations. `known`: names that exist, by path parameter."""
    tally = Tally(role)
    schema = schemathesis.openapi.from_dict(document)
    operations = [found.ok() for found in schema.get_all_operations()]
    share = -(-cases // (2 * len(operations)))
    with requests.Session() as session:
        session.headers["authorization"] = f"Bearer {token}"
        for number, operation in enumerate(operations):
            for mode in GenerationMode:
                strategy = st.tuples(operation.as_strategy(generation_mode=mode), st.data())
                _drive(strategy, share, start + number, lambda case: _judge(case, url, session, tally), known)
    return tally


def _drive(strategy: Any, share: int, start: int, judge: Any, known: dict[str, list[str]]) -> None:
    @seed(start)
    @settings(
        max_examples=share,
        deadline=None,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategy)
    def run(drawn: Any) -> None:
        case, data = drawn
        for name in case.path_parameters or {}:
            if name in known and data.draw(st.booleans()):
                case.path_parameters[name] = data.draw(st.sampled_from(known[name]))
        judge(case)

    with contextlib.suppress(Unsatisfiable):  # what asks for nothing can't be asked wrongly
        run()


def _judge(case: Any, url: str, session: requests.Session, tally: Tally) -> None:
    tally.cases += 1
    try:
        response = case.call(base_url=url, session=session, timeout=HANG_S)
    except requests.Timeout:
        tally.fault("hang", case, f"no answer in {HANG_S:.0f} s")
        return
    except requests.RequestException as error:
        tally.fault("connection", case, str(error))
        return
    status = response.status_code
    tally.statuses[status] += 1
    if status >= 500:
        tally.fault("5xx", case, f"{status} {response.text[:200]}")
    path = requests.utils.unquote(requests.utils.urlparse(response.request.url).path)
    right = right_of(case.method.upper(), path)
    may = right.role is None or tally.role >= right.role
    if not may and status not in (*REFUSED, *NOT_BY_ROLE):
        tally.fault("right exceeded", case, f"{status} for {tally.role.name}, {case.method} {path}")
    if may and status == 403 and path != "/api/tokens":
        tally.fault("right refused", case, f"{status} for {tally.role.name}, {case.method} {path}")
    try:
        case.validate_response(response, checks=DECLARED)
    except (Exception, BaseExceptionGroup) as error:
        tally.fault("undeclared", case, f"{status} {case.method} {case.operation.path}: {str(error)[:600]}")
