"""Is this set of parameters fit to fly with? Rules between numbers, and between numbers and the vehicle.

That each number is within its own range is certain: `Parameters` can't be made otherwise.
"""

from collections.abc import Iterator
from itertools import pairwise

from bumpless.config.declare import Row, fields_of
from bumpless.config.parameters.load import Tuned
from bumpless.config.parameters.model import Parameters
from bumpless.config.problems import Problem

_ASCENDING = (
    "range_rh_lower_m",
    "range_rh_upper_m",
    "range_fr_lower_m",
    "range_fr_upper_m",
    "range_hf_upper_m",
)


def check(parameters: Parameters, vehicle: Tuned, source: str = "") -> list[Problem]:
    """Every broken rule; an empty list when the parameters are fit for this vehicle.

    `source` is the file name the problems carry, if there is one.
    """
    found = (*_check_rows(parameters, len(vehicle.commands)), *_check_supervisor(parameters))
    return [Problem(source, None, None, field, value, rule) for field, value, rule in found]


def _check_rows(parameters: Parameters, n_u: int) -> Iterator[tuple[str, object, str]]:
    """Rows with one number per command."""
    for name, section in fields_of(Parameters).items():
        for key, field in fields_of(section.kind).items():
            if not isinstance(field.note, Row) or field.note.names:
                continue
            row = getattr(getattr(parameters, name), field.name)
            if len(row) != n_u:
                yield f"{name}.{key}", list(row), f"must have {n_u} numbers, one per command"


def _check_supervisor(parameters: Parameters) -> Iterator[tuple[str, object, str]]:
    """d_RH^L < d_RH^U < d_FR^L < d_FR^U < d_HF^U, and M of N: what eq. (53) needs."""
    supervisor = parameters.supervisor
    for lower, upper in pairwise(_ASCENDING):
        low, high = getattr(supervisor, lower), getattr(supervisor, upper)
        if not low < high:
            yield f"supervisor.{upper}", high, f"must be greater than {lower} ({low:g})"
    if supervisor.detection_hits > supervisor.detection_window:
        rule = f"must not exceed detection_window ({supervisor.detection_window})"
        yield "supervisor.detection_hits", supervisor.detection_hits, rule
