"""Drawn docking missions and what became of them, judged by the truth.

`draw_case(i)` is case i, always the same: mission, plant, sensors, sea. `judge` says how its flight ended.
Cases from HELD_OUT on are for reporting alone: nothing is tuned on them.
"""

from bumpless_paper.study.docks.cases import HELD_OUT, KINDS, Case, draw_case
from bumpless_paper.study.docks.judge import Judgement, judge
from bumpless_paper.study.docks.many import fly_case, fly_cases

__all__ = ["HELD_OUT", "KINDS", "Case", "Judgement", "draw_case", "fly_case", "fly_cases", "judge"]
