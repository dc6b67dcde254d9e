"""Figures of merit of one flown run: pure functions of what was logged.

`Columns` holds what they need, in SI and radians; `metrics_of` gives every figure as the contract's
`Metrics`, the same from a simulation's LOG array and from a recorded file.
"""

from bumpless.metrics.columns import Columns
from bumpless.metrics.figures import Figures, figures_of
from bumpless.metrics.outcome import Ending, Outcome, outcome_of
from bumpless.metrics.summary import as_dict, metrics_of

__all__ = ["Columns", "Ending", "Figures", "Outcome", "as_dict", "figures_of", "metrics_of", "outcome_of"]
