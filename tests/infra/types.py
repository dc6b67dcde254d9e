"""`python -m tests.infra.types [PLACE ...]`: pyright, strict where the code says its types.

Strict are the files of ROOMS that hold no compiled function. A compiled function takes what numba finds at
its call and has no annotations; its file is checked by the rules of pyproject.toml, as everything else is.
The rule is applied here and not by a list of files, so that a new file is strict by itself.

Without PLACE the product is checked (twin, server, paper, docs). The tests are another run: each takes time.
"""

import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("physics", "control", "config")
PRODUCT = ("twin", "server", "paper", "docs", "hatch_build.py", "release.py")
COMPILED = ("from bumpless.jit import", "import numba", "from numba")


def strict_files() -> list[str]:
    """Files of the strict rooms without compiled functions, as paths from the root."""
    paths = (path for room in ROOMS for path in sorted((ROOT / "twin/bumpless" / room).rglob("*.py")))
    return [
        path.relative_to(ROOT).as_posix()
        for path in paths
        if not any(word in path.read_text(encoding="utf-8") for word in COMPILED)
    ]


def config(places: list[str]) -> dict[str, object]:
    """pyproject.toml's settings of pyright with `places` included and the strict files named."""
    ours = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["pyright"]
    return {**ours, "include": places, "strict": strict_files()}


def main(places: list[str]) -> int:
    """pyright's exit code."""
    with tempfile.NamedTemporaryFile("w", suffix=".pyright.json", dir=ROOT, prefix=".") as file:
        json.dump(config(places or list(PRODUCT)), file)
        file.flush()
        return subprocess.run([sys.executable, "-m", "pyright", "-p", file.name], cwd=ROOT).returncode


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
