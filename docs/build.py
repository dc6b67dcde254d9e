"""Builds the site into server/bumpless_server/help/, where the server finds it and a wheel carries it.

    python docs/build.py            build if a page or a file that a page shows has changed
    python docs/build.py --check    build into a temporary folder; fail on any warning

Nothing is loaded from the network, now or when the pages are read. The one inline script of the theme is
named by its hash in `policy.txt`, so that the server can allow it and no other.
"""

import base64
import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DOCS, HELP = ROOT / "docs", ROOT / "server" / "bumpless_server" / "help"
STAMP, POLICY, CODE = ".sources.json", "policy.txt", "code"
SCRIPT = re.compile(rb"<script>(.*?)</script>", re.DOTALL)


def fingerprint(shown: list[str]) -> dict[str, str]:
    """Path -> SHA-256 of every file of docs/ and of the files that its pages show."""
    paths = {path.relative_to(ROOT).as_posix() for path in DOCS.rglob("*") if path.is_file()}
    wanted = sorted({path for path in paths if "__pycache__" not in path} | set(shown))
    return {p: hashlib.sha256((ROOT / p).read_bytes()).hexdigest() for p in wanted if (ROOT / p).is_file()}


def shown_files(site: Path) -> list[str]:
    """The repository's files that a built site shows."""
    code = site / CODE
    return sorted(path.relative_to(code).as_posix().removesuffix(".html") for path in code.rglob("*.html"))


def policy(site: Path) -> str:
    """The content security policy of a built site: its own files, and its inline scripts by their hash."""
    scripts = {script for page in site.rglob("*.html") for script in SCRIPT.findall(page.read_bytes())}
    hashes = sorted(base64.b64encode(hashlib.sha256(script).digest()).decode() for script in scripts)
    allowed = " ".join(["'self'", *(f"'sha256-{one}'" for one in hashes)])
    return (
        f"default-src 'self'; script-src {allowed}; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
        "frame-ancestors 'self'; base-uri 'none'; form-action 'self'"
    )


def make(site: Path) -> None:
    """Build into `site`; a warning, such as a dead link, fails the build."""
    with tempfile.TemporaryDirectory() as work:
        options = ["-q", "-W", "--keep-going", "-b", "html", "-d", work]
        subprocess.run([sys.executable, "-m", "sphinx", *options, str(DOCS), str(site)], check=True)
    for rest in (site / ".buildinfo", site / "objects.inv", *site.rglob("*.map")):
        rest.unlink(missing_ok=True)
    (site / POLICY).write_text(policy(site), encoding="utf-8")


def build(help_folder: Path = HELP) -> bool:
    """Bring the built site up to date; True when it was built anew."""
    stamp = help_folder / STAMP
    if stamp.is_file() and json.loads(stamp.read_text()) == fingerprint(shown_files(help_folder)):
        return False
    print("Building the docs ...", flush=True)
    fresh = help_folder.with_name("help.new")
    shutil.rmtree(fresh, ignore_errors=True)
    make(fresh)
    (fresh / STAMP).write_text(json.dumps(fingerprint(shown_files(fresh))))
    shutil.rmtree(help_folder, ignore_errors=True)
    fresh.rename(help_folder)
    return True


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        with tempfile.TemporaryDirectory() as folder:
            make(Path(folder))
    else:
        build()
