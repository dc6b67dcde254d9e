"""The cache of compiled code does not grow for ever, and nobody loses what they are using."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from bumpless.jit import cache as compile_cache
from bumpless.jit.cache import IDLE_S, KEEP, claim, prune

ROOT = Path(__file__).parents[2]
NOW_S = 1_800_000_000.0
DAY_S = 86_400.0


def folder(base: Path, number: int, days_ago: float) -> Path:
    """A cache folder that a process which has ended used so long ago."""
    path = base / f"numba-{number:016x}"
    (path / "twin_1").mkdir(parents=True)
    (path / "twin_1" / "cycle.nbi").write_text("compiled")
    (path / "in-use").touch()
    use(path, days_ago)
    return path


def use(path: Path, days_ago: float) -> None:
    at_s = NOW_S - days_ago * DAY_S
    os.utime(path / "in-use", (at_s, at_s))


def names(paths: list[Path]) -> list[int]:
    return sorted(int(path.name[6:], 16) for path in paths)


def test_the_last_used_the_current_and_those_in_use_stay(tmp_path: Path) -> None:
    """Protects: a folder for every edit of the sources filled the home; a running process keeps its own."""
    folders = [folder(tmp_path, number, days_ago=2.0 + number) for number in range(20)]
    current, busy = folders[19], folders[15]
    (tmp_path / "numba-mine").mkdir()
    running = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(busy)],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    with running:
        assert running.stdout is not None and running.stdin is not None
        assert running.stdout.readline() == "holding\n"
        use(busy, days_ago=17.0)
        gone = prune(current, NOW_S)
        assert names(gone) == [k for k in range(KEEP - 1, 20) if k not in (15, 19)]
        assert names(list(tmp_path.glob("numba-0*"))) == [*range(KEEP - 1), 15, 19]
        assert (busy / "twin_1" / "cycle.nbi").exists() and (tmp_path / "numba-mine").exists()
        running.stdin.close()
    assert prune(current, NOW_S) == [busy]


HOLD = """
import sys
from pathlib import Path
from bumpless.jit.cache import claim
claim(Path(sys.argv[1]))
print("holding", flush=True)
sys.stdin.read()
"""


def test_what_was_used_within_a_day_stays(tmp_path: Path) -> None:
    """Protects: work on several states of the sources at once must not throw each other's code away."""
    for number in range(3 * KEEP):
        folder(tmp_path, number, days_ago=0.5 * IDLE_S / DAY_S)
    assert prune(tmp_path / "numba-0000000000000000", NOW_S) == []


def test_a_new_state_of_the_sources_makes_room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Only a folder that is new looks at the others; one that cannot be made is no reason not to fly."""
    seen: list[Path] = []
    monkeypatch.setattr(compile_cache, "prune", seen.append)
    fresh = tmp_path / "numba-00000000000000ff"
    assert claim(fresh) == fresh and claim(fresh) == fresh
    assert seen == [fresh]
    (tmp_path / "file").touch()
    assert claim(tmp_path / "file" / "numba-00000000000000ff").name == "numba-00000000000000ff"


def test_without_a_writable_home_compiled_code_is_kept_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a service without a home directory failed to start, or compiled anew at each start."""
    monkeypatch.setattr(compile_cache.tempfile, "gettempdir", lambda: str(tmp_path))
    monkeypatch.setattr(compile_cache.tempfile, "tempdir", str(tmp_path))
    (tmp_path / "file").touch()
    found = compile_cache.usable(tmp_path / "file" / "numba-0")
    assert found == compile_cache.usable(tmp_path / "file" / "numba-0")
    assert found.parent.parent == tmp_path and found.parent.stat().st_mode & 0o777 == 0o700
    found.parent.chmod(0o777)  # anybody could have put code there
    assert compile_cache.usable(tmp_path / "file" / "numba-0").parent != found.parent
    assert compile_cache.usable(tmp_path / "mine") == tmp_path / "mine"
