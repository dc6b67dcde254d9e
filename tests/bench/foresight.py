"""How fast a plan is foreseen, and whether the fan's chance is right: `python -m tests.bench.foresight`.

    python -m tests.bench.foresight [--edits 30] [--fans 5] [--docs]
    python -m tests.bench.foresight --chance 30 [--fresh 1000] [--json FILE] [--docs]

--docs writes what was measured into docs/foresight.md, where its part begins and ends with a mark.

Speeds are wall times of the real processes, from a request's sending to the message's arrival; the browser's
own part is measured in the browser. `--chance` flies as many missions and counts on how many the interval of
a fan of 200 holds the share of fresh flights that dock, drawn with other seeds and at random, not evenly.
"""

import argparse
import asyncio
import json
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from bumpless.config.mission import missions_folder
from tests.bench.figure import Figure, figure, short
from tests.bench.machine import describe

FAN = 200
FRESH_SEED = 1_000_000  # of the campaign of fresh flights; the fan's are the missions' own numbers
PAGE = Path(__file__).parents[2] / "docs" / "foresight.md"
DOCKING = (missions_folder() / "docking.yaml").read_text(encoding="utf-8")


def figures(edits: int, fans: int) -> list[Figure]:
    """Rows of the table of speeds."""
    return asyncio.run(_measured(edits, fans))


async def _measured(edits: int, fans: int) -> list[Figure]:
    from bumpless_server.foresight.foresight import Foresight

    foresight, told = Foresight(), asyncio.Queue[tuple[float, dict[str, Any]]]()

    async def send(text: str) -> None:
        told.put_nowait((time.perf_counter(), json.loads(text)))

    numbers = iter(range(1, 1_000_000))
    async with foresight.client(send) as client:

        async def asked(text: str, flights: int, until: str, of: int = 0) -> float:
            """Seconds from asking to a message of this kind, with so many flights done."""
            number, begun = next(numbers), time.perf_counter()
            client.ask(json.dumps({"id": number, "text": text, "seed": 1, "flights": flights}))
            while True:
                at, message = await told.get()
                if message["id"] == number and message["kind"] == until and message.get("done", 0) >= of:
                    return at - begun

        await asked(DOCKING, 0, "done")
        drags = []
        for k in range(edits):
            text = DOCKING.replace("  heading_deg: 0", f"  heading_deg: {k / 10}", 1)
            drags.append(1e3 * await asked(text, FAN, "nominal"))
            await asyncio.sleep(0.15)  # a hand drags: the fan has begun when the next edit comes
        first = [await asked(DOCKING, FAN, "fan", 20) for _ in range(fans)]
        whole = [await asked(DOCKING, FAN, "fan", FAN) for _ in range(fans)]
    await foresight.stop()
    ordered = sorted(drags)
    return [
        figure("foresight_edit_ms", "edit to nominal flight while dragging", drags, "ms", at_most=200),
        figure(
            "foresight_edit_p95_ms", "the same, p95", [ordered[int(0.95 * len(ordered))]], "ms", at_most=400
        ),
        figure("foresight_first_s", "edit to the first 20 flights of a fan", first, "s", at_most=0.6),
        figure("foresight_fan_s", f"edit to all {FAN} flights of a fan", whole, "s", at_most=3.0),
    ]


def planned(count: int) -> Iterator[tuple[str, str]]:
    """(name, text) of missions that differ: heads, currents from ahead and aside, depths, standoffs."""
    for k in range(count):
        along, across = -0.01 * (k % 13), 0.0025 * (k % 5 - 2)
        text = DOCKING.split("\nenvironment:")[0] + "\n"
        text += f"environment:\n  current_ned_mps: [{along:g}, {across:g}, 0]\n"
        yield f"docking, current {along:g} {across:g}", text.replace("seed: ", "# seed: ") + f"seed: {k}\n"


def chance(missions: int, fresh: int) -> list[dict[str, Any]]:
    """For each mission: the fan's interval, and the share of fresh flights that docked."""
    from bumpless.campaign.summary import share_of

    found = []
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        for k, (name, text) in enumerate(planned(missions)):
            parts = [(text, k, first, FAN // 2, True) for first in (0, FAN // 2)]
            step = max(fresh // 10, 1)
            parts += [(text, FRESH_SEED + k, first, step, False) for first in range(0, fresh, step)]
            docked = list(pool.map(_docked, parts))
            share, true = share_of(sum(docked[:2]), FAN), sum(docked[2:]) / fresh
            row = {"mission": name, "fan": share.share, "low": share.low, "high": share.high}
            found.append(row | {"fresh": true, "inside": share.low <= true <= share.high})
            print(json.dumps(found[-1]), flush=True)
    return found


def _docked(part: tuple[str, int, int, int, bool]) -> int:
    """How many of `count` drawn flights from `first` on dock."""
    from dataclasses import replace

    from bumpless.campaign.flight import Hangar
    from bumpless.campaign.ready import ready
    from bumpless_server.foresight import fan
    from bumpless_server.foresight.plan import plan_of
    from bumpless_server.foresight.wanted import ForesightRequest

    text, seed, first, count, even = part
    ready()
    drawn = fan.prepared(plan_of(ForesightRequest.model_validate({"id": 0, "text": text, "seed": seed})))
    drawn = replace(drawn, even=even)
    return sum(flight.outcome == "docked" for flight in fan.fly(drawn, first, count, Hangar()))


def into_docs(part: str, lines: list[str], page: Path = PAGE) -> None:
    """Put lines between a part's marks on the page."""
    text = page.read_text(encoding="utf-8")
    begin, end = f"<!-- {part}: begin -->\n", f"<!-- {part}: end -->"
    before, _, rest = text.partition(begin)
    _, _, after = rest.partition(end)
    page.write_text(before + begin + "\n".join(lines) + "\n" + end + after, encoding="utf-8")


def speed_lines(found: list[Figure]) -> list[str]:
    """The table of speeds."""
    told = describe()
    head = f"processor: {told['processor']}; cores: {told['cores']}; load average: {told['load average']}."
    rows = [
        f"| {one.title} | {short(one.value)} {one.unit} | {short(one.low)} … {short(one.high)} | {one.goal} |"
        for one in found
    ]
    return [head, "", "| figure | median | quartiles | goal |", "|---|--:|--:|---|", *rows]


def chance_lines(rows: list[dict[str, Any]], fresh: int) -> list[str]:
    """What became of the intervals."""
    inside = sum(row["inside"] for row in rows)
    far = sorted(100 * abs(row["fan"] - row["fresh"]) for row in rows)
    head = f"Inside: {inside} of {len(rows)} (goal: 28 of 30), with fans of {FAN} and {fresh} fresh flights."
    more = f"The two shares differ by {far[len(far) // 2]:.1f} % at the median, {far[-1]:.1f} % at most."
    table = ["| mission | fan | interval | fresh flights | |", "|---|--:|--:|--:|---|"]
    for row in rows:
        interval = f"{row['low']:.1%} to {row['high']:.1%}"
        word = "inside" if row["inside"] else "**outside**"
        table.append(f"| {row['mission']} | {row['fan']:.1%} | {interval} | {row['fresh']:.1%} | {word} |")
    return [head, more, "", *table]


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--edits", type=int, default=30)
    parser.add_argument("--fans", type=int, default=5)
    parser.add_argument(
        "--chance", type=int, default=0, help="missions over which the fan's chance is checked"
    )
    parser.add_argument("--fresh", type=int, default=1000, help="fresh flights of each")
    parser.add_argument("--json", type=Path, default=None)
    parser.add_argument("--docs", action="store_true", help="write the result into docs/foresight.md")
    options = parser.parse_args()
    if options.chance:
        rows = chance(options.chance, options.fresh)
        print(f"inside: {sum(row['inside'] for row in rows)} of {len(rows)}")
        if options.json is not None:
            options.json.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
        if options.docs:
            into_docs("chance", chance_lines(rows, options.fresh))
        return
    found = figures(options.edits, options.fans)
    if options.docs:
        into_docs("speed", speed_lines(found))
    for one in found:
        print(
            f"{one.title}: {short(one.value)} {one.unit} ({short(one.low)} … {short(one.high)}), {one.goal}"
        )


if __name__ == "__main__":
    main()
