"""What becomes of other people's mission files: `python -m tests.bench.imports FOLDER... [--all]`.

Each FOLDER is a folder of files or the git directory of a repository, in which every .plan, .nmis, .nmisz and
list of waypoints (WPL) is read, as `POST /api/missions/import` reads it, for ts100. Each is imported with a
word on each of its items, or refused with the reason; a crash, or a mission that cannot be read back, ends
the command with 1. Nothing of them is kept. --all prints each file.

Public files: mavlink/MAVSDK, mavlink/MAVSDK-Python, mavlink/mavros, dronekit/dronekit-python,
ArduPilot/MAVProxy, LSTS/neptus.
"""

import argparse
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from bumpless.config.mission import parse_mission
from bumpless_server.plan.exchange.read import imported
from bumpless_server.plan.exchange.route import NotImportable

ENDINGS = (".plan", ".nmis", ".nmisz", ".waypoints", ".txt")
WPL = b"QGC WPL"


def files(folder: Path) -> Iterator[tuple[str, bytes]]:
    """(name, bytes) of every mission file of a folder or of a repository's newest commit."""
    if (folder / "objects").is_dir():
        for name in _git(folder, "ls-tree", "-r", "-z", "--name-only", "HEAD").decode().split("\0"):
            if name.lower().endswith(ENDINGS):
                if data := _git(folder, "show", f"HEAD:{name}"):
                    yield name, data
        return
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and p.name.lower().endswith(ENDINGS)):
        yield str(path.relative_to(folder)), path.read_bytes()


def told(name: str, data: bytes) -> tuple[str, str]:
    """(imported, refused or crashed; a sentence on it)."""
    try:
        found = imported(data, Path(name).name, "ts100")
        mission = parse_mission(found.yaml)
    except NotImportable as error:
        return "refused", str(error)
    except Exception as error:  # what this command is there to find
        return "crashed", f"{type(error).__name__}: {error}"
    left = sum(not item.carried for item in found.items)
    legs = f"{len(mission.legs)} legs"
    return "imported", f"{found.kind}: {legs}; {len(found.items)} items, {left} of them not carried over"


def _git(folder: Path, *words: str) -> bytes:
    """What git says; nothing where a partial copy lacks the file."""
    return subprocess.run(["git", "-C", str(folder), *words], check=False, capture_output=True).stdout


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--all", action="store_true", help="print each file")
    options = parser.parse_args()
    counts: Counter[tuple[str, str]] = Counter()
    for folder in options.folders:
        for name, data in files(folder):
            kind = "WPL" if WPL in data[:64] else Path(name).suffix.lower()
            if kind == ".txt":
                continue
            became, sentence = told(name, data)
            counts[kind, became] += 1
            if options.all or became == "crashed":
                print(f"{became:9} {name}: {sentence}")
    print("| kind | files | imported | refused | crashed |\n| --- | --: | --: | --: | --: |")
    for kind in sorted({kind for kind, _ in counts}):
        row = [counts[kind, became] for became in ("imported", "refused", "crashed")]
        print(f"| {kind} | {sum(row)} | {' | '.join(map(str, row))} |")
    sys.exit(any(became == "crashed" for _, became in counts))


if __name__ == "__main__":
    main()
