"""How well thrust and lift are learned from a flight, and what fault finding gains by it.

`python -m bumpless_paper.study.identified` flies drawn vehicles: the study's own flight (S4, wide plants) and
docking flights, and prints how far the scales are off, how often their 95 % interval holds the truth and how
often they are told. Then S7 on wide plants, with its fault and without, as drawn and learned.
"""

import argparse
from collections.abc import Iterable, Sequence

import numpy as np

from bumpless.campaign.engine import in_order
from bumpless.config.vehicle import load_vehicle
from bumpless.identify import Flight, Found, identify
from bumpless.identify.scales import DRAG_ACROSS, DRAG_ALONG, LIFT, THRUST
from bumpless.sim.twin import Result
from bumpless_paper.study.detection import Detection, detection_for
from bumpless_paper.study.docks.cases import draw_case
from bumpless_paper.study.docks.many import fly_case
from bumpless_paper.study.fly import Job, fly, fly_all
from bumpless_paper.study.plants import WIDE, Plant, draw

FLOWN = ("S4", "docking into the current", "docking in still water")
Error = tuple[str, float, bool, bool]  # (title, value less truth, inside its interval, told)


def errors(job: tuple[str, int]) -> list[Error]:
    """Of every scale from one flight of one drawn vehicle: picklable work."""
    flown, number = job
    if flown == "S4":
        plant = draw(number, WIDE)
        return _errors(plant, fly(Job("S4", number + 1, plant)))
    kind, heading = ("normal", "into") if flown == FLOWN[1] else ("still", "fixed")
    case = draw_case(number, kind, heading)
    return _errors(case.plant, fly_case(case))


def _errors(plant: Plant, result: Result) -> list[Error]:
    found = found_in(result)
    parts = {
        THRUST: plant.thrust,
        LIFT: plant.fin_lift,
        DRAG_ALONG: plant.drag_axial,
        DRAG_ACROSS: plant.drag_cross,
    }
    out: list[Error] = []
    for one in found.estimates:
        truth, (low, high) = parts[one.scale.what], one.interval
        out.append((one.scale.title, one.value - truth, low <= truth <= high, one.scale in found.factors))
    return out


def found_in(result: Result) -> Found:
    """What a flight's log tells."""
    vehicle = load_vehicle("ts100")
    return identify([Flight.from_log(result.log, len(vehicle.commands))], vehicle)


def told(flown: str, numbers: Iterable[int], workers: int = 1) -> list[str]:
    """One line of figures for each scale."""
    rows = in_order([(flown, number) for number in numbers], errors, workers)
    lines: list[str] = []
    for same in zip(*rows, strict=True):
        off = np.sqrt(np.mean([one[1] ** 2 for one in same]))
        inside, said = (float(np.mean([one[k] for one in same])) for k in (2, 3))
        lines.append(
            f"{flown}, {same[0][0]}: off by {off:.3f} RMS, in its interval {inside:.0%}, told {said:.0%}"
        )
    return lines


def faults(numbers: Sequence[int], learned: bool, workers: int = 1) -> str:
    """False alarms without a fault, and how the fault of S7 was found, in words."""
    plants = [draw(number, WIDE) for number in numbers]

    def flown(name: str) -> list[Detection]:
        jobs = [Job(name, plant.number + 1, plant, learned=learned) for plant in plants]
        return fly_all(jobs, detection_for, workers=workers)

    whole, broken = flown("S7-healthy"), flown("S7")
    false = sum(one.false_alarms > 0 for one in whole)
    right = [one for one in broken if one.isolated and one.delay_s >= 0.0]
    delay, error = (np.median([getattr(one, name) for one in right]) for name in ("delay_s", "error"))
    return (
        f"S7 on {len(plants)} plants {'learned' if learned else 'as drawn'}: {false} flights with a false "
        f"alarm, {len(right)} faults named rightly, after {delay:.1f} s, share off by {error:.3f} (medians)"
    )


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=60)
    parser.add_argument("--count", type=int, default=40)
    a = parser.parse_args()
    numbers = range(a.first, a.first + a.count)
    for flown in FLOWN:
        print("\n".join(told(flown, numbers, workers=2)), flush=True)
    for learned in (False, True):
        print(faults(numbers, learned, workers=2), flush=True)


if __name__ == "__main__":
    main()
