"""The containers run the same three processes as a field machine; their words must fit the command line."""

from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML

from bumpless.contract.keys import check_vehicle_id

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def services() -> dict[str, Any]:
    """The services of docker-compose.yml."""
    return YAML(typ="safe").load(ROOT / "docker-compose.yml")["services"]


def test_three_separate_services(services: dict[str, Any]) -> None:
    """Router, server and vehicle must be able to fail and restart one by one."""
    assert set(services) == {"router", "server", "vehicle"}
    assert all(service["init"] and service["restart"] == "unless-stopped" for service in services.values())
    assert services["server"]["depends_on"] == services["vehicle"]["depends_on"] == ["router"]


def test_commands_exist_with_these_options(services: dict[str, Any]) -> None:
    """A renamed command or option must not be found out in the field."""
    from typer.main import get_command

    from bumpless_server.cli.main import app

    group: Any = get_command(app)
    for name in ("server", "vehicle"):
        verb, *options = services[name]["command"]
        command = group.commands[verb]
        context = command.make_context(verb, list(options), resilient_parsing=True)
        assert not context.args
        known = {flag for parameter in command.params for flag in parameter.opts}
        assert {word for word in options if word.startswith("--")} <= known


def test_settings_understand_the_environment(
    services: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every variable must be a setting of the server, with a value it can read."""
    from bumpless_server.settings import Settings

    environment = services["server"]["environment"]
    for name, value in environment.items():
        monkeypatch.setenv(name, str(value))
    settings = Settings().model_dump()
    fields = {name.removeprefix("BUMPLESS_").lower() for name in environment}
    assert fields <= settings.keys()
    assert settings["manage_node"] is False
    assert list(settings["zenoh_connect"]) == ["tcp/router:7447"]


def test_everyone_meets_at_the_router(services: dict[str, Any]) -> None:
    """Server and vehicle must dial the address that the router listens on."""
    vehicle = services["vehicle"]["command"]
    router = services["router"]["command"]
    port = router[router.index("--listen") + 1].rsplit(":", 1)[1]
    assert vehicle[vehicle.index("--connect") + 1] == f"tcp/router:{port}"
    assert "--no-multicast-scouting" in router
    check_vehicle_id(vehicle[vehicle.index("--id") + 1])


def test_console_is_published_on_loopback_only(services: dict[str, Any]) -> None:
    """Plain HTTP: the console must not be offered to a network by default."""
    published = {name: service.get("ports", []) for name, service in services.items()}
    assert published == {"router": [], "server": ["127.0.0.1:8080:8080"], "vehicle": []}


def test_secrets_come_from_files_and_stand_in_no_environment(services: dict[str, Any]) -> None:
    """Protects: what stands in an environment is inherited by children and shown by `docker inspect`."""
    whole = YAML(typ="safe").load(ROOT / "docker-compose.yml")
    (secret,) = services["server"]["secrets"]
    assert whole["secrets"][secret]["file"].startswith("./secrets/")
    environment = services["server"]["environment"]
    assert environment["BUMPLESS_FIRST_PASSWORD_FILE"] == f"/run/secrets/{secret}"
    words = "password", "token", "secret", "key"
    assert [n for n in environment if any(w in n.lower() for w in words) and not n.endswith("_FILE")] == []
    assert "/secrets/" in (ROOT / ".gitignore").read_text()
    assert "secrets" in (ROOT / ".dockerignore").read_text().splitlines()


def test_every_container_is_confined(services: dict[str, Any]) -> None:
    """Protects: a service that is taken over can't write, gain rights or starve the machine."""
    for name, service in services.items():
        assert service["read_only"] is True and service["cap_drop"] == ["ALL"], name
        assert service["security_opt"] == ["no-new-privileges:true"], name
        assert service["mem_limit"] and service["cpus"] and service["pids_limit"], name
        assert service["logging"]["options"].keys() == {"max-size", "max-file"}, name
    assert services["server"]["healthcheck"]["test"][0] == "CMD"
    dockerfile = (ROOT / "Dockerfile").read_text()
    assert "\nUSER 10001\n" in dockerfile
