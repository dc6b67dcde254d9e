"""Room for runs: what is refused, what is deleted for it, and what never is."""

import random
from pathlib import Path

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.runs.writer import RunWriter
from bumpless_server.console import Console
from bumpless_server.runs.disk_budget import DiskBudget
from bumpless_server.settings import Settings, SettingsError, load_settings


def kept(folder: Path) -> list[str]:
    return sorted(path.stem for path in folder.glob("*.mcap"))


def record(folder: Path, run: str, state: str) -> None:
    """A run's file of about 10 kB."""
    status = pb.MissionStatus(stamp=pb.Stamp(time_ns=10**18 + int(run[-1])), run_id=run)
    writer = RunWriter(folder / f"{run}.mcap", status)
    writer.write("tlm/ballast", "bumpless.Ballast", random.Random(run).randbytes(9_000), 1)
    writer.finish(state, "")


@pytest.fixture
def console(tmp_path: Path) -> Console:
    """A console's disk with four runs, whose budget has just been used up."""
    console = Console(
        Settings(data_dir=tmp_path, scene="off", runs_max_bytes=40_000, runs_prune=True, disk_free_bytes=0)
    )
    console.data.open()
    console.catalogue.open()
    for run, state in (("1", "interrupted"), ("2", "complete"), ("3", "complete"), ("4", "interrupted")):
        record(console.data.runs, f"run{run}", state)
    console.catalogue.refresh()
    return console


def test_by_default_no_run_is_ever_deleted(console: Console) -> None:
    """Protects: a log that somebody needs; without leave to delete the budget says no and touches nothing."""
    budget = DiskBudget(console.data.runs, max_bytes=40_000)
    assert budget.lack() == "runs take 0.0 MB of the 0.0 MB they may"
    assert DiskBudget(console.data.runs).lack() == ""
    assert len(kept(console.data.runs)) == 4


def test_where_asked_to_the_oldest_complete_run_goes(console: Console) -> None:
    """Protects: one run goes for one run's room, interrupted ones (an accident's only trace) stay."""
    budget = console.recorder._budget
    assert budget.lack() == "" and kept(console.data.runs) == ["run1", "run3", "run4"]
    record(console.data.runs, "run5", "interrupted")
    assert budget.lack() == "" and kept(console.data.runs) == ["run1", "run4", "run5"]
    record(console.data.runs, "run6", "interrupted")
    assert budget.lack() != "" and kept(console.data.runs) == ["run1", "run4", "run5", "run6"]


def test_a_disk_that_others_fill_costs_no_run(console: Console) -> None:
    """Protects: deleting runs does not help against what else fills the disk."""
    budget = DiskBudget(console.data.runs, 10**9, min_free_bytes=2**62, prune=console._prune)
    assert "are free on the disk, fewer than" in budget.lack()
    assert len(kept(console.data.runs)) == 4


def test_leave_to_delete_needs_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """A setting that would do nothing is a fault, not a surprise on a full disk."""
    monkeypatch.setenv("BUMPLESS_RUNS_PRUNE", "true")
    with pytest.raises(SettingsError, match=r"BUMPLESS_RUNS_PRUNE.*needs runs_max_bytes"):
        load_settings()
    monkeypatch.setenv("BUMPLESS_RUNS_MAX_BYTES", "20000000000")
    assert load_settings().runs_prune
