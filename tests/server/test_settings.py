"""Settings: an unknown or wrong one is a clear message, never silently ignored."""

import pytest

from bumpless_server.settings import Settings, SettingsError, load_settings
from bumpless_server.vehicle_process.node_command import node_command


def test_defaults_are_loopback_only() -> None:
    """Out of the box nobody but this machine reaches console or bus."""
    settings = Settings()
    assert settings.loopback
    assert all("/127.0.0.1:" in endpoint for endpoint in settings.zenoh_listen)


def test_an_unknown_variable_is_named_with_the_nearest_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """A typing error in the environment must not leave the default in force unnoticed."""
    monkeypatch.setenv("BUMPLESS_PROT", "9000")
    with pytest.raises(SettingsError, match="BUMPLESS_PROT: no such setting; did you mean BUMPLESS_PORT"):
        load_settings()


def test_every_wrong_value_is_told_with_its_source(monkeypatch: pytest.MonkeyPatch) -> None:
    """All faults at once, each with where it came from."""
    monkeypatch.setenv("BUMPLESS_PORT", "many")
    monkeypatch.setenv("BUMPLESS_SESSION_HOURS", "-1")
    with pytest.raises(SettingsError) as caught:
        load_settings(vehicle="No Such Id")
    lines = str(caught.value).splitlines()
    assert [line.split(":")[0].split(" ")[0] for line in sorted(lines)] == [
        "BUMPLESS_PORT",
        "BUMPLESS_SESSION_HOURS",
        "vehicle",
    ]


def test_lists_and_commands_are_written_as_people_write_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Endpoints separated by commas, a command as in a shell; an option beats the environment."""
    monkeypatch.setenv("BUMPLESS_ZENOH_CONNECT", "tcp/10.0.0.1:7447, tcp/10.0.0.2:7447")
    monkeypatch.setenv("BUMPLESS_NODE_COMMAND", "my-vehicle --name 'sea cat'")
    monkeypatch.setenv("BUMPLESS_PORT", "9000")
    settings = load_settings(port=9001, host=None)
    assert settings.zenoh_connect == ("tcp/10.0.0.1:7447", "tcp/10.0.0.2:7447")
    assert settings.node_command == ("my-vehicle", "--name", "sea cat")
    assert (settings.port, settings.host) == (9001, "127.0.0.1")


def test_the_node_connects_to_where_the_server_listens() -> None:
    """A server that listens on every address is still reached by its own node."""
    settings = Settings(zenoh_listen=("tcp/0.0.0.0:7447",))
    assert node_command(settings)[-2:] == ("--connect", "tcp/127.0.0.1:7447")


def test_a_vehicle_file_names_its_id(tmp_path) -> None:
    """The id on the bus is the vehicle file's own."""
    from bumpless.config.vehicle import load_vehicle

    path = tmp_path / "mine.toml"
    path.write_text(load_vehicle("ts100").text)
    assert Settings(vehicle=str(path)).vehicle_id == "ts100"


def test_an_empty_value_is_no_value(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: an empty secret was ignored, and the console was open to everyone; a list may be empty."""
    monkeypatch.setenv("BUMPLESS_TLS_CERT", "")
    with pytest.raises(SettingsError, match="BUMPLESS_TLS_CERT is empty; give it a value or leave it out"):
        load_settings()
    monkeypatch.delenv("BUMPLESS_TLS_CERT")
    monkeypatch.setenv("BUMPLESS_ZENOH_LISTEN", "")
    assert load_settings().zenoh_listen == ()


def test_a_server_beside_a_router_leaves_it_its_port() -> None:
    """Protects: the field recipe failed where router and server share a machine: both wanted port 7447."""
    settings = load_settings(zenoh_connect=("tcp/127.0.0.1:7447",))
    assert settings.zenoh_listen == ()
    assert node_command(settings)[-2:] == ("--connect", "tcp/127.0.0.1:7447")
    both = load_settings(zenoh_connect=("tcp/10.0.0.1:7447",), zenoh_listen=("tcp/0.0.0.0:7448",))
    assert both.zenoh_listen == ("tcp/0.0.0.0:7448",)


def test_the_shared_token_of_before_is_told_to_be_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: who still sets the token must not believe that it guards the console."""
    monkeypatch.setenv("BUMPLESS_TOKEN", "correct horse")
    with pytest.raises(SettingsError, match="BUMPLESS_TOKEN: is gone: people have accounts") as caught:
        load_settings()
    assert "correct horse" not in str(caught.value)


def test_passwords_travel_by_tls_beyond_loopback() -> None:
    """Protects: a server that others reach never takes passwords in the clear by accident."""
    with pytest.raises(SettingsError, match="passwords need TLS: give tls_cert and tls_key"):
        load_settings(host="0.0.0.0")
    with pytest.raises(SettingsError, match="tls_cert and tls_key belong together"):
        load_settings(host="0.0.0.0", tls_cert="c.pem")
    with pytest.raises(SettingsError, match=r"proxies"):
        load_settings(host="0.0.0.0", proxies=("*",))
    for more in (
        {"tls_cert": "c.pem", "tls_key": "k.pem"},
        {"proxies": ("10.0.0.7",)},
        {"plain_http": True},
    ):
        assert load_settings(host="0.0.0.0", **more).accounts_needed
    assert not load_settings().accounts_needed
    assert load_settings(allowed_hosts=("console.example",)).accounts_needed  # a proxy on this machine
