"""Allocator by ramp, judged by what counts: outcome, tracking, settling steps, true wrench and cost.

Every row of the table flies the same mission on the same drawn plants with the same gains; what differs is
the allocator and whether demand and weights are ramped at a switch. The plants are those of `WIDE`, on which
no allocator's map is exact.

    judge(n_plants=60)["rows"]["S4"]["docked"]  -> share of plants on which the flight docked
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bumpless.campaign.summary import share_of
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import Columns, figures_of
from bumpless_paper.study.commanded import commanded_error
from bumpless_paper.study.fly import Job, fly, fly_all
from bumpless_paper.study.plants import WIDE, draw
from bumpless_paper.study.scenarios import HONEST
from bumpless_paper.study.tables import Progress

Judged = dict[str, float]  # of one flight
HELD_OUT = 200  # first plant that had no part in choosing parameters
AS_FILE = 20  # seeds flown on the plant that the allocator's map is of
LEARNED = ("S4", "S2")  # flown once more with what was identified in a flight before
MODES = {pb.MODE_FORWARD: "F", pb.MODE_REVERSE: "R", pb.MODE_HOVER: "H"}


def judged(job: Job) -> Judged:
    """What counts of one flight; NaN for what did not happen."""
    result = fly(job)
    columns = Columns.from_log(result.log, len(result.vehicle.commands))
    metrics, outcome = figures_of(columns, result.vehicle, result.mission, "completed")
    out: Judged = {"outcome": float(metrics.outcome.ending)}
    if outcome.true_errors is not None:
        out["position_m"], out["heading_deg"] = (
            outcome.true_errors.position_m,
            abs(outcome.true_errors.heading_deg),
        )
    out |= {
        "e_tau_map": metrics.residual_rms,
        "e_tau_told": commanded_error(job, result),
        "e_tau_true": metrics.residual_rms_true,
        "window_FR": metrics.d_u_fr,
        "window_RH": metrics.d_u_rh,
        "settling_FR": metrics.d_u_fr_settling,
        "settling_RH": metrics.d_u_rh_settling,
        "force_step_n": max((s.force_step_n for s in metrics.switches), default=np.nan),
        "moment_step_nm": max((s.moment_step_nm for s in metrics.switches), default=np.nan),
        "energy_j": metrics.shaft_energy_j,
        "fin_travel_deg": metrics.fin_travel_deg,
        "reversals": float(metrics.screw_reversals),
    }
    for mode in metrics.modes:
        letter = MODES[mode.mode]
        out[f"depth_{letter}_m"] = mode.depth_error_rms_m
        out[f"cross_{letter}_m"] = mode.cross_track_error_rms_m
        out[f"heading_{letter}_deg"] = mode.heading_error_rms_deg
        out[f"speed_{letter}_mps"] = mode.speed_error_rms_mps
    return out


def judge(
    n_plants: int = 60,
    progress: Progress = None,
    workers: int | None = None,
    first: int = HELD_OUT,
    names: Sequence[str] = tuple(HONEST),
) -> dict[str, Any]:
    """Fly every row of the table on plants first .. first + n_plants - 1; plain values fit for JSON.

    `as_file`: median RMS of e_tau by the true wrench on the plant of the vehicle's file, over seeds.
    `learned`: two of the rows, their vehicles flown before, see `study.learned`. Of each row: the share of
    every ending with its 95 % interval, the median of each figure, and the share of plants on which the
    largest step while settling is at most 0.05.
    """
    plants = [draw(first + i, WIDE) for i in range(n_plants)]
    jobs = [Job(name, plant.number + 1, plant) for name in names for plant in plants]
    seeds = range(first, first + min(AS_FILE, n_plants))
    jobs += [Job(name, seed) for name in names for seed in seeds]
    jobs += [Job(name, plant.number + 1, plant, learned=True) for name in LEARNED for plant in plants]
    flat = fly_all(jobs, judged, workers=workers, progress=progress)
    known = flat[len(names) * n_plants :]
    after = known[len(names) * len(seeds) :]
    return {
        "plants": n_plants,
        "first": first,
        "as_file": {
            name: _median([flight["e_tau_true"] for flight in known[k * len(seeds) : (k + 1) * len(seeds)]])
            for k, name in enumerate(names)
        },
        "learned": {name: summed(after[k * n_plants : (k + 1) * n_plants]) for k, name in enumerate(LEARNED)},
        "rows": {
            name: summed(flat[k * n_plants : (k + 1) * n_plants]) | {"title": HONEST[name].title}
            for k, name in enumerate(names)
        },
    }


def summed(flights: Sequence[Judged]) -> dict[str, Any]:
    """One row of the table from its flights."""
    endings = np.array([flight["outcome"] for flight in flights])
    out: dict[str, Any] = {}
    for name, number in pb.Ending.items():
        if number == pb.ENDING_UNSPECIFIED:
            continue
        count = int(np.count_nonzero(endings == number))
        word = name.removeprefix("ENDING_").lower()
        out[word] = count / len(flights)
        if word == "docked":
            found = share_of(count, len(flights))
            out["docked_interval"] = (found.low, found.high)
    for switch in ("FR", "RH"):
        steps = np.array([flight[f"settling_{switch}"] for flight in flights])
        out[f"gentle_{switch}"] = float(np.mean(steps <= 0.05))  # NaN, no such switch, is not gentle
    keys = {key for flight in flights for key in flight} - {"outcome"}
    out["median"] = {key: _median([flight.get(key, np.nan) for flight in flights]) for key in sorted(keys)}
    return out


def _median(values: Sequence[float]) -> float | None:
    known = np.array(values)[np.isfinite(values)]
    return float(np.median(known)) if len(known) else None
