"""Is this set of parameters fit to fly with? Ranges, row lengths, and rules between numbers."""

import math
from itertools import pairwise
from typing import Any

from bumpless.config.parameters.load import as_dict
from bumpless.config.parameters.model import Parameters
from bumpless.config.parameters.ranges import ACTUATORS, RANGES, Range
from bumpless.config.problems import Problem

_ASCENDING = (
    "range_rh_lower_m",
    "range_rh_upper_m",
    "range_fr_lower_m",
    "range_fr_upper_m",
    "range_hf_upper_m",
)


def check(parameters: Parameters, vehicle: Any, source: str = "") -> list[Problem]:
    """Every broken rule; an empty list when the parameters are fit for this vehicle.

    `source` is the file name the problems carry, if there is one.
    """
    tree = as_dict(parameters)
    found: list[tuple[str, object, str]] = []
    for rule in RANGES:
        section, key = rule.path.split(".")
        found += _check_range(rule, tree[section][key], len(vehicle.commands))
    found += _check_order(parameters)
    return [Problem(source, None, None, field, value, rule) for field, value, rule in found]


def _check_range(rule: Range, value: Any, n_u: int) -> list[tuple[str, object, str]]:
    if rule.count == 0:
        return _check_number(rule, rule.path, value)
    count = n_u if rule.count == ACTUATORS else rule.count
    if len(value) != count:
        per = {ACTUATORS: "one per command", 6: "one for each of X Y Z K M N"}.get(rule.count, "")
        text = f"must have {count} numbers" + (f", {per}" if per else "")
        return [(rule.path, list(value), text)]
    return [p for i, item in enumerate(value) for p in _check_number(rule, f"{rule.path}[{i}]", item)]


def _check_number(rule: Range, path: str, value: float) -> list[tuple[str, object, str]]:
    if math.isfinite(value) and rule.min <= value <= rule.max:
        return []
    unit = "" if rule.unit == "1" else f" {rule.unit}"
    return [(path, value, f"must be between {rule.min:g} and {rule.max:g}{unit}")]


def _check_order(parameters: Parameters) -> list[tuple[str, object, str]]:
    """d_RH^L < d_RH^U < d_FR^L < d_FR^U < d_HF^U, and M of N. Source: Gao et al. 2026, eq. (53)."""
    supervisor = parameters.supervisor
    found: list[tuple[str, object, str]] = []
    for lower, upper in pairwise(_ASCENDING):
        low, high = getattr(supervisor, lower), getattr(supervisor, upper)
        if not low < high:
            found.append((f"supervisor.{upper}", high, f"must be greater than {lower} ({low:g})"))
    if supervisor.detection_hits > supervisor.detection_window:
        rule = f"must not exceed detection_window ({supervisor.detection_window})"
        found.append(("supervisor.detection_hits", supervisor.detection_hits, rule))
    return found
