"""`bumpless campaign`, `tune` and `run --draw` as commands, killed and resumed."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from bumpless.campaign.flight import FlyNumbers
from bumpless.campaign.read import load_campaign
from bumpless.campaign.store import opened

TEXT = """version: 1
name: small
missions: [docking]
count: {count}
seed: 3
draw:
  current_speed_mps: {{uniform: [0, 0.1]}}
  current_relative_deg: {{uniform: [0, 360]}}
  lag: {{loguniform: [0.5, 2]}}
"""
FLIGHTS = 200  # so many that a kill finds some of them undone
BUMPLESS = (sys.executable, "-m", "bumpless_server.cli.main")


def command(*words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run `bumpless` to its end."""
    return subprocess.run([*BUMPLESS, *words], cwd=folder, capture_output=True, text=True, timeout=300)


@pytest.fixture
def folder(tmp_path):
    """A folder with a campaign of FLIGHTS."""
    (tmp_path / "small.yaml").write_text(TEXT.format(count=FLIGHTS))
    return tmp_path


def parts(folder: Path) -> int:
    """Stored parts."""
    return len(list((folder / "campaign-small" / "flights").glob("*.parquet")))


def begun(folder: Path) -> subprocess.Popen:
    """A campaign that has stored something and is not at its end."""
    words = [*BUMPLESS, "campaign", "small.yaml", "--workers", "2"]
    flying = subprocess.Popen(words, cwd=folder, stderr=subprocess.PIPE, text=True, start_new_session=True)
    while parts(folder) < 2:
        assert flying.poll() is None, "ended before it was stopped"
        time.sleep(0.02)
    return flying


@pytest.mark.parametrize("signal_", [signal.SIGKILL, signal.SIGINT])
def test_killed_and_resumed(folder, signal_):
    """Protects: kill -9 or Ctrl-C: no worker is left, --resume ends it, each flight counts once."""
    flying = begun(folder)
    workers = psutil.Process(flying.pid).children(recursive=True)
    if signal_ == signal.SIGINT:
        os.killpg(flying.pid, signal_)  # as a terminal does
    else:
        flying.kill()
    _, said = flying.communicate(timeout=120)
    assert flying.returncode == (130 if signal_ == signal.SIGINT else -signal.SIGKILL)
    assert "Traceback" not in said
    _, left = psutil.wait_procs(workers, timeout=60)
    assert not left
    stored = parts(folder)
    again = command("campaign", "small.yaml", "--workers", "2", folder=folder)
    assert (again.returncode, "--resume" in again.stderr) == (1, True)
    done = command("campaign", "small.yaml", "--workers", "1", "--resume", "--json", folder=folder)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["flights"] == FLIGHTS
    assert parts(folder) > stored
    prepared = load_campaign(folder / "small.yaml")
    with opened(folder / "campaign-small", prepared, True) as kept:
        table = kept.table()
    assert table.column("number").to_pylist() == list(range(FLIGHTS))
    chosen = [0, 37, FLIGHTS - 1]
    assert repr(table.take(chosen).to_pylist()) == repr(FlyNumbers(prepared)(chosen))


def test_a_flight_is_flown_again_by_its_number(tmp_path):
    """Protects: the command on the page flies the very flight: same mission, seed and plant, to the bit."""
    (tmp_path / "small.yaml").write_text(TEXT.format(count=5))
    prepared = load_campaign(tmp_path / "small.yaml")
    row = FlyNumbers(prepared)([3])[0]
    done = command("run", "small.yaml", "--draw", "3", "--out", "f.mcap", "--json", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    said = json.loads(done.stdout)
    assert said["seed"] == row["seed"]
    assert (tmp_path / "f.mcap").stat().st_size > 0
    assert said["outcome"]["ending"] == row["outcome"]
    assert said["outcome"]["reason"] == row["reason"]
    assert said["metrics"]["shaft_energy_j"] == row["energy_j"]


def test_refusals_are_lines(tmp_path):
    """Protects: a bad campaign, no search and no scheduler end with code and words."""
    (tmp_path / "small.yaml").write_text(TEXT.format(count=5).replace("[docking]", "[dock]"))
    bad = command("campaign", "small.yaml", folder=tmp_path)
    assert (bad.returncode, bad.stderr.startswith("small.yaml:3:12: missions[0] = dock;")) == (1, True)
    (tmp_path / "small.yaml").write_text(TEXT.format(count=5))
    none = command("tune", "small.yaml", folder=tmp_path)
    assert (none.returncode, "tune; is missing" in none.stderr) == (1, True)
    away = command("campaign", "small.yaml", "--dask", "tcp://127.0.0.1:1", folder=tmp_path)
    assert (away.returncode, "no Dask scheduler answers" in away.stderr) == (3, True)
    assert "Traceback" not in bad.stderr + none.stderr + away.stderr


def test_tune_writes_what_it_found(tmp_path):
    """Protects: trials and held-out flights are flown; patch, numbers and study are left."""
    search = "tune: {trials: 2, held_out: 2, search: {hover.lambda: {low: 0.001, high: 0.1, log: true}}}\n"
    (tmp_path / "small.yaml").write_text(TEXT.format(count=4) + search)
    done = command("tune", "small.yaml", "--workers", "1", "--json", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    said = json.loads(done.stdout)
    assert (said["tuning"], said["held_out"], said["looks"]) == ([0, 3], [4, 5], 1)
    assert {p.name for p in (tmp_path / "tune-small").iterdir()} >= {
        "parameters.toml",
        "tune.json",
        "study.journal",
    }
