"""Every speed that this project promises, measured in one run: `python -m tests.bench`.

    python -m tests.bench [--rounds 5] [--peer-path CHECKOUT] [--live MINUTES] [--json FILE]
    python -m tests.bench --check        # compare ratios with the committed figures, write nothing

CPU time, medians over interleaved rounds with quartiles, ratios within one run. A ratio may be worse than
the committed one by TOLERANCE before `--check` fails: two runs of one tree differ by up to a third on a
shared machine. Times and real-time factors are shown, never compared.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path

from tests.bench import allocation, loop, start
from tests.bench.figure import Figure, short
from tests.bench.machine import describe
from twin.vehicle import load_vehicle

COMMITTED = Path(__file__).with_name("figures.json")
TOLERANCE = 0.4


def measured(options: argparse.Namespace) -> Iterator[Figure]:
    """Every row, as soon as it is known."""
    vehicle = load_vehicle("ts100")
    yield from allocation.figures(vehicle, options.rounds, options.paced)
    yield from loop.closed_loop(vehicle, options.rounds)
    yield from loop.one_step(options.rounds, options.peer_path)
    yield from loop.envelope(vehicle, max(options.rounds, 15))
    yield from start.figures(min(options.rounds, 5))
    if options.live > 0.0:
        from tests.bench import live_row

        yield from live_row.figures(options.live)


def line(f: Figure) -> str:
    """One row of the printed table."""
    mark = {True: "met", False: "NOT MET", None: ""}[f.met]
    spread = f"{short(f.low)} … {short(f.high)}" if f.low != f.high else ""
    return f"{f.title:72s} {short(f.value):>9s} {f.unit:12s} {spread:>20s}  {f.goal:8s} {mark}"


def regressions(figures: list[Figure], committed: dict) -> list[str]:
    """Ratios that are worse than the committed ones by more than TOLERANCE; shares that miss their goal."""
    said = []
    known = {row["key"]: row for row in committed["figures"]}
    for f in figures:
        if f.ratio and f.key in known:
            before = known[f.key]["value"]
            worse = (
                f.value < before * (1 - TOLERANCE)
                if f.better == "higher"
                else f.value > before * (1 + TOLERANCE)
            )
            if worse:
                said.append(f"{f.title}: {short(f.value)}, was {short(before)}")
        if f.unit == "%" and f.met is False:
            said.append(f"{f.title}: {short(f.value)} %, must be {f.goal}")
    return said


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--paced", type=float, default=12.0, help="seconds of paced calls")
    parser.add_argument("--peer-path", type=Path, help="checkout of PythonVehicleSimulator")
    parser.add_argument(
        "--live", type=float, default=0.0, help="minutes of a live node beside a loaded server"
    )
    parser.add_argument("--check", action="store_true", help="compare ratios with the committed figures")
    parser.add_argument("--json", type=Path, default=COMMITTED, help="where the figures go")
    options = parser.parse_args()
    machine = describe()
    print("\n".join(f"{name}: {value}" for name, value in machine.items()), flush=True)
    figures = []
    for f in measured(options):
        print(line(f), flush=True)
        figures.append(f)
    if not options.check:
        text = json.dumps(
            {"machine": machine, "figures": [f.as_json() for f in figures]}, indent=1, ensure_ascii=False
        )
        options.json.write_text(text + "\n", encoding="utf-8")
        return 0
    said = regressions(figures, json.loads(COMMITTED.read_text(encoding="utf-8")))
    print(
        "\n".join(said) if said else f"no ratio is worse than the committed one by more than {TOLERANCE:.0%}"
    )
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
