"""A bus with keys, on a real router: who has none gets nowhere, and nobody does more than its role may."""

import contextlib
import stat
from collections.abc import Iterator
from pathlib import Path

import pytest
import zenoh
from typer.testing import CliRunner

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import endpoints_of, session_file
from bumpless.node.publisher import BusWriter
from bumpless_server.cli.main import app
from bumpless_server.keys import folder as keyring
from bumpless_server.keys.access import Party, rights
from bumpless_server.keys.authority import common_name_of, new_authority, sign_party
from tests.node.listening import PATIENCE_S, Listener, light_node_with, program
from tests.ports import free_port

OTHERS = ("ts100", "other")


def open_file(path: Path) -> zenoh.Session:
    return zenoh.open(session_file(path))


@pytest.fixture(scope="module")
def ring(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Keys of a fleet of two vehicles, made by the command."""
    out = tmp_path_factory.mktemp("fleet") / "keys"
    words = ["keys", "init", "--out", str(out), "--port", str(free_port()), "--host", "127.0.0.1"]
    words += [word for vehicle in OTHERS for word in ("--vehicle", vehicle)] + ["--observer", "ashore"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    return out


@pytest.fixture(scope="module")
def router(ring: Path) -> Iterator[Path]:
    """The fleet's router in a process of its own; the folder of the keys."""
    with program("-m", "tests.node.router", "--config", str(ring / "router.json5")) as process:
        assert process.stdout is not None and process.stdout.readline().strip() == "routing"
        yield ring


@contextlib.contextmanager
def console(ring: Path) -> Iterator[Listener]:
    """A server's session with the router that hears and asks ts100."""
    with open_file(ring / "server.json5") as session:
        yield Listener(session)


def at(ring: Path) -> str:
    return endpoints_of(session_file(ring / "server.json5"))[0][0]


def refused(config: zenoh.Config) -> bool:
    config.insert_json5("connect/timeout_ms", "2000")
    try:
        zenoh.open(config).close()
    except zenoh.ZError:
        return True
    return False


def stranger(endpoint: str, **tls: object) -> zenoh.Config:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("connect/endpoints", f'["{endpoint}"]')
    for name, value in tls.items():
        config.insert_json5(f"transport/link/tls/{name}", f'"{value}"')
    return config


def test_strangers_cannot_connect(router: Path, tmp_path: Path) -> None:
    """Protects: whoever shares the network could stop and start the vehicle."""
    authority = str(router / "authority.crt")
    assert refused(stranger(at(router).replace("tls/", "tcp/")))
    assert refused(stranger(at(router), root_ca_certificate=authority)), "without a certificate"
    own = sign_party(new_authority("somebody else"), "vehicle.ts100")
    (tmp_path / "key.pem").write_bytes(own.key)
    (tmp_path / "crt.pem").write_bytes(own.certificate)
    pair = {"connect_private_key": tmp_path / "key.pem", "connect_certificate": tmp_path / "crt.pem"}
    assert refused(stranger(at(router), root_ca_certificate=authority, **pair)), "signed by somebody else"
    without_password = session_file(router / "vehicle.ts100.json5")
    without_password.insert_json5("transport/auth/usrpwd/password", '"guessed"')
    assert refused(without_password)
    assert not refused(session_file(router / "vehicle.ts100.json5"))


def test_a_vehicle_is_flown_through_the_router(router: Path) -> None:
    """Protects: rights that are too narrow would leave a fleet with keys deaf."""
    config = router / "vehicle.ts100.json5"
    with console(router) as bus, light_node_with(zenoh_config=str(config)):
        bus.until_alive()
        assert bus.start().accepted
        bus.until(lambda: [s for s in bus.of("tlm/mission") if s.phase == pb.MISSION_PHASE_RUNNING])
        bus.until(lambda: bus.of("event"))
        bus.session.put(keys.heartbeat("ts100"), pb.Heartbeat(time_ns=1).SerializeToString())
        with open_file(router / "observer.ashore.json5") as session:
            watcher = Listener(session)
            watcher.until_alive()
            watcher.until(lambda: watcher.of("tlm/navigation"))
        assert bus.ask("abort").accepted


def test_an_observer_may_listen_and_no_more(router: Path) -> None:
    """Protects: who may look must not command, speak, answer or be taken for a vehicle."""
    asked: list[str] = []
    with open_file(router / "vehicle.ts100.json5") as vehicle, console(router) as bus:
        commands = vehicle.declare_queryable(keys.command("ts100", "*"), _answer_as("vehicle", asked))
        token = vehicle.liveliness().declare_token(keys.alive("ts100"))
        bus.until_alive()
        with open_file(router / "observer.ashore.json5") as observer:
            observer.liveliness().declare_token(keys.claim("ts100", 1, str(observer.zid())))
            observer.put(keys.telemetry("ts100", "navigation"), b"forged")
            observer.put(keys.heartbeat("ts100"), b"forged")
            assert list(observer.get(keys.command("ts100", "abort"), timeout=PATIENCE_S)) == []
            foreign = observer.declare_queryable(keys.command("ts100", "*"), _answer_as("observer", asked))
            assert _who_answers(bus, "ts100") == ["vehicle"]
            assert list(bus.session.liveliness().get(keys.claim("ts100", "*", "*"))) == []
            foreign.undeclare()
        assert bus.heard == [] and asked == ["vehicle"]
        commands.undeclare()
        token.undeclare()


def test_a_vehicle_speaks_and_answers_for_itself_alone(router: Path) -> None:
    """Protects: one vehicle of the fleet, or who took its keys, must not fly another's screen."""
    asked: list[str] = []
    with open_file(router / "vehicle.other.json5") as other, console(router) as bus:
        BusWriter(other, "ts100", wait=True).put("tlm/navigation", pb.Navigation())
        other.liveliness().declare_token(keys.alive("ts100"))
        commands = other.declare_queryable(keys.command("ts100", "*"), _answer_as("other", asked))
        own = other.declare_queryable(keys.command("other", "*"), _answer_as("other itself", asked))
        mine = other.liveliness().declare_token(keys.alive("other"))
        lived: list[str] = []
        while keys.alive("other") not in lived:
            replies = bus.session.liveliness().get(f"{keys.ROOT}/*/alive")
            lived = [str(reply.ok.key_expr) for reply in replies if reply.ok]
        assert lived == [keys.alive("other")]
        assert _who_answers(bus, "ts100") == []
        assert _who_answers(bus, "other") == ["other itself"]
        assert bus.heard == [] and bus.alive == []
        for one in (commands, own, mine):
            one.undeclare()


def test_keys_are_for_their_owner_alone(ring: Path) -> None:
    """Protects: a private key or a password that others on the machine can read is none."""
    for path in ring.iterdir():
        assert stat.S_IMODE(path.stat().st_mode) == 0o600, path
    assert {path.name for path in ring.iterdir()} == {
        "authority.crt", "authority.key", "fleet.json", "users.txt", "router.json5", "server.json5",
        "vehicle.ts100.json5", "vehicle.other.json5", "observer.ashore.json5",
    }  # fmt: skip
    own = sign_party(new_authority(), "vehicle.ts100", ["::1", "router"])
    assert common_name_of(own.certificate) == "vehicle.ts100"


def test_keys_are_made_once_added_and_taken(tmp_path: Path) -> None:
    """Protects: a second `init` would lock out everybody who has keys; a removed party keeps no right."""
    run = CliRunner()
    made = ["--out", str(tmp_path)]
    assert run.invoke(app, ["keys", "init", *made]).exit_code == 0
    again = run.invoke(app, ["keys", "init", *made])
    assert again.exit_code == 1 and "there are keys already" in again.output
    before = (tmp_path / "server.json5").read_bytes()
    assert run.invoke(app, ["keys", "add", "vehicle", "pod", *made]).exit_code == 0
    router = (tmp_path / "router.json5").read_text()
    assert "vehicle.pod" in router and "vehicle.pod" in (tmp_path / "users.txt").read_text()
    assert (tmp_path / "server.json5").read_bytes() == before
    assert run.invoke(app, ["keys", "add", "vehicle", "../pod", *made]).exit_code == 1
    assert run.invoke(app, ["keys", "add", "admiral", "x", *made]).exit_code == 1
    assert run.invoke(app, ["keys", "remove", "vehicle", "pod", *made]).exit_code == 0
    assert "vehicle.pod" not in (tmp_path / "router.json5").read_text()
    assert not (tmp_path / "vehicle.pod.json5").exists()
    with pytest.raises(keyring.KeysError, match="no keys"):
        keyring.read(tmp_path / "nowhere")


def test_no_role_may_say_what_is_anothers() -> None:
    """Protects: the table itself; only a vehicle says telemetry, only the server commands."""
    for party, says, asks in (
        (Party("observer", "x"), False, False),
        (Party("server"), False, True),
        (Party("vehicle", "a"), True, False),
    ):
        said = [key for right in rights(party) if "put" in right.messages for key in right.keys]
        asked = [key for right in rights(party) if "query" in right.messages for key in right.keys]
        assert (keys.telemetry("a", "*") in said) is says
        assert any("/cmd/" in key for key in asked) is asks
        assert not any(key.startswith(f"{keys.ROOT}/*/") and "/tlm/" in key for key in said)


def _answer_as(who: str, asked: list[str]):
    def answer(query: zenoh.Query) -> None:
        asked.append(who)
        with query:
            query.reply(query.key_expr, who.encode())

    return answer


def _who_answers(bus: Listener, vehicle: str) -> list[str]:
    replies = bus.session.get(
        keys.command(vehicle, "pause"),
        timeout=PATIENCE_S,
        target=zenoh.QueryTarget.ALL,
        consolidation=zenoh.ConsolidationMode.NONE,
    )
    return [reply.ok.payload.to_string() for reply in replies if reply.ok]
