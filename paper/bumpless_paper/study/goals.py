"""What the study sets out to reach, each as one ratio of two scenarios' figures and its limit.

Source of the limits: issue "True", section "The paper"; `paper` is the published ratio.
A goal holds on a plant when the ratio is finite and at most the limit.
"""

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from bumpless_paper.study.figures import Figures

TOLERANCE = 1e-9  # of figures that are both zero, such as r_sat


@dataclass(frozen=True)
class Goal:
    """`figure` of scenario `of` over the same of scenario `over`, at most `limit`."""

    name: str
    of: str
    over: str
    figure: str
    limit: float
    paper: float
    about: str

    def ratio(self, figures: Mapping[str, Figures]) -> float:
        """Of one plant's figures by scenario; NaN where a scenario never came that far."""
        return (figures[self.of][self.figure] + TOLERANCE) / (figures[self.over][self.figure] + TOLERANCE)

    def holds(self, figures: Mapping[str, Figures]) -> bool:
        """Is it reached on this plant?"""
        ratio = self.ratio(figures)
        return math.isfinite(ratio) and ratio <= self.limit + 1e-6

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)


GOALS: tuple[Goal, ...] = (
    Goal("d_u,FR S3->S4", "S4", "S3", "d_u_FR_bound", 0.10, 1 - 0.8117, "bumpless against hard, F to R"),
    Goal("d_u,RH S3->S4", "S4", "S3", "d_u_RH_bound", 0.20, 1 - 0.6253, "bumpless against hard, R to H"),
    Goal("e_tau S1->S4", "S4", "S1", "rms_e_tau_model", 0.20, 1 - 0.7178, "allocation against none"),
    Goal("S4<=S2 e_tau", "S4", "S2", "rms_e_tau_model", 1.0, 1.0719 / 0.7836, "no worse than pseudo-inverse"),
    Goal("S4<=S2 r_sat", "S4", "S2", "r_sat", 1.0, 1.0000 / 0.9995, "no worse than pseudo-inverse"),
    Goal("S4<=S2 d_u,FR", "S4", "S2", "d_u_FR_bound", 1.0, 0.9044 / 0.5817, "no worse than pseudo-inverse"),
    Goal("S4<=S2 d_u,RH", "S4", "S2", "d_u_RH_bound", 1.0, 0.0978 / 0.1212, "no worse than pseudo-inverse"),
    Goal("e_tau S5->S6", "S6", "S5", "rms_e_tau_post_true", 0.80, 1 - 0.1188, "after the fault"),
    Goal("pitch S5->S6", "S6", "S5", "d_theta_fault_rms", 0.85, 1 - 0.0916, "after the fault"),
    Goal("yaw S5->S6", "S6", "S5", "d_psi_fault_rms", 1.0, 1 + 0.47, "after the fault"),
)


def goal_named(name: str) -> Goal:
    """The goal of a name."""
    return next(goal for goal in GOALS if goal.name == name)
