"""Files stay files, and a flight in pieces is one flight; views of the list are shared, and audited."""

import re
from collections.abc import Iterator

import pytest

import bumpless
from bumpless_server.settings import Settings
from tests.pieces import in_pieces
from tests.ports import free_port
from tests.server.serving import Running, serving

CUT, AGAIN, HELD = 12.0, 19.5, 5.0


@pytest.fixture(scope="module")
def flown() -> bumpless.Run:
    """One flight."""
    return bumpless.fly("docking")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory, flown: bumpless.Run) -> Iterator[Running]:
    """A server without a vehicle that finds a flight in three files, as a crash has left them."""
    data = tmp_path_factory.mktemp("data")
    (data / "runs").mkdir()
    in_pieces(flown, data / "runs", CUT, AGAIN, HELD)
    bus = (f"tcp/127.0.0.1:{free_port()}",)
    with serving(Settings(data_dir=data, zenoh_listen=bus, scene="off", manage_node=False)) as running:
        assert running.console.keeper.indexed.wait(60)
        running.http.timeout = 120.0
        yield running


def test_a_flight_is_told_over_its_files_and_the_files_as_they_are(
    server: Running, flown: bumpless.Run
) -> None:
    """Protects both readers: people see one flight with its gap, tools each file with its own figures."""
    run = flown.info.run_id
    listed = {row["id"]: row for row in server.http.get("/api/runs").json()}
    assert {name: row["piece"] for name, row in listed.items()} == {run: 1, f"{run}.2": 2, f"{run}.3": 3}
    assert [listed[name]["outcome"] for name in (run, f"{run}.3")] == ["interrupted", None]
    assert listed[run]["seed"] == flown.info.seed
    for name in listed:
        flight = server.http.get(f"/api/runs/{name}/flight").json()
        assert [piece["id"] for piece in flight["pieces"]] == [run, f"{run}.2", f"{run}.3"]
        assert flight["outcome"] == flown.outcome.ending
        assert flight["metrics"]["cycles"] + flight["metrics"]["missing_cycles"] == flown.metrics.cycles
        (gap,) = flight["gaps"]
        assert gap["last_s"] - gap["first_s"] == pytest.approx(AGAIN - CUT, abs=0.11)
    own = server.http.get(f"/api/runs/{run}/metrics").json()
    assert own["missing_cycles"] == 0 and own["duration_s"] == pytest.approx(CUT, abs=0.11)
    assert server.http.get("/api/runs/nothing/flight").status_code == 404


def test_replay_report_and_comparison_are_of_the_flight(server: Running, flown: bumpless.Run) -> None:
    """Protects people from half a flight: each of them spans the pieces and tells of the gap."""
    run = flown.info.run_id
    replay = server.http.get(f"/api/runs/{run}/replay").json()
    assert replay["last_s"] > flown.columns.time[-1] + HELD - 1.0
    assert len(replay["pieces"]) == 3 and len(replay["gaps"]) == 1
    assert server.http.get(f"/api/runs/{run}/at", params={"t": 40}).status_code == 200
    report = server.http.get(f"/api/runs/{run}/report.html").text
    assert re.search(r"Not all of it was recorded:</strong> 1[12]\.\d to 19\.\d s is missing", report)
    both = server.http.get("/api/compare", params={"run": [run, f"{run}.2"]}).json()
    assert [one["outcome"] for one in both["runs"]] == [flown.outcome.ending] * 2


def test_a_log_that_comes_twice_is_a_copy_and_no_piece(server: Running, flown: bumpless.Run) -> None:
    """Protects a flight from a file that was sent back: it stands beside it, under a name that says so."""
    run = flown.info.run_id
    body = (server.console.data.runs / f"{run}.2.mcap").read_bytes()
    got = server.http.post("/api/runs-import", params={"name": f"{run}.mcap"}, content=body).json()
    assert (got["id"], got["piece"], got["run_id"]) == (f"{run}-copy2", 0, run)
    alone = server.http.get(f"/api/runs/{got['id']}/flight").json()
    assert [piece["id"] for piece in alone["pieces"]] == [got["id"]]
    assert len(server.http.get(f"/api/runs/{run}/flight").json()["pieces"]) == 3


def test_views_are_kept_for_all_and_the_audit_says_by_whom(server: Running) -> None:
    """Protects what a crew agreed to look at: kept on the server, changed by name, forgotten on demand."""
    view = {"words": "calm", "outcome": "docked", "columns": ["closest", "seed"]}
    kept = server.http.put("/api/run-views/Calm and docked", json=view, headers={"x-operator": "Ada"})
    assert kept.json() == {"name": "Calm and docked", "author": "Ada", **view}
    assert server.http.get("/api/run-views").json() == [kept.json()]
    again = server.http.put("/api/run-views/Calm and docked", json={"words": "rough"}).json()
    assert (again["words"], again["columns"]) == ("rough", [])
    assert server.http.delete("/api/run-views/Calm and docked").status_code == 204
    assert server.http.delete("/api/run-views/Calm and docked").status_code == 404
    assert server.http.get("/api/run-views").json() == []
    told = [(e["verb"], e["author"]) for e in server.http.get("/api/audit").json() if "view" in e["verb"]]
    assert told[-1] == ("save_run_view", "Ada") and [verb for verb, _ in told] == [
        "forget_run_view",
        "save_run_view",
        "save_run_view",
    ]


@pytest.mark.parametrize(
    ("name", "body"),
    [
        (" blank", {}),
        ("a%0Ab", {}),
        ("x" * 61, {}),
        ("a", {"columns": ["nothing"]}),
        ("a", {"outcome": "won"}),
        ("a", {"words": "x" * 201}),
        ("a", {"more": 1}),
    ],
)
def test_what_is_no_view_is_refused(server: Running, name: str, body: dict) -> None:
    """Protects the list that all share from a line that would break it."""
    assert server.http.put(f"/api/run-views/{name}", json=body).status_code == 422
    assert server.http.get("/api/run-views").json() == []


def test_who_threw_a_run_away_stands_in_the_audit(server: Running, flown: bumpless.Run) -> None:
    """Protects records: what was thrown away, taken back or renamed is told with its author."""
    run = f"{flown.info.run_id}.3"
    by = {"x-operator": "Bo"}
    assert server.http.put(f"/api/runs/{run}/words", json={"title": "Hold"}, headers=by).status_code == 204
    assert server.http.delete(f"/api/runs/{run}", headers=by).status_code == 204
    assert server.http.post(f"/api/bin/{run}/restore", headers=by).status_code == 204
    told = [(e["verb"], e["author"], e["details"]["run"]) for e in server.http.get("/api/audit").json()[:3]]
    assert told == [(verb, "Bo", run) for verb in ("take_back_run", "throw_away_run", "describe_run")]
