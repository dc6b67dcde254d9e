"""Exports, counterfactuals and flights ahead over HTTP: whole files, new runs, and clear refusals."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from mcap.reader import make_reader

import bumpless
from bumpless_server.settings import Settings
from tests.ports import free_port
from tests.server.serving import Running, serving

MISSION = Path(__file__).parents[3] / "missions" / "docking.yaml"
RUN = "20260101T000000Z-docking-ab12"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """A server without a vehicle that has recorded one flight, and holds one file that is no log."""
    data = tmp_path_factory.mktemp("data")
    (data / "runs").mkdir()
    bumpless.fly(MISSION).save(data / "runs" / f"{RUN}.mcap")
    (data / "runs" / "junk.mcap").write_bytes(b"\x89MCAP0\r\n" + b"\xff" * 100)
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=data, zenoh_listen=bus, scene="off", manage_node=False)) as running:
        assert running.console.keeper.indexed.wait(60)
        running.http.timeout = 120.0
        yield running


def test_a_range_comes_as_a_whole_file(server: Running, tmp_path: Path) -> None:
    """Protects what is sent to somebody: it opens with the official reader and holds the range alone."""
    got = server.http.get(f"/api/runs/{RUN}/export", params={"as": "mcap", "from_s": 10, "to_s": 12})
    assert got.status_code == 200, got.text
    assert got.headers["content-disposition"] == f'attachment; filename="{RUN}-part.mcap"'
    path = tmp_path / "part.mcap"
    path.write_bytes(got.content)
    with path.open("rb") as file:
        messages = list(make_reader(file).iter_messages(topics=["tlm/navigation"]))
    assert len(messages) == 41
    assert not list(server.console.data.scratch.iterdir())


def test_signals_come_as_a_table(server: Running) -> None:
    """Protects spreadsheets, and tells of a signal that is none."""
    query = {"as": "csv", "from_s": 1, "to_s": 1.1, "signal": "navigation.depth_m"}
    got = server.http.get(f"/api/runs/{RUN}/export", params=query)
    assert got.text.splitlines()[0] == "cycle,time_s,time_ns,navigation.depth_m"
    wrong = server.http.get(f"/api/runs/{RUN}/export", params=query | {"signal": "depth"})
    assert wrong.status_code == 422 and "no signal 'depth'" in wrong.json()["detail"]


@pytest.mark.parametrize(
    ("run", "query", "status"),
    [
        ("nothing", {}, 404),
        ("..%2Fsecret", {}, 404),
        ("junk", {"as": "csv"}, 422),
        (RUN, {"as": "exe"}, 422),
        (RUN, {"from_s": "nan"}, 422),
        (RUN, {"from_s": 20, "to_s": 10}, 422),
        (RUN, {"from_s": 5000}, 422),
        (RUN, {"as": "csv", "signal": "a\0b"}, 422),
    ],
)
def test_what_cannot_be_exported_says_why(server: Running, run: str, query: dict, status: int) -> None:
    """Protects from silence, and from files outside the folder."""
    got = server.http.get(f"/api/runs/{run}/export", params=query)
    assert got.status_code == status
    assert got.json()["detail"]
    assert not list(server.console.data.scratch.iterdir())


def test_a_counterfactual_becomes_a_run(server: Running) -> None:
    """Protects "what would have been": in the list, named after what was changed, and comparable at once."""
    body = {"parameters": {"hover.lambda": 0.5, "allocation.allocator": "wls"}}
    got = server.http.post(f"/api/runs/{RUN}/refly", json=body)
    assert got.status_code == 201, got.text
    again = server.http.get(f"/api/runs/{got.json()['id']}").json()
    assert again["tags"] == ["counterfactual"]
    assert again["title"] == 'docking: hover.lambda 0.5, allocation.allocator "wls"'
    assert again["outcome"]
    compared = server.http.get("/api/compare", params={"run": [RUN, again["id"]]}).json()
    assert "hover.lambda" in [row["name"] for row in compared["settings"]]


@pytest.mark.parametrize(
    ("body", "why"),
    [
        ({"parameters": {"hover.lambda": -1}}, "hover.lambda"),
        ({"parameters": {"--out=/tmp/x": 1}}, "must be section.key"),
        ({"vehicle": "nowhere"}, "no such vehicle"),
        ({"vehicle": "../../etc/passwd"}, "not valid"),
        ({"speed": 1}, "not valid"),
        ({"parameters": {"a.b\0": 1}}, "cannot be asked for"),
        ({"parameters": {"hover.lambda": "x" * 3_000_000}}, "cannot be asked for"),
    ],
)
def test_what_cannot_be_flown_again_says_why(server: Running, body: dict, why: str) -> None:
    """Protects from flying something else than was asked, and from paths in place of names."""
    before = sorted(path.name for path in server.console.data.runs.iterdir())
    got = server.http.post(f"/api/runs/{RUN}/refly", json=body)
    assert got.status_code == 422 and why in got.json()["detail"], got.text
    assert sorted(path.name for path in server.console.data.runs.iterdir()) == before


def test_nothing_is_flown_ahead_of_a_vehicle_that_is_not_heard(server: Running) -> None:
    """Protects from forecasts of a vehicle that has gone."""
    got = server.http.post("/api/what-if", json={"parameters": {}, "horizon_s": 30})
    assert got.status_code == 409 and "not heard" in got.json()["detail"]
    assert server.http.post("/api/what-if", json={"parameters": {}, "horizon_s": 1e9}).status_code == 422


def test_foxgloves_layout_is_served(server: Running) -> None:
    """Protects the way from the console to Foxglove."""
    assert "configById" in server.http.get("/api/foxglove_layout.json").json()
