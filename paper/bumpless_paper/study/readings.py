"""The goals under the other readings of what the paper leaves open, shown beside the primary ones.

A reading puts another figure in the place of the primary one, or another scenario in the place of a
baseline. What each figure is: `study.figures`; the variants of S1 and S3: `study.scenarios`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from bumpless_paper.study.goals import GOALS, Goal


@dataclass(frozen=True)
class Reading:
    """Figures and scenarios by the primary name -> the one that takes its place."""

    name: str
    figures: Mapping[str, str] = field(default_factory=dict)
    scenarios: Mapping[str, str] = field(default_factory=dict)

    def of(self, goal: Goal) -> Goal | None:
        """The goal under this reading; None where the reading does not touch it."""
        read = replace(
            goal,
            figure=self.figures.get(goal.figure, goal.figure),
            of=self.scenarios.get(goal.of, goal.of),
            over=self.scenarios.get(goal.over, goal.over),
            about=f"{goal.about}; {self.name}",
        )
        return None if (read.figure, read.of, read.over) == (goal.figure, goal.of, goal.over) else read


def _steps(kind: str) -> dict[str, str]:
    return {f"d_u_{switch}_bound": f"d_u_{switch}_{kind}" for switch in ("FR", "RH")}


# What the primary figures are, in the words of the report.
PRIMARY: dict[str, str] = {
    "d_u": "commands over their bounds, 2 s either side of the run's own first switch",
    "rms_e_tau_model": "tau_c by the allocator's map, all cycles",
    "rms_e_tau_post": "tau_c as the plant's true wrench, from the fault to the end",
    "d_theta": "RMS about the reference, from the fault to the end",
    "d_psi": "RMS about the reference, from the fault to the end",
    "r_sat": "share of cycles with any command at an amplitude bound",
}

BASELINES = {"S1": ("S1 maps the demand in thrust",), "S3": ("S3 keeps e_I, so that K_I e_I jumps",)}

NO_FAULT = "no fault at all, S4 in the place of S6"

READINGS: tuple[Reading, ...] = (
    Reading("tau_c as the plant's true wrench", {"rms_e_tau_model": "rms_e_tau_true"}),
    Reading("tau_c by the allocator's map", {"rms_e_tau_post_true": "rms_e_tau_post_model"}),
    Reading("d_u in thrust", _steps("thrust")),
    Reading("d_u in mixed degrees and rpm", _steps("mixed")),
    Reading("window of 1 s either side", _steps("1s")),
    Reading("window from the switch to 15 s after it", _steps("15s")),
    Reading("increment bound counted as saturation", {"r_sat": "r_sat_increment"}),
    Reading("S1 maps the demand straight to shaft speed", scenarios={"S1": "S1-rpm"}),
    Reading("S3 keeps K_I e_I in newtons", scenarios={"S3": "S3-keep"}),
    Reading("S3 resets its integrals", scenarios={"S3": "S3-reset"}),
    Reading("peak deviation", {f"d_{a}_fault_rms": f"d_{a}_fault_peak" for a in ("theta", "psi")}),
    Reading("RMS of 10 s from the fault", {f"d_{a}_fault_rms": f"d_{a}_fault_10s" for a in ("theta", "psi")}),
    Reading(
        "moved since the fault, whatever the reference",
        {f"d_{a}_fault_rms": f"d_{a}_fault_moved" for a in ("theta", "psi")},
    ),
    Reading(NO_FAULT, scenarios={"S6": "S4"}),
)


def primary_definition(goal: Goal) -> str:
    """How the figure of a goal is defined here."""
    text = next(text for start, text in PRIMARY.items() if goal.figure.startswith(start))
    return "; ".join((text, *BASELINES.get(goal.over, ())))


def readings_of(goal: Goal) -> list[tuple[str, Goal]]:
    """(name of the reading, the goal under it) for each reading that touches the goal."""
    return [(reading.name, read) for reading in READINGS if (read := reading.of(goal)) is not None]


def scenarios_of(goals: Sequence[Goal] = GOALS, readings: bool = True) -> tuple[str, ...]:
    """Scenarios that must fly for these goals, with or without their other readings, in order of name."""
    wanted = [*goals, *(read for goal in goals if readings for _, read in readings_of(goal))]
    return tuple(sorted({name for goal in wanted for name in (goal.of, goal.over)}))
