"""A claim is decided before its vehicle speaks, however late the links to others come up."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
import zenoh

from bumpless.contract import keys
from bumpless.node import claim, links
from bumpless.node.claim import Claim, TakenError
from bumpless.node.session import node_config
from tests.node.gate import Gate, gate
from tests.node.listening import PATIENCE_S
from tests.ports import free_port


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """What takes milliseconds on a quiet machine may take seconds on a busy one."""
    monkeypatch.setattr(links, "PATIENCE_S", PATIENCE_S)
    monkeypatch.setattr(links, "ANSWER_S", PATIENCE_S)
    monkeypatch.setattr(claim, "ASK_S", PATIENCE_S)


@contextmanager
def apart() -> Iterator[tuple[zenoh.Session, zenoh.Session, Gate]]:
    """Two nodes' sessions on one bus that reach each other only when the gate opens."""
    hub, port = f"tcp/127.0.0.1:{free_port()}", free_port()
    with gate(port) as door, zenoh.open(node_config([], [hub], "peer")):
        config = node_config([hub, f"tcp/127.0.0.1:{door.port}"], [], "peer")
        config.insert_json5("scouting/gossip/enabled", "false")  # no other way to the first than the gate
        with zenoh.open(node_config([hub], [f"tcp/127.0.0.1:{port}"], "peer")) as first:
            with zenoh.open(config) as second:
                yield first, second, door


def lives_alone(session: zenoh.Session, monkeypatch: pytest.MonkeyPatch) -> Claim:
    """The claim of a live vehicle, which waits for nobody: whom it hears of stands behind a closed gate."""
    live = Claim(session, "ts100")
    with monkeypatch.context() as hasty:
        hasty.setattr(links, "PATIENCE_S", 0.0)
        live.stake()
    live.declare_alive()
    return live


def test_a_stake_waits_for_the_link_to_a_vehicle_that_others_hear(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: a node whose link to the live vehicle comes last took the id for free, and spoke."""
    with apart() as (first, second, door):
        live = lives_alone(first, monkeypatch)
        found: list[str] = []

        def stake() -> None:
            try:
                Claim(second, "ts100", connects=True).stake()
            except TakenError as error:
                found.append(str(error))

        staking = threading.Thread(target=stake)
        staking.start()
        door.open()
        staking.join(PATIENCE_S)
        assert found == ["ts100 is already alive on this bus; not starting a second one"]
        live.release()


def test_a_link_that_comes_during_the_preparation_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: an id that was free when staked is looked at again before the vehicle speaks."""
    with apart() as (first, second, door):
        live = lives_alone(first, monkeypatch)
        late = Claim(second, "ts100", connects=True)
        with monkeypatch.context() as hasty:
            hasty.setattr(links, "PATIENCE_S", 0.0)
            late.stake()
        door.open()
        with pytest.raises(TakenError, match="already alive"):
            late.confirm()
        live.release()


def test_of_two_claims_the_younger_is_not_confirmed() -> None:
    """Protects: of two that start at once the younger is told so before it speaks, not a moment after."""
    with apart() as (first, second, door):
        older, younger = Claim(first, "ts100"), Claim(second, "ts100")
        door.open()
        older.stake()
        younger.stake()
        older.confirm()
        with pytest.raises(TakenError, match="giving way"):
            younger.confirm()


def test_a_claim_that_nobody_stands_behind_ends_no_node() -> None:
    """Protects: a stranger's forged claim, older than any, made the live vehicle leave the bus."""
    with apart() as (first, second, door):
        door.open()
        live = Claim(first, "ts100")
        live.stake()
        live.declare_alive()
        forged = keys.claim("ts100", 1, str(second.zid()))
        seen = threading.Event()
        watching = first.liveliness().declare_subscriber(forged, lambda _: seen.set(), history=True)
        token = second.liveliness().declare_token(forged)
        assert seen.wait(PATIENCE_S)
        assert live.contested() is None
        serving = second.declare_queryable(keys.schema("ts100"), _answer, complete=True)
        while live.contested() is None:  # until the declaration has travelled
            pass
        token.undeclare()
        serving.undeclare()
        watching.undeclare()


def _answer(query: zenoh.Query) -> None:
    with query:
        query.reply(query.key_expr, b"a contract")
