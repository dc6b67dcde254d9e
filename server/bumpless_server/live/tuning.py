"""Parameters on their way from the screen to the vehicle: complete, known to the contract, in range."""

from typing import Any

from google.protobuf import json_format

from bumpless.config.parameters import RANGES, check, default_parameters, from_message
from bumpless.config.problems import Problem, ProblemsError
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb


class TuningError(ProblemsError):
    """Parameters that are refused, with every problem found."""


def as_json(message: pb.Parameters) -> dict[str, Any]:
    """Parameters as JSON with proto names, zeros and False included."""
    return json_format.MessageToDict(
        message, preserving_proto_field_name=True, always_print_fields_with_no_presence=True
    )


def ranges() -> list[dict[str, Any]]:
    """What each live-tunable number may be, for the screen."""
    return [
        {"path": r.path, "unit": r.unit, "min": r.min, "max": r.max, "label": r.label, "count": r.count}
        for r in RANGES
        if r.live
    ]


def parse(given: Any, vehicle: Vehicle | None) -> pb.Parameters:
    """The message for a whole set of parameters; with a vehicle its ranges are checked as well.

    Raises TuningError.
    """
    if not isinstance(given, dict):
        raise TuningError([Problem("", None, None, "", given, "must be an object of parameters")])
    problems = _shape(given, pb.Parameters.DESCRIPTOR, "")
    if problems:
        raise TuningError(problems)
    message = pb.Parameters()
    try:
        json_format.ParseDict(given, message)
    except (json_format.ParseError, OverflowError) as error:
        raise TuningError([Problem("", None, None, "", None, str(error))]) from error
    if vehicle is not None:
        problems = check(from_message(message, default_parameters(vehicle)), vehicle)
        if problems:
            raise TuningError(problems)
    return message


def _shape(given: dict[str, Any], kind: Any, path: str) -> list[Problem]:
    """Missing and unknown fields of a message descriptor: an absent number would become zero unnoticed."""
    prefix = f"{path}." if path else ""
    known = {field.name: field for field in kind.fields}
    found = [
        Problem("", None, None, prefix + name, None, "is not a parameter")
        for name in given
        if name not in known
    ]
    for name, field in known.items():
        if name not in given:
            found.append(Problem("", None, None, prefix + name, None, "is missing"))
        elif field.message_type is not None:
            if isinstance(given[name], dict):
                found += _shape(given[name], field.message_type, prefix + name)
            else:
                found.append(Problem("", None, None, prefix + name, given[name], "must be an object"))
    return found
