"""Every speed that this project promises, measured in one run: `python -m tests.bench`.

    python -m tests.bench [--rounds 5] [--peer-path CHECKOUT] [--live MINUTES] [--campaign 10000]
        [--json FILE]
    python -m tests.bench --check        # compare with the committed figures (see `compare`), write nothing
    python -m tests.bench --commit       # write the committed figures and the table of docs/performance.md

CPU time, medians over interleaved rounds with quartiles, ratios within one run.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path

from bumpless.config.vehicle import load_vehicle
from tests.bench import allocation, loop, render, start
from tests.bench.compare import RATIO_TOLERANCE, SHARE_TOLERANCE, regressions
from tests.bench.figure import Figure, short
from tests.bench.machine import describe

WRITTEN = Path("build/bench.json")


def measured(options: argparse.Namespace) -> Iterator[Figure]:
    """Every row, as soon as it is known."""
    vehicle = load_vehicle("ts100")
    yield from allocation.figures(vehicle, options.rounds, options.paced)
    yield from loop.closed_loop(vehicle, options.rounds)
    yield from loop.one_step(options.rounds, options.peer_path)
    yield from loop.envelope(vehicle, max(options.rounds, 15))
    yield from start.figures(min(options.rounds, 5))
    if options.campaign > 0:
        from tests.bench import campaign

        yield from campaign.figures(options.campaign)
    if options.live > 0.0:
        from tests.bench import live_row

        yield from live_row.figures(options.live)


def line(f: Figure) -> str:
    """One row of the printed table."""
    mark = {True: "met", False: "NOT MET", None: ""}[f.met]
    spread = f"{short(f.low)} … {short(f.high)}" if f.low != f.high else ""
    return f"{f.title:72s} {short(f.value):>9s} {f.unit:12s} {spread:>20s}  {f.goal:8s} {mark}"


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
    parser.add_argument(
        "--campaign", type=int, default=0, help="missions of a campaign, on two workers and on one: 10000"
    )
    parser.add_argument("--check", action="store_true", help="compare with the committed figures")
    parser.add_argument("--commit", action="store_true", help="make these the committed figures")
    parser.add_argument("--json", type=Path, default=WRITTEN, help="where the figures go")
    options = parser.parse_args()
    machine = describe()
    print("\n".join(f"{name}: {value}" for name, value in machine.items()), flush=True)
    figures = []
    for f in measured(options):
        print(line(f), flush=True)
        figures.append(f)
    if options.check:
        return checked(figures)
    measured_ = {"machine": machine, "figures": [f.as_json() for f in figures]}
    file = render.FIGURES if options.commit else options.json
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(measured_, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    print(f"written to {file}")
    if options.commit:
        page = render.PAGE.read_text(encoding="utf-8")
        render.PAGE.write_text(render.page_of(page, measured_), encoding="utf-8")
    return 0


def checked(figures: list[Figure]) -> int:
    """Say what is worse than committed, and what of it was not measured; 1 when something is worse."""
    committed = json.loads(render.FIGURES.read_text(encoding="utf-8"))
    seen = {f.key for f in figures}
    for row in committed["figures"]:
        if row["ratio"] and row["key"] not in seen:
            print(f"not measured: {row['title']}")
    said = regressions(figures, committed)
    limits = f"{RATIO_TOLERANCE:.0%} for ratios, {SHARE_TOLERANCE:.0%} for shares"
    print("\n".join(said) if said else f"nothing is worse than committed by more than {limits}")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
