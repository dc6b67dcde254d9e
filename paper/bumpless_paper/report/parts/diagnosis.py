"""S7: how soon, how surely and how well the autopilot finds a fault that nobody tells it of."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from bumpless.sim.twin import Result
from bumpless_paper.report.content import Figure, Grid, Panel, Part, Series
from bumpless_paper.report.labels import label
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.flights import TIME, spans_of
from bumpless_paper.report.parts.robustness import PLANTS
from bumpless_paper.report.parts.study import counted, study_hashes
from bumpless_paper.report.ticks import change, number, share
from bumpless_paper.study.detection import detection_of
from bumpless_paper.study.diagnosis import run
from bumpless_paper.study.fly import FAULT_TIME_S, Job, fly

TEXT = (
    "The propeller's fault of S5 and S6, but the autopilot is not told. It predicts momentum with the "
    "nominal model, learns what that leaves over (trim, buoyancy, drag, noise), and asks by likelihood ratio "
    "which actuator's loss would explain what is new; then it reconfigures as S6 does. It uses measured "
    "velocity and rates, actuator feedback, and its own estimates of attitude and current."
)
NOTES = (
    "Delay: from the moment the fault begins (it comes in over 2 s) to the diagnosis. A fault not found by "
    "the end of the flight counts as an infinite delay. Error: mean |estimated − true effectiveness| from "
    "5 s after the diagnosis on.",
    "What is not excited cannot be judged: a fin at rest or without flow over it, a thruster that stands "
    "still. The evidence of fins counts 0.4 of what it says, for the flow over them is only estimated.",
    "For the first 10 s trim and drag are learnt and no fault is raised; one that is there from the start "
    "shows when the use of its actuator changes.",
    "The plant's fault scales an actuator's whole wrench, shaft torque included, and leaves its feedback "
    "right: the estimator takes it so. A nominal map that is wrong by a tenth is already near what it calls "
    "a fault.",
)


def part(progress: Progress) -> Part:
    """Fly S7 with five seeds, on the tuned and the unseen plants, on other actuators and in other modes."""
    answer = run(PLANTS, counted(progress, 0.0, 0.98))
    flight = fly(Job("S7"))
    progress(1.0)
    return part_of(answer, flight, PLANTS)


def part_of(answer: Mapping[str, Any], flight: Result, plants: int) -> Part:
    """The chapter of what `bumpless_paper.study.diagnosis.run` found, with one flight of S7 as its figure."""
    tuned, unseen = answer["tuned"], answer["unseen"]
    false, hours = (tuned[k] + unseen[k] for k in ("false_alarms", "healthy_hours"))
    return Part(
        "diagnosis",
        "Finding the fault (S7)",
        TEXT,
        [_found(answer), _where(answer["where"]), _maps(answer["wrong_map"]), _figures(answer, plants)],
        [_figure(flight)],
        notes=[*NOTES, _cost(answer["cost_us"])],
        numbers={
            "plants": plants,
            **{k: answer[k] for k in ("nominal", "tuned", "unseen", "nominal_figures", "plant_figures")},
            "false_alarms": false,
            "healthy_hours": hours,
            "cost_us": answer["cost_us"],
        },
        hashes=study_hashes(("S7",)),
    )


def _cost(cost: Mapping[str, float]) -> str:
    return (
        f"A cycle of the closed loop took {number(cost['S7-healthy'], 3)} µs of CPU time with the estimator "
        f"and {number(cost['S4'], 3)} µs without, on this machine in a hot loop and on the very same flight."
    )


def _row(what: str, s: Mapping[str, Any]) -> list[Any]:
    return [
        what,
        f"{s['found']} of {s['flights']}",
        share(s["isolated"] / s["found"] if s["found"] else None),
        _or_never(s["delay_s"]["median"]),
        _or_never(s["delay_s"]["q90"]),
        number(s["error"]["median"], 2),
        number(s["error"]["q90"], 2),
    ]


def _or_never(seconds: float | None) -> str:
    return "not found" if seconds is None else number(seconds, 3)


_COLUMNS = ("found", "named rightly", "delay, median (s)", "delay, 90 % (s)", "error, median", "error, 90 %")


def _found(answer: Mapping[str, Any]) -> Grid:
    rows = []
    for plants, key in (
        ("nominal plant, 5 seeds", "nominal"),
        ("plants it was tuned on", "tuned"),
        ("plants it never saw", "unseen"),
    ):
        s = answer[key]
        rows.append([*_row(plants, s), s["false_alarms"], number(s["healthy_hours"], 3)])
    return Grid(
        "diagnosis",
        "The propeller's fault, found",
        "False alarms: diagnoses of an actuator that was whole, in these flights and in as many without any "
        "fault on the same plants; hours are those without a fault.",
        ["", *_COLUMNS, "false alarms", "in hours"],
        rows,
    )


def _where(where: list[dict[str, Any]]) -> Grid:
    return Grid(
        "diagnosis_where",
        "Which actuator, in which mode",
        "Effectiveness 0.4 of one actuator, coming at 20 s, 32 s or 56 s on ten drawn plants; the delay may "
        "reach into later modes. A single fin in cruise is used by a fraction of a degree.",
        ["fault", *_COLUMNS],
        [_row(f"{row['actuator']}, {row['mode']}", row) for row in where],
    )


def _maps(rows: list[dict[str, Any]]) -> Grid:
    return Grid(
        "diagnosis_maps",
        "No fault, but a nominal map that is wrong",
        "All thrusters or all fins of the plant differ from the model; ten drawn plants.",
        ["plant", "false alarms", "in hours"],
        [[row["map"], row["false_alarms"], number(row["healthy_hours"], 3)] for row in rows],
    )


def _figures(answer: Mapping[str, Any], plants: int) -> Grid:
    rows = []
    for where, key in (("nominal, 5 seeds", "nominal_figures"), (f"{plants} plants", "plant_figures")):
        for name, row in answer[key].items():
            told, estimated = change(row["S6/S5"]), change(row["S7/S5"])
            rows.append(
                [f"{where}: {label(name)}", *(number(row[s], 3) for s in ("S5", "S6", "S7")), told, estimated]
            )
    return Grid(
        "diagnosis_figures",
        "After the fault: ignorant, told, finding out",
        "Medians, and the median change from S5 flight by flight; N and N m, rad.",
        ["", "S5", "S6", "S7", "S5→S6", "S5→S7"],
        rows,
    )


def _figure(run: Result) -> Figure:
    log, time = run.log, run.log["time"]
    found = detection_of(run)
    names = [command.name for command in run.vehicle.commands]
    i = int(np.argmin(log["effectiveness"][-1, : len(names)]))
    marks = [(FAULT_TIME_S, "fault"), (found.fault_at_s + found.delay_s, "found")]
    effectiveness = [
        Series("true", time, log["effectiveness"][:, i], 5, "dash"),
        Series("estimated", time, log["effectiveness_hat"][:, i], 0),
    ]
    evidence = [Series(name, time, log["fault_evidence"][:, k], k % 6) for k, name in enumerate(names)]
    residual = [Series(c, time, log["unexplained"][:, k], k) for k, c in enumerate("XYZ")]
    return Figure(
        "s7_diagnosis",
        "S7: the fault as the autopilot sees it",
        "Effectiveness of the propeller; log-likelihood ratio of a loss of each actuator against none; the "
        "force that the model leaves unexplained, which holds trim and buoyancy, takes in the loss until it "
        "is found, and then gives it up.",
        [
            Panel(TIME, f"effectiveness of {names[i]}", effectiveness, spans_of(log), marks),
            Panel(TIME, "evidence", evidence, spans_of(log), marks),
            Panel(TIME, "unexplained force (N)", residual, spans_of(log), marks),
        ],
    )
