"""`python -m docs.generate [--check]`: write the generated pages, or fail when one is out of date."""

import sys
from pathlib import Path

from docs.generate import pages

DOCS = Path(__file__).resolve().parents[1]


def main(arguments: list[str]) -> int:
    """Exit code: 1 when --check finds a page that differs."""
    stale = []
    for name, text in pages.made(DOCS).items():
        path = DOCS / name
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
            if "--check" not in arguments:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
    verb = "is out of date: run `make gen`" if "--check" in arguments else "written"
    for name in stale:
        print(f"docs/{name} {verb}", file=sys.stderr)
    return int(bool(stale) and "--check" in arguments)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
