"""What is promised of faults and attacks, tried at full size: `python -m tests.trust [trial ...]`.

    python -m tests.trust                    # all of them, about half an hour on two idle cores
    python -m tests.trust files --share 0.1  # one, with a tenth of its size
    python -m tests.trust --commit           # also write the figures and docs/trust_figures.md

Exit code 1 when a promise is not kept.
"""

import argparse
import json
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from tests.trust import bus, chaos, files, link, node, page, recorder
from tests.trust.figure import Figure

FIGURES = Path(__file__).with_name("figures.json")

TRIALS: dict[str, Callable[[float], Iterator[Figure]]] = {
    "recorder": lambda share: recorder.figures(_of(100, share)),
    "node": lambda share: node.figures(_of(10, share)),
    "link": lambda share: link.figures((1.0, 5.0, 30.0) if share >= 1.0 else (1.0,)),
    "chaos": lambda share: chaos.figures(),
    "bus": lambda share: bus.figures(_of(100_000, share)),
    "files": lambda share: files.figures(_of(5_000, share)),
}


def _of(count: int, share: float) -> int:
    return max(1, round(count * share))


def _keep(name: str, found: list[Figure]) -> None:
    known = json.loads(FIGURES.read_text()) if FIGURES.exists() else {}
    load = round(os.getloadavg()[0], 1)
    known[name] = {"load": load, "figures": [figure.record() for figure in found]}
    known = {trial: known[trial] for trial in TRIALS if trial in known}
    FIGURES.write_text(json.dumps(known, indent=1) + "\n")
    page.write(known)


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("trials", nargs="*", choices=[[], *TRIALS], help="all when none is named")
    parser.add_argument("--share", type=float, default=1.0, help="of the full size")
    parser.add_argument("--commit", action="store_true", help="keep the figures and renew the page")
    options = parser.parse_args()
    kept = True
    for name in options.trials or TRIALS:
        found = []
        for figure in TRIALS[name](options.share):
            print(figure.row(), flush=True)
            found.append(figure)
        kept = kept and all(figure.met for figure in found)
        if options.commit:
            _keep(name, found)
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
