"""No request can fill the server's memory, whether it announces its length or not."""

from collections.abc import Iterator

import pytest

from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

RULE = "a request's body must have at most 20000 bytes"
BLOCK = b" " * 1000


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """A server without a vehicle."""
    folder = tmp_path_factory.mktemp("limited")
    with serving(
        Settings(data_dir=folder, zenoh_listen=(), manage_node=False, scene="off", upload_bytes=20_000)
    ) as server:
        yield server


REQUESTS = [
    ("POST", "/api/mission/start"),
    ("POST", "/api/missions?name=big"),
    ("PUT", "/api/parameters"),
    ("PUT", "/api/presets/big"),
]


@pytest.mark.parametrize(("method", "path"), REQUESTS)
@pytest.mark.parametrize("announced", [True, False])
def test_a_body_too_long_is_refused_with_the_rule(
    alone: Running, method: str, path: str, announced: bool
) -> None:
    """Protects: the start of a mission read whatever was sent; one that tells no length is counted."""
    content = BLOCK * 21 if announced else iter([BLOCK] * 21)
    reply = alone.http.request(method, path, content=content, headers={"content-type": "application/json"})
    assert (reply.status_code, reply.json()["detail"]) == (413, RULE)


def test_a_body_that_fits_is_read(alone: Running) -> None:
    """At the limit nothing is refused for its length."""
    content = b'{"name": "nowhere"}'.ljust(20_000)
    reply = alone.http.post(
        "/api/mission/start", content=content, headers={"content-type": "application/json"}
    )
    assert reply.status_code == 404
