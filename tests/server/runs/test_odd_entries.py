"""Each file stands alone: what is odd is named with its reason, and costs no other its place in a list."""

import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from mcap.writer import Writer

from bumpless_server.settings import Settings
from tests.server.runs.test_catalogue import write_run
from tests.server.serving import Running, serving


def odd_entries(folder: Path, ending: str) -> set[str]:
    """Everything but a file that can lie in a folder; their names."""
    (folder / f"folder{ending}").mkdir()
    (folder / f"loop{ending}").symlink_to(folder / f"loop{ending}")
    (folder / f"nothing{ending}").symlink_to(folder / "nowhere")
    os.mkfifo(folder / f"pipe{ending}")
    (folder / f"odd name; $(x){ending}").write_bytes(b"x")
    (folder / f"{'long' * 40}{ending}").write_bytes(b"x")
    with open(os.fsencode(folder) + b"/\xff\xfe" + ending.encode(), "wb") as file:
        file.write(b"x")
    return {
        f"{name}{ending}" for name in ("folder", "loop", "nothing", "pipe", "odd name; $(x)", "long" * 40)
    }


def forged(path: Path, metadata: dict[str, str], attachment: bytes) -> None:
    """A log that somebody else wrote, with our names in it."""
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start()
        writer.add_metadata("bumpless.run/x", metadata)
        writer.add_metadata("bumpless.end/x", {"messages": "9" * 40, "duration_s": "inf", "outcome": "won"})
        writer.add_attachment(0, 0, "metrics.json", "application/json", attachment)
        writer.finish()


@pytest.fixture
def served(tmp_path: Path) -> Iterator[tuple[Running, set[str]]]:
    """A server whose three folders hold good files among odd ones."""
    data = tmp_path / "data"
    for name in ("runs", "missions", "presets"):
        (data / name).mkdir(parents=True)
    odd = odd_entries(data / "runs", ".mcap")
    odd |= odd_entries(data / "missions", ".yaml") | odd_entries(data / "presets", ".json")
    write_run(data / "runs", "good", 5)
    for number, attachment in enumerate(
        (b"[1]", b"{" * 100_000, b'{"cycles": "many"}', b"\xff", b"[" * 99_999)
    ):
        times = {"started_ns": "9" * 30 if number else "-1", "seed": "9" * 30}
        forged(data / "runs" / f"forged{number}.mcap", times, attachment)
    settings = Settings(data_dir=data, zenoh_listen=(), manage_node=False, scene="off")
    with serving(settings) as running:
        text = running.http.get("/api/missions/docking").json()["yaml"]
        (data / "missions" / "good.yaml").write_text(text)
        (data / "missions" / "bad.yaml").write_bytes(b"\xff\x00{[")
        (data / "presets" / "good.json").write_text(json.dumps({"hover": {"lambda": 0.5}}))
        for number, junk in enumerate(
            (b"[" * 99_999, b"[]", b'{"hover": 3}', b"\xff", b'{"hover": {"lambda": "x"}}')
        ):
            (data / "presets" / f"junk{number}.json").write_bytes(junk)
            odd.add(f"junk{number}.json")
        assert running.console.keeper.indexed.wait(60)
        yield running, odd


def test_odd_entries_hide_no_good_ones_and_are_told(served: tuple[Running, set[str]]) -> None:
    """Protects: a folder, a link loop, a pipe, an odd name or time emptied a list or hung the start."""
    running, odd = served
    runs = {run["id"]: run for run in running.http.get("/api/runs").json()}
    assert runs.keys() == {"good", *(f"forged{number}" for number in range(5))}
    assert runs["good"]["metrics"]["cycles"] == 3
    assert all(run["metrics"] is None for name, run in runs.items() if name != "good")
    missions = {m["name"]: m for m in running.http.get("/api/missions").json() if not m["builtin"]}
    assert {name: m["valid"] for name, m in missions.items()} == {"good": True, "bad": False}
    assert [preset["name"] for preset in running.http.get("/api/presets").json()] == ["good"]
    told = running.http.get("/api/diagnostics").json()["left_out"]
    assert odd <= {one["name"] for one in told} and all(one["reason"] for one in told)
    assert running.console.tally.of("bad_file") > 0


def test_a_run_budget_counts_what_can_be_counted(served: tuple[Running, set[str]]) -> None:
    """Protects: a link to itself stopped recording for good."""
    running, _ = served
    assert running.console.recorder._budget._taken() > 0
    shutil.rmtree(running.console.data.runs / "folder.mcap")
