"""The index of runs is only an index: whatever happens to it, the files bring it back."""

import math
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Ending, Outcome
from bumpless.runs.records import is_whole
from bumpless.runs.summary import summarise
from bumpless.runs.writer import RunWriter
from bumpless_server.runs.catalogue import Catalogue

WRITER = """
import os, signal, sys
from pathlib import Path
from bumpless.runs.writer import RunWriter
from bumpless.contract import bumpless_pb2 as pb
status = pb.MissionStatus(stamp=pb.Stamp(time_ns=5), run_id="cut", mission_name="docking")
log = RunWriter(Path(sys.argv[1]), status)
for cycle in range(100):
    payload = pb.Navigation(stamp=pb.Stamp(cycle=cycle)).SerializeToString()
    log.write("tlm/navigation", "bumpless.Navigation", payload, cycle * 10**9)
log.flush()
log.write("tlm/navigation", "bumpless.Navigation", payload, 10**12)
os.kill(os.getpid(), signal.SIGKILL)
"""


def write_run(folder: Path, name: str, started_ns: int, state: str = "complete") -> Path:
    path = folder / f"{name}.mcap"
    stamp = pb.Stamp(time_ns=started_ns + 1_500_000_000)
    status = pb.MissionStatus(stamp=stamp, run_id=name, mission_name="docking", elapsed_s=1.5)
    log = RunWriter(path, status)
    log.write("tlm/health", "bumpless.Health", pb.Health(cycles=1).SerializeToString(), 1)
    ended = Outcome(Ending.HELD, "in hover.", "held", "true", "H")
    log.finish(state, "done", figures=(pb.Metrics(cycles=3), ended))
    return path


@pytest.fixture
def catalogue(tmp_path: Path):
    runs = tmp_path / "runs"
    runs.mkdir()
    catalogue = Catalogue(runs, tmp_path / "index.sqlite")
    catalogue.open()
    yield catalogue
    catalogue.close()


@pytest.mark.parametrize("at", range(8, 400, 7))
def test_a_damaged_file_hides_no_other(tmp_path: Path, at: int) -> None:
    """Bytes gone wrong anywhere in one file: it is listed with what can be told, in plain numbers."""
    path = write_run(tmp_path, "damaged", 1)
    content = bytearray(path.read_bytes())
    content[-at] ^= 0xFF
    path.write_bytes(content)
    summary = summarise(path)
    assert summary.id == "damaged" and math.isfinite(summary.duration_s)


def test_it_is_rebuilt_from_the_files(catalogue: Catalogue, tmp_path: Path) -> None:
    """Lose the index: the same list comes back, metrics included."""
    for number in range(3):
        write_run(tmp_path / "runs", f"run-{number}", number)
    catalogue.refresh()
    before = catalogue.rows()
    assert [row.summary.id for row in before] == ["run-2", "run-1", "run-0"]
    assert before[0].summary.metrics is not None and before[0].summary.metrics["cycles"] == 3
    assert before[0].summary.duration_s == 1.5
    catalogue.close()
    (tmp_path / "index.sqlite").unlink()
    catalogue.open()
    assert catalogue.rows() == []
    catalogue.refresh()
    assert catalogue.rows() == before


@pytest.mark.parametrize("damage", [b"this is no database", b"", b"SQLite format 3\0" + b"\xff" * 4096])
def test_a_damaged_index_is_replaced(catalogue: Catalogue, tmp_path: Path, damage: bytes) -> None:
    """A power cut in the index costs nothing."""
    write_run(tmp_path / "runs", "run-1", 1)
    catalogue.refresh()
    catalogue.close()
    (tmp_path / "index.sqlite").write_bytes(damage)
    catalogue.open()
    catalogue.refresh()
    assert [row.summary.id for row in catalogue.rows()] == ["run-1"]


def test_files_added_changed_and_removed_by_hand_are_noticed(catalogue: Catalogue, tmp_path: Path) -> None:
    """People copy and delete files; the list follows."""
    runs = tmp_path / "runs"
    kept = write_run(runs, "kept", 1)
    write_run(runs, "gone", 2)
    catalogue.refresh()
    (runs / "gone.mcap").unlink()
    shutil.copy(kept, runs / "copy.mcap")
    write_run(runs, "kept", 7, "interrupted")
    os.utime(kept, ns=(1, 1))
    catalogue.refresh()
    rows = {row.summary.id: row.summary for row in catalogue.rows()}
    assert set(rows) == {"kept", "copy"}
    assert (rows["kept"].started_ns, rows["kept"].state) == (7, "interrupted")
    assert rows["copy"].run_id == "kept"


def test_a_file_cut_off_by_a_kill_is_repaired_and_listed_as_interrupted(
    catalogue: Catalogue, tmp_path: Path
) -> None:
    """All that was flushed before kill -9 comes back."""
    path = tmp_path / "runs" / "cut.mcap"
    killed = subprocess.run([sys.executable, "-c", WRITER, str(path)], check=False)
    assert killed.returncode == -signal.SIGKILL and not is_whole(path)
    assert catalogue.refresh() == [path]
    assert is_whole(path)
    row = catalogue.row("cut")
    assert row is not None
    assert (row.summary.state, row.summary.run_id, row.summary.started_ns) == ("interrupted", "cut", 5)
    assert row.summary.end_reason == "the recording was cut off"
    assert row.summary.messages >= 100
    assert catalogue.refresh() == []


def test_the_file_being_written_is_left_alone(catalogue: Catalogue, tmp_path: Path) -> None:
    """Repairing what the recorder is writing would destroy it."""
    path = tmp_path / "runs" / "now.mcap"
    log = RunWriter(path, pb.MissionStatus(run_id="now"))
    assert catalogue.refresh(busy=lambda: path) == []
    assert catalogue.row("now") is None
    log.abandon()


def test_what_is_no_log_is_listed_and_kept(catalogue: Catalogue, tmp_path: Path) -> None:
    """Nobody's file is thrown away because it cannot be read."""
    (tmp_path / "runs" / "odd.mcap").write_bytes(b"not a log at all")
    (tmp_path / "runs" / "empty.mcap").write_bytes(b"")
    catalogue.refresh()
    assert {row.summary.id: row.summary.state for row in catalogue.rows()} == {
        "odd": "interrupted",
        "empty": "interrupted",
    }
    assert (tmp_path / "runs" / "odd.mcap").read_bytes() == b"not a log at all"
