"""What the autopilot can tell of its actuators by itself: S7 over plants, actuators and modes.

answer = run(200)
answer["tuned"]["delay_s"]["median"], answer["tuned"]["false_alarms"], answer["where"]
The estimator's numbers were chosen on plants 0 to 199; others had no part in it.
"""

import time
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from bumpless_paper.study.detection import Detection, detection_for, detection_of
from bumpless_paper.study.figures import Figures, figures_of
from bumpless_paper.study.fly import FAULT_TIME_S, Job, figures_for, fly, fly_all
from bumpless_paper.study.plants import NOMINAL, Plant, draw
from bumpless_paper.study.robustness import HELD_OUT, TUNED_ON
from bumpless_paper.study.tables import Progress

SEEDS = (1, 2, 3, 4, 5)
COMPARED = ("rms_e_tau_post_true", "d_theta_fault_rms", "d_psi_fault_rms")
PLACES = (("cruise (F)", 20.0), ("braking (R)", 32.0), ("hover (H)", 56.0))  # fault times, s
FEW = 10  # plants for each actuator and place, and for each error of the map
LEFT = 0.4  # effectiveness there
MAP_ERRORS: tuple[tuple[str, dict[str, float]], ...] = (
    ("thrust 10 % less", {"thrust": 0.9}),
    ("thrust 10 % more", {"thrust": 1.1}),
    ("fin lift 20 % less", {"fin_lift": 0.8}),
    ("fin lift 20 % more", {"fin_lift": 1.2}),
)


def found_and_figures(job: Job) -> tuple[Detection, Figures]:
    """Both readings of one flight: picklable work of `fly_all`."""
    result = fly(job)
    return detection_of(result), figures_of(result, job.plant.fault_time or FAULT_TIME_S)


def jobs_on(scenario: str, plants: Sequence[Plant]) -> list[Job]:
    """One flight on each plant; plant i flies with seed i + 1."""
    return [Job(scenario, p.number + 1, p) for p in plants]


def run(n_plants: int = 200, progress: Progress = None, workers: int | None = None) -> dict[str, Any]:
    """Every figure of S7. progress(done, total) counts flights. Plain values fit for JSON."""
    tuned = [draw(TUNED_ON + i) for i in range(n_plants)]
    unseen = [draw(HELD_OUT + i) for i in range(n_plants)]
    nominal = [Job("S7", seed) for seed in SEEDS]
    named = (("delta_1", 0), ("n_p", 4), ("n_v1", 5))
    places = [
        replace(p, fault_actuator=i, fault_time=at, fault_effectiveness=LEFT)
        for _, i in named
        for _, at in PLACES
        for p in tuned[:FEW]
    ]
    wrong_maps = [replace(p, **error) for _, error in MAP_ERRORS for p in tuned[:FEW]]
    batches: tuple[tuple[list[Job], Any], ...] = (
        (nominal + jobs_on("S7", tuned), found_and_figures),
        (jobs_on("S7", unseen) + jobs_on("S7-healthy", tuned + unseen), detection_for),
        (jobs_on("S7", places) + jobs_on("S7-healthy", wrong_maps), detection_for),
        ([Job(name, seed) for name in ("S5", "S6") for seed in SEEDS], figures_for),
        (jobs_on("S5", tuned) + jobs_on("S6", tuned), figures_for),
    )
    total, done, answers = sum(len(jobs) for jobs, _ in batches), 0, []
    for jobs, work in batches:
        at = done
        count = (lambda n, _, at=at: progress(at + n, total)) if progress else None
        answers.append(fly_all(jobs, work, workers, count))
        done += len(jobs)
    first, healthy, rest, told_nominal, told = answers
    n, few, s = n_plants, len(tuned[:FEW]), len(SEEDS)
    spots = [(name, place) for name, _ in named for place, _ in PLACES]
    figures = [f for _, f in first]
    return {
        "nominal": summary([d for d, _ in first[:s]], []),
        "tuned": summary([d for d, _ in first[s:]], healthy[n : 2 * n]),
        "unseen": summary(healthy[:n], healthy[2 * n :]),
        "where": [
            {"actuator": name, "mode": place, **summary(rest[k * few : (k + 1) * few], [])}
            for k, (name, place) in enumerate(spots)
        ],
        "wrong_map": [
            {"map": name, **summary([], rest[(len(spots) + k) * few : (len(spots) + k + 1) * few])}
            for k, (name, _) in enumerate(MAP_ERRORS)
        ],
        "nominal_figures": medians(figures[:s], told_nominal[:s], told_nominal[s:]),
        "plant_figures": medians(figures[s:], told[:n], told[n:]),
        "cost_us": cost_us(),
    }


def summary(faulty: Sequence[Detection], healthy: Sequence[Detection]) -> dict[str, Any]:
    """Delay, isolation and error of flights with a fault; alarms on whole actuators in all of them.

    Quantiles of the delay count a fault that was never found as infinite, told as None.
    """
    delay = np.array([np.inf if np.isnan(d.delay_s) else d.delay_s for d in faulty])
    error = np.array([d.error for d in faulty if np.isfinite(d.error)])
    hours = sum(d.hours for d in (*faulty, *healthy))
    false = sum(d.false_alarms for d in (*faulty, *healthy))
    found = [d for d in faulty if d.isolated is not None]
    return {
        "flights": len(faulty),
        "found": len(found),
        "isolated": sum(d.isolated is True for d in found),
        "delay_s": {"median": _quantile(delay, 0.5), "q90": _quantile(delay, 0.9)},
        "error": {"median": _quantile(error, 0.5), "q90": _quantile(error, 0.9)},
        "false_alarms": false,
        "healthy_hours": float(hours),
        "false_alarms_per_hour": float(false / hours) if hours > 0.0 else None,
    }


def medians(
    s7: Sequence[Figures], s5: Sequence[Figures], s6: Sequence[Figures]
) -> dict[str, dict[str, float]]:
    """Median of each compared figure, and of its ratio to S5 flight by flight."""
    out: dict[str, dict[str, float]] = {}
    for key in COMPARED:
        row = {name: np.array([f[key] for f in of]) for name, of in (("S5", s5), ("S6", s6), ("S7", s7))}
        out[key] = {name: float(np.median(values)) for name, values in row.items()}
        out[key] |= {f"{name}/S5": float(np.median(row[name] / row["S5"])) for name in ("S6", "S7")}
    return out


def cost_us(rounds: int = 5) -> dict[str, float]:
    """CPU time of a whole cycle of the closed loop, microseconds, without and with the estimator: S7 without
    its fault flies S4's flight."""
    out: dict[str, float] = {}
    for name in ("S4", "S7-healthy"):
        job = Job(name, 1, NOMINAL)
        times = []
        for _ in range(rounds):
            begin = time.process_time()
            cycles = len(fly(job).log)
            times.append((time.process_time() - begin) / cycles * 1e6)
        out[name] = float(min(times))
    return out


def _quantile(values: np.ndarray, q: float) -> float | None:
    if not len(values):
        return None
    value = float(np.quantile(values, q, method="higher"))
    return value if np.isfinite(value) else None
