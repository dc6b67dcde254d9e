"""What is wanted of a docking vehicle, measured on drawn flights that had no part in any choice.

Numbers begin at HELD_OUT: nobody tunes or looks there. Every flight is judged by the judge of all runs.
"""

import argparse
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from bumpless.campaign.engine import in_order
from bumpless.metrics import Columns, figures_of
from bumpless_paper.study.docks import response
from bumpless_paper.study.docks.cases import Heading, Kind, draw_case, vehicle
from bumpless_paper.study.docks.many import fly_case

HELD_OUT = 6_000_000
GENTLE = 0.05  # largest step of the commands over their bounds
Progress = Callable[[int, int], None] | None


@dataclass(frozen=True)
class Group:
    """Flights of one kind, and how many of them a whole report flies."""

    kind: Kind
    heading: Heading
    count: int
    about: str


GROUPS: dict[str, Group] = {
    "into": Group("normal", "into", 600, "current of 0 to 0.15 m/s from any side, approach into it"),
    "still": Group("still", "fixed", 200, "still water, fixed heading"),
    "fixed": Group("normal", "fixed", 200, "current from any side, fixed heading"),
    "lost": Group("lost", "", 200, "target lost for 5 to 200 s"),
    "camera_dead": Group("camera_dead", "", 100, "target never seen"),
    "fault": Group("fault", "", 200, "an actuator loses effect"),
    "any": Group("any", "", 200, "a fault and a target lost"),
}
RESPONSES = {"depth_step": 20, "heading_step": 20, "start_dip": 20, "stay": 200}
LOADS = {"light": 20, "heavy": 20, "shifted": 20}


@dataclass(frozen=True)
class Flown:
    """One drawn mission; NaN for what did not happen."""

    outcome: str
    why: str
    step_fr: float  # largest, to the ramp's end and 15 s more
    step_rh: float
    depth_r_m: float  # RMS about the reference in R, as believed


def fly(job: tuple[str, int]) -> Flown:
    """Flight `number` of a group."""
    group, number = GROUPS[job[0]], job[1]
    case = draw_case(number, group.kind, group.heading)
    result = fly_case(case)
    columns = Columns.from_log(result.log, len(vehicle().commands))
    metrics, outcome = figures_of(columns, vehicle(), case.mission, "completed")
    depth = [mode.depth_error_rms_m for mode in metrics.modes if mode.mode == 2]
    return Flown(
        outcome.ending.value,
        outcome.why,
        metrics.d_u_fr_settling,
        metrics.d_u_rh_settling,
        depth[0] if depth else float("nan"),
    )


def answer(job: tuple[str, int]) -> Any:
    """A flight, or a response, by its name."""
    name, number = job
    if name in GROUPS:
        return fly(job)
    if name in ("light", "heavy"):
        return response.loaded(number, 1.0 if name == "light" else -1.0)
    return getattr(response, name)(number)


def loads(first: int = HELD_OUT, workers: int = 1) -> dict[str, list[int]]:
    """[docked, flown] of vehicles that are 1 N too light or too heavy, or whose ballast was moved."""
    jobs = [(name, first + i) for name, count in LOADS.items() for i in range(count)]
    said = in_order(jobs, answer, workers)
    flown: dict[str, list[Any]] = {name: [] for name in LOADS}
    for (name, _), docked in zip(jobs, said, strict=True):
        flown[name].append(docked)
    return {name: [sum(flown[name]), len(flown[name])] for name in LOADS}


def measure(
    share: float = 1.0, first: int = HELD_OUT, workers: int = 1, progress: Progress = None
) -> dict[str, Any]:
    """All of it, plain values fit for JSON. share: of the flights of a whole report."""
    counts = {name: group.count for name, group in GROUPS.items()} | RESPONSES | LOADS
    jobs = [(name, first + i) for name, count in counts.items() for i in range(max(2, round(count * share)))]
    found: dict[str, list[Any]] = {}
    for (name, _), said in zip(jobs, in_order(jobs, answer, workers, progress), strict=True):
        found.setdefault(name, []).append(said)
    groups = {name: counted(found[name]) | {"about": GROUPS[name].about} for name in GROUPS}
    return {"first": first, "groups": groups, "responses": responses(found)}


def counted(flights: Sequence[Flown]) -> dict[str, Any]:
    """How the flights of a group ended, why, and how gently those that docked switched."""
    endings, why = _tally(f.outcome for f in flights), _tally(f"{f.outcome}: {f.why}" for f in flights)
    docked = [f for f in flights if f.outcome == "docked"]
    return {
        "flights": len(flights),
        "endings": endings,
        "why": why,
        "gentle": {
            name: [sum(getattr(f, name) <= GENTLE for f in docked), len(docked)]
            for name in ("step_fr", "step_rh")
        },
        "largest_step": {
            name: _quantiles([getattr(f, name) for f in docked]) for name in ("step_fr", "step_rh")
        },
        "depth_r_m": _quantiles([f.depth_r_m for f in docked]),
    }


def responses(found: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    """Steps, start, long stays and loads."""
    out: dict[str, Any] = {}
    for name in ("depth_step", "heading_step"):
        steps = found[name]
        out[name] = {
            "plants": len(steps),
            "settled_s": _quantiles([step.settled_s for step in steps]),
            "overshoot": _quantiles([step.overshoot for step in steps]),
        }
    out["start_dip_mps"] = _quantiles(found["start_dip"])
    stays = [one for one in found["stay"] if one.accepted]
    out["stay"] = {
        "asked": len(found["stay"]),
        "accepted": len(stays),
        "held": sum(one.held for one in stays),
        "within": _quantiles([one.within for one in stays]),
        "wander_deg": _quantiles([one.wander_deg for one in stays]),
    }
    out |= {name: [sum(found[name]), len(found[name])] for name in LOADS}
    return out


def _tally(words: Any) -> dict[str, int]:
    out: dict[str, int] = {}
    for word in words:
        out[word] = out.get(word, 0) + 1
    return dict(sorted(out.items(), key=lambda item: (-item[1], item[0])))


@dataclass(frozen=True)
class Quantiles:
    """Of figures that are known; None without any."""

    median: float | None
    q90: float | None
    worst: float | None


def _quantiles(values: Sequence[float]) -> dict[str, float | None]:
    known = np.array(values, float)
    known = known[np.isfinite(known)]
    if not len(known):
        return asdict(Quantiles(None, None, None))
    return asdict(Quantiles(float(np.median(known)), float(np.percentile(known, 90)), float(known.max())))


def main() -> None:
    """Print what was measured: `python -m bumpless_paper.study.outcomes [--loads]`."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--share", type=float, default=1.0, help="of the flights of a whole report")
    parser.add_argument("--first", type=int, default=HELD_OUT)
    parser.add_argument("--loads", action="store_true", help="only too light, too heavy and moved ballast")
    a = parser.parse_args()
    said = loads(a.first, 2) if a.loads else measure(a.share, a.first, workers=2)
    print(json.dumps(said, indent=1))


if __name__ == "__main__":
    main()
