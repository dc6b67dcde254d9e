"""`make audit`: known weaknesses of what we depend on. Without a network it says what it could not ask.

    python -m tests.infra.audit [--strict]

Exit code 1 with any known weakness; with --strict (as nightly) also when somebody could not be asked.
"""

import json
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
LOCKS = ("requirements-dev.lock", "requirements-bench.lock")
PACKAGES = ("console_web", ".ci")


@dataclass
class Found:
    """What came of one lock file."""

    of: str
    asked: int = 0
    weak: list[str] = field(default_factory=list)
    unasked: str = ""  # why nobody, or not everything, could be asked

    def line(self) -> str:
        """For people."""
        told = f"{self.of}: {self.asked} packages asked about, {len(self.weak)} with known weaknesses"
        more = [f"  {one}" for one in self.weak]
        return "\n".join([told, *more, *([f"  NOT AUDITED: {self.unasked}"] if self.unasked else [])])


def read_pip(lock: str, text: str) -> Found:
    """pip-audit's JSON."""
    found = Found(lock)
    try:
        told: list[dict[str, Any]] = json.loads(text)["dependencies"]
    except (ValueError, KeyError, TypeError):
        found.unasked = "pip-audit gave no answer (no network?)"
        return found
    skipped = [one["name"] for one in told if "skip_reason" in one]
    found.asked = len(told) - len(skipped)
    found.weak = [
        f"{one['name']} {one['version']}: {flaw['id']}, mended in {', '.join(flaw['fix_versions']) or '-'}"
        for one in told
        for flaw in one.get("vulns", [])
    ]
    if skipped:
        found.unasked = f"{len(skipped)} of {len(told)} packages are not known to the service that was asked"
    return found


def read_npm(folder: str, text: str) -> Found:
    """npm audit's JSON."""
    found = Found(f"{folder}/package-lock.json")
    try:
        told = json.loads(text)
        found.asked = told["metadata"]["dependencies"]["total"]
        flaws = told["vulnerabilities"]
    except (ValueError, KeyError, TypeError):
        found.unasked = "the registry answers no questions (no network?)"
        return found
    found.weak = [f"{name}: {flaw['severity']}, {flaw['range']}" for name, flaw in flaws.items()]
    return found


def _run(*command: str) -> str:
    try:
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300).stdout
    except (OSError, subprocess.TimeoutExpired):
        return ""


def main() -> int:
    """Ask about every lock file."""
    program = str(Path(sys.executable).with_name("pip-audit"))
    options = ("--require-hashes", "--disable-pip", "--format", "json", "--progress-spinner", "off")
    found = [read_pip(lock, _run(program, *options, "-r", lock)) for lock in LOCKS]
    found += [
        read_npm(folder, _run(sys.executable, "hatch_build.py", "npm", folder, "audit", "--json"))
        for folder in PACKAGES
    ]
    print("\n".join(one.line() for one in found))
    strict = "--strict" in sys.argv
    return int(any(one.weak or (strict and one.unasked) for one in found))


if __name__ == "__main__":
    raise SystemExit(main())
