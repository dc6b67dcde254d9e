"""What the console's page may load."""

import re

import pytest

from bumpless_server.web.routes.page import POLICY, policy_of


def test_nothing_comes_from_elsewhere_by_default() -> None:
    """Protects who is offline, and from scripts of others: one origin, no exception."""
    assert policy_of("") == POLICY and "http" not in POLICY


@pytest.mark.parametrize(
    ("tiles", "allowed"),
    [
        ("https://tile.example.org/{z}/{x}/{y}.png", "https://tile.example.org"),
        ("http://user:word@10.0.0.2:8081/{z}/{x}/{y}?a;script-src *", "http://10.0.0.2:8081"),
    ],
)
def test_a_base_map_may_be_fetched_from_its_one_server_as_pictures_only(tiles: str, allowed: str) -> None:
    """Protects the policy from a setting: the server's name alone goes in, no path, word or directive."""
    added = policy_of(tiles).removeprefix(POLICY)
    assert added == f"; img-src 'self' {allowed}"
    assert not re.search(r"script|word", added)
