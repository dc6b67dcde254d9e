"""How the node joins the bus follows from where it is told to connect."""

import json

import pytest

from bumpless.node.session import choose_mode, node_config


@pytest.mark.parametrize(
    ("connect", "listen", "mode"),
    [
        (["tcp/127.0.0.1:7447"], [], "peer"),
        (["tcp/localhost:7447", "tcp/[::1]:7447"], [], "peer"),
        (["tcp/router:7447"], [], "client"),
        (["tcp/router:7447"], ["tcp/0.0.0.0:7448"], "peer"),
        (["tcp/127.0.0.1:7447", "tls/router:7447"], [], "client"),
        ([], [], "peer"),
    ],
)
def test_a_way_to_another_machine_makes_a_client(connect: list[str], listen: list[str], mode: str) -> None:
    """A router passes nothing between two peers, so across machines a vehicle must be its client."""
    assert choose_mode(connect, listen) == mode


def test_nothing_listens_beyond_this_machine_unless_told_to() -> None:
    """Multicast off, no shared memory, and a peer's own endpoint on loopback."""
    config = node_config(["tcp/127.0.0.1:7447"])
    assert json.loads(config.get_json("listen/endpoints")) == ["tcp/127.0.0.1:0"]
    assert json.loads(config.get_json("scouting/multicast/enabled")) is False
    assert json.loads(config.get_json("transport/link/tx/lease")) == 1000
    client = node_config(["tcp/router:7447"])
    assert json.loads(client.get_json("listen/endpoints")) == []
