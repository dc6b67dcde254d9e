"""`python -m docs.count BASE`: the files that a change touched, as docs/architecture.md counts them.

Lists what differs between BASE (a commit) and the working tree. Hand-written files of the product count;
files made by a command, tests, docs and locks are listed beside them.
"""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MADE = ("_pb2.py", "_pb2.pyi", ".lock", ".schema.json")
BESIDE = ("tests/", "docs/", "README.md", "CHANGELOG.md", "results/", "console_web/src/gen/")


def touched(base: str) -> list[str]:
    """Paths that differ from `base`, new ones included."""
    commands = (["diff", "--name-only", "-M", base], ["ls-files", "--others", "--exclude-standard"])
    said = (
        subprocess.run(["git", *c], cwd=ROOT, check=True, capture_output=True, text=True) for c in commands
    )
    return sorted({line for done in said for line in done.stdout.splitlines()})


def counts(path: str) -> bool:
    """True for a hand-written file of the product."""
    return not path.startswith(BESIDE) and not path.endswith(MADE)


def main(arguments: list[str]) -> int:
    """Print the list and the count."""
    if len(arguments) != 1:
        print("usage: python -m docs.count BASE", file=sys.stderr)
        return 2
    paths = touched(arguments[0])
    for path in paths:
        print(("  " if counts(path) else "  beside: ") + path)
    print(f"{sum(map(counts, paths))} files count")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
