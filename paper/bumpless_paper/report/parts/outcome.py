"""Does it dock: drawn flights that had no part in any choice, by how they ended, and why."""

import os

from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.outcomes import HEAD, rows_of
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.study import counted
from bumpless_paper.study.docks.cases import vehicle
from bumpless_paper.study.outcomes import HELD_OUT, measure

SHARE = min(1.0, int(os.environ.get("BUMPLESS_PLANTS", "60")) / 60)


def part(progress: Progress) -> Part:
    """Fly all groups, the steps, the long stays and the loads."""
    workers = os.cpu_count() or 1
    numbers = measure(SHARE, workers=workers, progress=counted(progress, 0.0, 1.0))
    progress(1.0)
    flights = sum(group["flights"] for group in numbers["groups"].values())
    return Part(
        "outcome",
        "Does it dock?",
        f"{flights} drawn missions of TS-100 as it ships (numbers from {HELD_OUT:,} on: none had a part in "
        "any "
        "choice), each with a vehicle, sensors and a sea of its own, judged by the truth. Docked: in hover "
        "within "
        "0.15 m, 5° and 0.05 m/s of the observation point for the last 10 s. Collided: a part of the hull "
        "was in "
        "the dock, a box of 2 by 2 by 1.5 m behind the marker.",
        [
            Grid(
                "outcome",
                "What is wanted, and what was measured",
                "Before: on the version that the targets were set against.",
                HEAD,
                [row.cells for row in rows_of({"outcome": {"numbers": numbers}})],
            ),
            Grid(
                "outcome_endings",
                "How the flights ended, and why",
                "",
                ["flown", "flights", "ending: why", "count"],
                [
                    [group["about"], group["flights"], why.replace("_", " "), count]
                    for group in numbers["groups"].values()
                    for why, count in group["why"].items()
                ],
            ),
        ],
        numbers=numbers,
        hashes={"vehicle ts100": vehicle().sha256},
    )
