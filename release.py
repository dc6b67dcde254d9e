"""`make release VERSION=x.y.z`: one commit, one tag, one wheel and one source package.

In this order: the tree must be clean and the version new; `make check` must pass; version and changelog are
written and committed; wheel and source package are built into dist/; the commit is tagged. What fails before
the commit leaves nothing behind; a build that fails takes the commit back. Nothing is pushed: that is left to
a person.
"""

import datetime
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent
CHECKS = ("make", "check")
PROJECT, CHANGELOG = ROOT / "pyproject.toml", ROOT / "CHANGELOG.md"
VERSION = re.compile(r'^version = "([^"]+)"$', re.MULTILINE)
NUMBER = re.compile(r"(\d+)\.(\d+)\.(\d+)")
UNRELEASED = "## Unreleased\n"


class Refusal(Exception):
    """Why there is no release."""


def git(*arguments: str) -> str:
    """What git says."""
    done = subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True)
    return done.stdout.strip()


def parts(version: str) -> tuple[int, ...]:
    """The three numbers of x.y.z."""
    found = NUMBER.fullmatch(version)
    if found is None:
        raise Refusal(f"VERSION={version!r}: must be x.y.z, three whole numbers")
    return tuple(int(one) for one in found.groups())


def present() -> str:
    """The version that pyproject.toml says."""
    found = VERSION.search(PROJECT.read_text(encoding="utf-8"))
    if found is None:
        raise Refusal("pyproject.toml has no version")
    return found[1]


def check(version: str) -> None:
    """Refuse what cannot be released."""
    tags = git("tag", "--list").split()
    released = f"v{present()}" in tags
    if parts(version) < parts(present()) or (released and version == present()):
        raise Refusal(f"VERSION={version}: must be newer than {present()}")
    if f"v{version}" in tags:
        raise Refusal(f"the tag v{version} exists already")
    if dirty := git("status", "--porcelain"):
        raise Refusal(f"the tree is not clean:\n{dirty}")
    if not notes():
        raise Refusal("CHANGELOG.md says nothing under Unreleased")


def notes() -> str:
    """What the changelog says under Unreleased."""
    _, found, rest = CHANGELOG.read_text(encoding="utf-8").partition(UNRELEASED)
    return rest.split("\n## ")[0].strip() if found else ""


def write(version: str, day: datetime.date) -> None:
    """The new version and its chapter in the changelog."""
    project = PROJECT.read_text(encoding="utf-8")
    PROJECT.write_text(VERSION.sub(f'version = "{version}"', project, count=1), encoding="utf-8")
    head = f"{UNRELEASED}\n## {version} ({day.isoformat()})\n"
    CHANGELOG.write_text(CHANGELOG.read_text(encoding="utf-8").replace(UNRELEASED, head, 1), encoding="utf-8")


def build() -> list[Path]:
    """Wheel and source package in dist/."""
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-t", "sdist"]
    subprocess.run(command, cwd=ROOT, check=True)
    return sorted((ROOT / "dist").glob(f"bumpless-{present()}*"))


def main(arguments: list[str]) -> int:
    """Exit code: 1 when there is no release."""
    try:
        (version,) = arguments
        check(version)
        subprocess.run(CHECKS, cwd=ROOT, check=True)
        begun = git("rev-parse", "HEAD")
        write(version, datetime.date.today())
        git("commit", "--quiet", "--all", "--message", f"Release {version}")
        try:
            made = build()
        except subprocess.CalledProcessError:
            git("reset", "--hard", "--quiet", begun)
            raise
        git("tag", "--annotate", f"v{version}", "--message", f"Bumpless {version}")
    except ValueError:
        print("usage: make release VERSION=x.y.z", file=sys.stderr)
        return 1
    except (Refusal, subprocess.CalledProcessError) as error:
        print(f"no release: {error}", file=sys.stderr)
        return 1
    print(f"Released {version}:", *(f"  {path.relative_to(ROOT)}" for path in made), sep="\n")
    print(f"To publish: git push origin HEAD v{version}, then upload the files above.")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
