"""What the controller is tuned with: the numbers, where they come from, and what they may be.

`default_parameters` reads them from the vehicle file, `with_overrides` lays a mission's on top,
`check` holds them against each other and the vehicle, `to_message` and `from_message` carry the part
that may change during a mission over the bus.
"""

from bumpless.config.parameters.allocation import AllocationParameters
from bumpless.config.parameters.checks import check
from bumpless.config.parameters.docking import DockingParameters
from bumpless.config.parameters.guidance import GuidanceParameters
from bumpless.config.parameters.load import ParameterError, as_dict, default_parameters, with_overrides
from bumpless.config.parameters.messages import from_message, live_fields, live_problems, to_message
from bumpless.config.parameters.model import Parameters
from bumpless.config.parameters.modes import ModeParameters
from bumpless.config.parameters.ranges import RANGES, Range
from bumpless.config.parameters.supervisor import SupervisorParameters
from bumpless.config.parameters.switching import BumplessParameters

__all__ = [
    "RANGES",
    "AllocationParameters",
    "BumplessParameters",
    "DockingParameters",
    "GuidanceParameters",
    "ModeParameters",
    "ParameterError",
    "Parameters",
    "Range",
    "SupervisorParameters",
    "as_dict",
    "check",
    "default_parameters",
    "from_message",
    "live_fields",
    "live_problems",
    "to_message",
    "with_overrides",
]
