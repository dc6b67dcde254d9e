"""House rules that no linter knows: locks that agree with the metadata, small files, honest tests."""

import re
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from packaging.version import Version

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
DEPENDENCIES = PROJECT["project"]["dependencies"]
EXTRAS = PROJECT["project"]["optional-dependencies"]
GROUPS = PROJECT["dependency-groups"]


def extra(name: str) -> list[str]:
    """What an extra brings, those that it names included."""
    found: list[str] = []
    for text in EXTRAS[name]:
        wanted = Requirement(text)
        own = canonicalize_name(wanted.name) == "bumpless"
        found += [one for inner in wanted.extras for one in extra(inner)] if own else [text]
    return found


RUN = [*DEPENDENCIES, *extra("console"), *extra("paper")]
LOCKS = {
    "requirements.lock": RUN,
    "requirements-build.lock": GROUPS["build"],
    "requirements-dev.lock": [*DEPENDENCIES, *extra("all"), *GROUPS["build"], *GROUPS["dev"]],
    "requirements-bench.lock": [*RUN, *extra("bench")],
}
# the user fixed these as the project's core packages
CORE = {"fastapi", "uvicorn", "viser", "numpy", "osqp", "eclipse-zenoh", "mcap", "pytest"}
GENERATED = {"bumpless_pb2.py", "bumpless_pb2.pyi", "bumpless_pb.ts", "api.ts", "house.ts"}


def pins(lock: str) -> dict[str, set[Version]]:
    """Canonical name -> the versions a lock pins (several where Python versions differ)."""
    found: dict[str, set[Version]] = {}
    for name, version in re.findall(r"^([\w.\[\]-]+)==([^\s;]+)", (ROOT / lock).read_text(), re.MULTILINE):
        found.setdefault(canonicalize_name(name.split("[")[0]), set()).add(Version(version))
    return found


def sources() -> list[Path]:
    """Every hand-written source file of the rooms."""
    places = [(room, "*.py") for room in ("twin", "server", "paper", "tests")] + [
        ("console_web/src", "*.ts*")
    ]
    files = [path for folder, pattern in places for path in (ROOT / folder).rglob(pattern)]
    return [path for path in files if path.name not in GENERATED]


@pytest.mark.parametrize("lock", LOCKS)
def test_lock_pins_what_the_project_asks_for(lock: str) -> None:
    """A dependency added to pyproject.toml without `make lock` must not reach a fresh clone."""
    pinned = pins(lock)
    for text in LOCKS[lock]:
        wanted = Requirement(text)
        versions = pinned.get(canonicalize_name(wanted.name))
        assert versions, f"{lock} lacks {wanted.name}: run `make lock`"
        assert all(wanted.specifier.contains(version) for version in versions), f"{lock}: {text}"


def test_core_packages_are_asked_for() -> None:
    """Protects: the user's choice of packages; which extra brings one may change, that one does may not."""
    asked = {canonicalize_name(Requirement(text).name) for text in LOCKS["requirements-dev.lock"]}
    assert asked >= CORE


@pytest.mark.parametrize("lock", LOCKS)
def test_every_pin_has_a_hash_and_no_registry_is_named(lock: str) -> None:
    """Installation must be verifiable and must work behind any mirror."""
    text = (ROOT / lock).read_text()
    blocks = re.split(r"^(?=[\w.\[\]-]+==)", text, flags=re.MULTILINE)[1:]
    assert blocks
    assert all("--hash=sha256:" in block for block in blocks)
    assert "://" not in text


@pytest.mark.parametrize("lock", list(LOCKS)[1:])
def test_locks_agree_on_shared_packages(lock: str) -> None:
    """Tests and benches must exercise the versions that users run."""
    run, other = pins("requirements.lock"), pins(lock)
    different = {name for name in run.keys() & other.keys() if run[name] != other[name]}
    assert not different


def test_rooms_are_small() -> None:
    """A file over 400 lines holds more than one idea."""
    long = {str(path.relative_to(ROOT)): n for path in sources() if (n := lines(path)) > 400}
    assert not long


def test_nothing_is_left_for_later() -> None:
    """A skipped test and a promised line of code look like work that was done."""
    words = (
        "TO" + "DO",
        "FIX" + "ME",
        "mark." + "skip",
        "mark." + "xfail",
        "pytest." + "skip",
        "assert " + "True",
    )
    found = [f"{path.relative_to(ROOT)}: {w}" for path in sources() for w in words if w in path.read_text()]
    assert not found


def lines(path: Path) -> int:
    """Number of lines in a file."""
    return len(path.read_text().splitlines())
