"""`python -m bumpless_paper.results_page [FILE]`: docs/results.md from the numbers behind it.

With a file its parts are taken over into results/reproduce.json first; a file of some parts alone, as
`bumpless reproduce --only` writes it, leaves the others as they are. `--check` writes nothing and fails
when the page differs from what results/reproduce.json gives.
"""

import json
import sys
from pathlib import Path

from bumpless_paper.report.results import renewed, small, with_results

ROOT = Path(__file__).parents[2]
PAGE, RESULTS = ROOT / "docs" / "results.md", ROOT / "results" / "reproduce.json"


def main(arguments: list[str]) -> int:
    """Exit code: 1 when --check finds a difference."""
    if arguments and arguments[0] != "--check":
        new = small(json.loads(Path(arguments[0]).read_text(encoding="utf-8")))
        document = renewed(json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}, new)
        RESULTS.parent.mkdir(exist_ok=True)
        RESULTS.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    document = json.loads(RESULTS.read_text(encoding="utf-8"))
    old = PAGE.read_text(encoding="utf-8")
    new = with_results(old, document)
    if "--check" in arguments:
        if old != new:
            print("docs/results.md differs from results/reproduce.json: run `make results`", file=sys.stderr)
        return int(old != new)
    PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
