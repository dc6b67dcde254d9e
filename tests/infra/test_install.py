"""The wheel in an empty environment: what an on-board computer gets, and that it flies with it."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from packaging.utils import canonicalize_name

from bumpless.jit.decorator import cache_folder, compiled_sources

ROOT = Path(__file__).resolve().parents[2]
UV = Path(sys.executable).with_name("uv")
MISSION = """\
version: 1
name: short
vehicle: ts100
duration_s: 2
start: {position_ned_m: [0, 0, 5], heading_deg: 0, speed_mps: 0.5}
legs: [{to_ned_m: [9, 0, 5], speed_mps: 0.5}]
target: {position_ned_m: [9, 0, 5], heading_deg: 0, standoff_m: 1}
"""
# web, screens, logs, tables, plots, tests: nothing of them belongs on a vehicle
UNWANTED = {
    *("fastapi", "starlette", "uvicorn", "websockets", "viser", "pydantic-settings"),
    *("mcap", "zstandard", "lz4", "foxglove-schemas-protobuf", "pandas", "pyarrow"),
    *("matplotlib", "plotly", "pytest", "jsonschema", "httpx"),
}


@dataclass(frozen=True)
class Installed:
    """An environment that holds the wheel and what it asks for."""

    root: Path
    before: frozenset[str]  # top-level names of site-packages without it

    @property
    def site(self) -> Path:
        """Its site-packages."""
        (found,) = self.root.glob("lib/python*/site-packages")
        return found

    def run(self, *command: str, code: int = 0) -> subprocess.CompletedProcess[str]:
        """Run a program of the environment, in a folder that holds nothing, with compiled code at hand."""
        env = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
        env["BUMPLESS_CACHE_DIR"] = str(self.root / "cache")
        program = self.root / "bin" / command[0]
        done = subprocess.run(
            [program, *command[1:]], cwd=self.root, env=env, capture_output=True, text=True, check=False
        )
        assert done.returncode == code, done.stderr
        return done


def uv(*arguments: str | Path) -> str:
    """Run uv, which prefers what it has downloaded before; its output."""
    done = subprocess.run([UV, *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Installed]:
    """The wheel of this tree, installed with its base dependencies in the versions of the lock."""
    root = tmp_path_factory.mktemp("installed")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(root)]
    environment = os.environ | {"BUMPLESS_SKIP_CONSOLE": "1"}
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True, env=environment)
    (wheel,) = root.glob("*.whl")
    venv = root / "venv"
    uv("venv", "--quiet", "--python", sys.executable, venv)
    place = Installed(venv, frozenset())
    own = uv(
        "pip",
        "compile",
        "--quiet",
        "--no-header",
        "--no-annotate",
        "-c",
        "requirements.lock",
        "pyproject.toml",
    )
    (root / "own.txt").write_text(own)
    uv("pip", "install", "--quiet", "--python", venv, "-r", root / "own.txt")
    before = frozenset(path.name for path in place.site.iterdir())
    uv("pip", "install", "--quiet", "--python", venv, wheel)
    lend_compiled_code(place)
    yield Installed(venv, before)


def lend_compiled_code(place: Installed) -> None:
    """Numba keeps code by its source's folder; the same sources elsewhere would be compiled once more."""
    from numba.core.caching import _CacheLocator

    ours, theirs = ROOT / "twin" / "bumpless", place.site / "bumpless"
    cache = place.root / "cache" / "bumpless" / cache_folder().name
    cache.mkdir(parents=True)
    for folder in {path.parent for path in compiled_sources()}:
        source = theirs / folder.relative_to(ours) / "x.py"
        kept = cache_folder() / _CacheLocator.get_suitable_cache_subpath(str(folder / "x.py"))
        if kept.is_dir():
            (cache / _CacheLocator.get_suitable_cache_subpath(str(source))).symlink_to(kept)


def test_nothing_but_our_own_names_is_added(installed: Installed) -> None:
    """Protects: a package named `twin` or `server` in everyone's site-packages would hide other people's."""
    added = {path.name for path in installed.site.iterdir()} - installed.before
    assert added and all(name.startswith("bumpless") for name in added), added


def test_a_vehicle_needs_no_web_no_screen_and_no_log(installed: Installed) -> None:
    """Protects: what is installed on board is what flies; the rest is an extra."""
    listed = json.loads(uv("pip", "list", "--format", "json", "--python", installed.root))
    names = {canonicalize_name(package["name"]) for package in listed}
    assert {"bumpless", "numba", "eclipse-zenoh"} <= names
    assert not names & UNWANTED
    uv("pip", "check", "--python", installed.root)


def test_it_explains_itself_and_flies(installed: Installed) -> None:
    """Protects: `bumpless vehicle`, `bumpless run` and `bumpless.fly` work with the base installation."""
    assert "Usage" in installed.run("bumpless", "--help").stdout
    assert "--connect" in installed.run("bumpless", "vehicle", "--help").stdout
    (installed.root / "short.yaml").write_text(MISSION)
    said = json.loads(installed.run("bumpless", "run", "short.yaml", "--json").stdout)
    assert said["metrics"]["cycles"] == 40
    code = (
        "import sys, bumpless\n"
        "run = bumpless.fly('short.yaml', seed=3)\n"
        "print(run.outcome.ending, len(run.table()['time_s']), bumpless.__file__)\n"
    )
    ending, rows, place = installed.run("python", "-c", code).stdout.split()
    assert (ending, rows) == ("time_over", "40")
    assert Path(place).is_relative_to(installed.site)


@pytest.mark.parametrize(
    ("command", "extra"),
    [
        (("serve",), "console"),
        (("run", "short.yaml", "--out", "x.mcap"), "log"),
        (("metrics", "short.yaml"), "log"),
        (("repair", "short.yaml"), "log"),
        (("campaign", "short.yaml"), "campaign"),
        (("tune", "short.yaml"), "campaign"),
        (("reproduce", "--only", "table6"), "paper"),
    ],
)
def test_what_is_missing_is_one_sentence(installed: Installed, command: tuple[str, ...], extra: str) -> None:
    """Protects: whoever types a command that needs more is told what to install, not shown a traceback."""
    (installed.root / "short.yaml").write_text(MISSION)
    said = installed.run("bumpless", *command, code=1).stderr
    assert said.count("\n") == 1 and f"pip install 'bumpless[{extra}]'" in said


def test_the_library_says_what_is_missing(installed: Installed) -> None:
    """The same from Python: an ImportError that names the extra."""
    (installed.root / "short.yaml").write_text(MISSION)
    code = (
        "import bumpless\n"
        "run = bumpless.fly('short.yaml')\n"
        "for ask in (run.to_pandas, run.to_arrow, lambda: run.save('x'), lambda: bumpless.open_run('x')):\n"
        "    try:\n        ask()\n"
        "    except bumpless.ExtraMissing as error:\n        print(str(error).split('bumpless')[1])\n"
    )
    assert installed.run("python", "-c", code).stdout.split() == ["[data]'", "[data]'", "[log]'", "[log]'"]
