"""Parameters on their way from the screen to the vehicle: complete, known to the contract, in range."""

from typing import Any

from google.protobuf import json_format

from bumpless.config.parameters import RANGES, check, default_parameters, from_message, live_problems
from bumpless.config.problems import ProblemsError
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb


class TuningError(ProblemsError):
    """Parameters that are refused, with every problem found."""


def ranges() -> list[dict[str, Any]]:
    """What each live-tunable number may be, for the screen."""
    return [
        {"path": r.path, "unit": r.unit, "min": r.min, "max": r.max, "label": r.label, "count": r.count}
        for r in RANGES
        if r.live
    ]


def parse(given: Any, vehicle: Vehicle | None) -> pb.Parameters:
    """The message for a whole set of live parameters; with a vehicle, rules between numbers hold as well.

    Raises TuningError.
    """
    problems = live_problems(given)
    if problems:
        raise TuningError(problems)
    message = json_format.ParseDict(given, pb.Parameters())
    if vehicle is not None:
        problems = check(from_message(message, default_parameters(vehicle)), vehicle)
        if problems:
            raise TuningError(problems)
    return message


def changes(before: Any, after: Any, within: str = "") -> dict[str, list[Any]]:
    """What differs between two sets as JSON: path -> [from, to]."""
    if isinstance(before, dict) and isinstance(after, dict):
        found: dict[str, list[Any]] = {}
        for name in before.keys() | after.keys():
            path = f"{within}.{name}" if within else str(name)
            found |= changes(before.get(name), after.get(name), path)
        return dict(sorted(found.items()))
    return {} if before == after else {within: [before, after]}
