"""What is installed must be complete: data files, missions and the built console inside the wheel."""

import fcntl
import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

import hatch_build

ROOT = Path(__file__).resolve().parents[2]
VEHICLES = ROOT / "twin" / "bumpless" / "config" / "vehicles"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Iterator[zipfile.ZipFile]:
    """The wheel as hatchling builds it from this tree."""
    out = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(out)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    (path,) = out.glob("*.whl")
    with zipfile.ZipFile(path) as archive:
        yield archive


def test_wheel_carries_data_missions_console_and_help(wheel: zipfile.ZipFile) -> None:
    """A user of the wheel has neither Node nor this repository."""
    names = set(wheel.namelist())
    wanted = {f"bumpless/config/vehicles/{path.name}" for path in VEHICLES.glob("*.toml")}
    wanted |= {f"bumpless/missions/{path.name}" for path in (ROOT / "missions").glob("*.yaml")}
    wanted |= {
        "bumpless/contract/bumpless.proto",
        "bumpless/contract/bumpless_pb2.py",
        "bumpless_server/static/index.html",
        "bumpless_server/help/index.html",
        "bumpless_server/help/policy.txt",
    }
    assert len(wanted) > 4
    assert wanted <= names


def test_wheel_carries_the_page_compressed(wheel: zipfile.ZipFile) -> None:
    """Protects thin links: the server compresses nothing itself, it sends what the build has put there."""
    names = set(wheel.namelist())
    scripts = {name for name in names if name.startswith("bumpless_server/static/assets/index-")}
    whole = {name for name in scripts if name.endswith((".js", ".css"))}
    assert len(whole) == 2
    assert scripts == {name + ending for name in whole for ending in ("", ".br", ".gz")}


def test_wheel_carries_nothing_else(wheel: zipfile.ZipFile) -> None:
    """Tests, Node modules, recorded data and caches stay at home."""
    tops = {name.split("/")[0] for name in wheel.namelist()}
    assert {top for top in tops if not top.endswith(".dist-info")} == {
        "bumpless",
        "bumpless_server",
        "bumpless_paper",
    }
    assert not [name for name in wheel.namelist() if "node_modules" in name or "__pycache__" in name]


@pytest.fixture
def console(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A tree with console sources and a built console that belongs to them; npm must not run."""
    monkeypatch.delenv("BUMPLESS_SKIP_CONSOLE", raising=False)
    folder = tmp_path / "console_web"
    (folder / "src").mkdir(parents=True)
    (folder / "package.json").write_text("{}")
    (folder / "src" / "main.ts").write_text("let x = 1;")
    static = tmp_path / "server" / "bumpless_server" / "static"
    static.mkdir(parents=True)
    (static / hatch_build.STAMP).write_text(hatch_build.source_hash(folder))
    return folder


class NpmWasCalled(Exception):
    """Raised instead of running npm."""


def test_console_is_built_only_when_its_sources_changed(
    console: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second `make run` must take seconds, and a changed source must never be served stale."""

    def npm(folder: Path, *arguments: str) -> None:
        raise NpmWasCalled

    monkeypatch.setattr(hatch_build, "install_modules", npm)
    assert hatch_build.build_console(console.parent) is False
    (console / "node_modules").mkdir()
    (console / "node_modules" / "x.js").write_text("installed")
    assert hatch_build.build_console(console.parent) is False
    (console / "src" / "main.ts").write_text("let x = 2;")
    with pytest.raises(NpmWasCalled):
        hatch_build.build_console(console.parent)


def test_npm_packages_are_installed_by_one_process_at_a_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`make check` runs its checks side by side; two `npm ci` in one folder delete each other's files."""
    lock = tmp_path / "package-lock.json"
    lock.write_text("{}")
    installed = []

    def npm(folder: Path, *arguments: str) -> None:
        with lock.open() as another, pytest.raises(BlockingIOError):
            fcntl.flock(another, fcntl.LOCK_EX | fcntl.LOCK_NB)
        (folder / "node_modules").mkdir()
        installed.append(folder)

    monkeypatch.setattr(hatch_build, "run_npm", npm)
    hatch_build.install_modules(tmp_path)
    hatch_build.install_modules(tmp_path)  # whoever waited finds all in place
    assert installed == [tmp_path]
    with lock.open() as another:
        fcntl.flock(another, fcntl.LOCK_EX | fcntl.LOCK_NB)


def test_a_source_package_with_the_built_console_needs_no_sources(console: Path) -> None:
    """Without console_web the built files are taken as they are; without both, the build says so."""
    shutil.rmtree(console)
    assert hatch_build.build_console(console.parent) is False
    shutil.rmtree(console.parent / "server" / "bumpless_server" / "static")
    with pytest.raises(FileNotFoundError, match="no console sources"):
        hatch_build.build_console(console.parent)


def test_help_loads_no_heavy_module() -> None:
    """`bumpless --help` must answer at once: numba, SciPy, viser and Zenoh are loaded when needed."""
    heavy = ["numba", "scipy", "viser", "zenoh", "osqp", "fastapi", "mcap"]
    loaded = f"', '.join(m for m in {heavy} if m in sys.modules)"
    code = f"import sys, bumpless_server.cli.main; sys.exit({loaded} or 0)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=os.environ)
    assert done.returncode == 0, done.stderr
