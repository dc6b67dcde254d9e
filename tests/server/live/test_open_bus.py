"""Whether strangers may speak on the bus is told by how its links are made, not by what they are called."""

from pathlib import Path

import pytest

from bumpless_server.live.bus import Bus, BusError
from bumpless_server.live.open_bus import bus_notice
from bumpless_server.live.speaker import Speaker
from bumpless_server.live.tally import Tally


def bus(config: Path) -> Bus:
    return Bus("ts100", (), (), lambda _: None, lambda _: None, Speaker(), Tally(), config=config)


def test_only_links_that_ask_for_keys_count_as_keyed() -> None:
    """Protects: encryption without certificates of the callers keeps nobody out."""
    assert bus_notice(["tcp/127.0.0.1:7447"], []) == ""
    assert "The bus has no keys" in bus_notice(["tcp/0.0.0.0:7447"], [])
    assert "The bus has no keys" in bus_notice(["tls/0.0.0.0:7447"], [])
    assert bus_notice(["tls/0.0.0.0:7447"], ["quic/router:7447"], asks_for_keys=True) == ""
    assert "tcp/router:1" in bus_notice([], ["tls/router:7447", "tcp/router:1"], asks_for_keys=True)


def test_a_configuration_of_ones_own_is_read_for_what_it_is(tmp_path: Path) -> None:
    """Protects: the notice follows the file in use, and a file that is none is told in one line."""
    path = tmp_path / "own.json5"
    path.write_text("{mode: 'peer', connect: {endpoints: ['tcp/router:7447']}, // mine\n}")
    assert "tcp/router:7447" in bus(path).notice
    path.write_text("{mode: 'client', connect: {endpoints: {client: ['tls/router:7447']}},"
                    " transport: {link: {tls: {enable_mtls: true}}}}")  # fmt: skip
    assert bus(path).notice == ""
    path.write_text("{mode: 'admiral'}")
    with pytest.raises(BusError, match="is no Zenoh configuration"):
        bus(path)
    with pytest.raises(BusError, match="cannot open the bus"):
        bus(tmp_path / "none")
