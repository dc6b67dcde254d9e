"""Figures of merit of one flown run: pure functions of what was logged.

`Run` holds the columns they need, in SI and radians; `metrics_of` gives every figure as the contract's
`Metrics`, the same from a simulation's LOG array and from a recorded file.
"""

from bumpless.metrics.run import Run
from bumpless.metrics.summary import as_dict, metrics_of

__all__ = ["Run", "as_dict", "metrics_of"]
