"""Logs from elsewhere, over HTTP and by the folder: in the list with their figures, or refused."""

from collections.abc import Iterator
from pathlib import Path

import pytest

import bumpless
from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.runs.flights import Flight, make_flight
from tests.runs.test_adopt import foreign
from tests.server.serving import Running, serving


@pytest.fixture(scope="module")
def logged(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    return make_flight(tmp_path_factory.mktemp("log"))


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Running]:
    """A server without a vehicle, that takes logs up to 20 MB."""
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    settings = Settings(
        data_dir=tmp_path / "data", zenoh_listen=bus, scene="off", manage_node=False, import_bytes=20_000_000
    )
    with serving(settings) as running:
        assert running.console.keeper.indexed.wait(60)
        yield running


def bring(server: Running, name: str, data: bytes) -> tuple[int, dict]:
    got = server.http.post("/api/runs-import", params={"name": name}, content=data)
    return got.status_code, got.json()


def test_logs_are_brought_in(server: Running, logged: Flight, tmp_path: Path) -> None:
    """Protects import by drag: ours, another recorder's, and twice the same name."""
    status, ours = bring(server, "from_sea.mcap", logged.path.read_bytes())
    assert status == 201 and ours["id"] == "from_sea" and ours["outcome"]
    status, again = bring(server, "from_sea.mcap", logged.path.read_bytes())
    assert status == 201 and again["id"] == "from_sea-copy2"
    theirs = foreign(logged, tmp_path / "theirs.mcap").read_bytes()
    status, told = bring(server, "theirs.mcap", theirs)
    assert status == 201 and told["metrics"]["d_u_rh"] == pytest.approx(ours["metrics"]["d_u_rh"])
    use = server.http.get("/api/runs-disk").json()
    assert use["runs"] == 3 and use["runs_bytes"] > 2 * len(logged.path.read_bytes())
    assert use["free_bytes"] > 0 and use["bin"] == 0


@pytest.mark.parametrize(
    ("name", "data", "status", "why"),
    [
        ("a.mcap", b"not a log", 422, "not an MCAP file"),
        ("a.mcap", b"", 422, "not an MCAP file"),
        ("../a.mcap", b"x", 422, "must be"),
        (".mcap", b"x", 422, "must be"),
        ("a.mcap", b"\x00" * 20_000_001, 413, "at most"),
    ],
)
def test_strange_files_are_refused(server: Running, name: str, data: bytes, status: int, why: str) -> None:
    """Protects the list and the disk from hostile files: one sentence, and nothing is left."""
    got, told = bring(server, name, data)
    assert (got, why in told["detail"]) == (status, True), told
    assert not list(server.console.data.runs.iterdir())
    assert not list(server.console.data.scratch.iterdir())


def test_a_file_put_into_the_folder_is_noticed(server: Running, logged: Flight, tmp_path: Path) -> None:
    """Protects who copies a log by hand while the server runs: it is in the list, and the console is told."""
    foreign(logged, tmp_path / "by_hand.mcap").rename(server.console.data.runs / "by_hand.mcap")
    found = server.until(lambda: server.console.catalogue.row("by_hand"))
    assert bumpless.open_run(server.console.data.runs / "by_hand.mcap").metrics.cycles > 0
    assert found.summary.metrics
