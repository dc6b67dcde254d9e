"""Plain tables in and out of the parameter dataclasses: the vehicle file's, a mission's, JSON's."""

from collections.abc import Mapping
from dataclasses import MISSING, Field, fields, replace
from typing import Any, Literal, get_args, get_origin

from bumpless.config.parameters.model import Parameters
from bumpless.config.problems import Problem, ProblemsError


class ParameterError(ProblemsError):
    """Parameters that can't be read: unknown or missing keys, wrong types, wrong choices."""


def default_parameters(vehicle: Any) -> Parameters:
    """Parameters of the vehicle file's control tables, `vehicle.control`.

    Keys that have a default in the dataclass may be left out.
    Raises ParameterError with every problem; fields are dotted paths such as `forward.kp`.
    """
    control: Mapping[str, Any] = vehicle.control
    problems: list[Problem] = []
    sections: dict[str, Any] = {}
    known = {section.name: section for section in fields(Parameters)}
    for name in control:
        if name not in known:
            problems.append(_problem(name, None, f"unknown section; one of {', '.join(known)}"))
    for name, section in known.items():
        table = control.get(name, {})
        if not isinstance(table, Mapping):
            problems.append(_problem(name, table, "must be a table"))
            continue
        values = _read_table(section.type, table, name, problems)
        missing = [f for f in _keys(section.type).values() if f.name not in values and _required(f)]
        problems += [_problem(f"{name}.{_key(f)}", None, "is missing") for f in missing]
        if not problems:
            sections[name] = section.type(**values)  # type: ignore[operator]
    if problems:
        raise ParameterError(problems)
    return Parameters(**sections)


def with_overrides(parameters: Parameters, overrides: Mapping[str, Any]) -> Parameters:
    """The same with some numbers replaced, `{"hover": {"lambda": 0.1}}`; raises ParameterError."""
    problems: list[Problem] = []
    known = {section.name: section for section in fields(Parameters)}
    changed: dict[str, Any] = {}
    for name, table in overrides.items():
        if name not in known:
            problems.append(_problem(name, None, f"unknown section; one of {', '.join(known)}"))
        elif not isinstance(table, Mapping):
            problems.append(_problem(name, table, "must be a table"))
        else:
            values = _read_table(known[name].type, table, name, problems)
            changed[name] = replace(getattr(parameters, name), **values)
    if problems:
        raise ParameterError(problems)
    return replace(parameters, **changed)


def as_dict(parameters: Parameters) -> dict[str, dict[str, Any]]:
    """Nested plain values with the keys of the files; `with_overrides` reads it back."""
    return {
        section.name: {
            _key(f): _plain(getattr(getattr(parameters, section.name), f.name))
            for f in fields(section.type)  # type: ignore[arg-type]
        }
        for section in fields(Parameters)
    }


def _read_table(cls: Any, table: Mapping[str, Any], path: str, problems: list[Problem]) -> dict[str, Any]:
    known = _keys(cls)
    values: dict[str, Any] = {}
    for key, raw in table.items():
        field = known.get(key)
        if field is None:
            problems.append(_problem(f"{path}.{key}", None, f"unknown field; one of {', '.join(known)}"))
            continue
        value, rule = _convert(field.type, raw)
        if rule:
            problems.append(_problem(f"{path}.{key}", raw, rule))
        else:
            values[field.name] = value
    return values


def _convert(kind: Any, raw: Any) -> tuple[Any, str]:
    """The value as `kind`, or the rule it breaks."""
    if kind is bool:
        return (raw, "") if isinstance(raw, bool) else (None, "must be true or false")
    if kind is int:
        whole = _is_number(raw) and float(raw).is_integer()
        return (int(raw), "") if whole else (None, "must be a whole number")
    if kind is float:
        return (float(raw), "") if _is_number(raw) else (None, "must be a number")
    if get_origin(kind) is Literal:
        choices = get_args(kind)
        return (raw, "") if raw in choices else (None, f"must be one of {', '.join(choices)}")
    if not isinstance(raw, list | tuple) or not all(_is_number(item) for item in raw):
        return None, "must be a list of numbers"
    return tuple(float(item) for item in raw), ""


def _is_number(raw: Any) -> bool:
    if isinstance(raw, int) and raw.bit_length() >= 1024:
        return False  # too large for a float
    return isinstance(raw, int | float) and not isinstance(raw, bool)


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _key(field: Field[Any]) -> str:
    return field.name.rstrip("_")  # `lambda` is a word of Python


def _keys(cls: Any) -> dict[str, Field[Any]]:
    return {_key(field): field for field in fields(cls)}


def _required(field: Field[Any]) -> bool:
    return field.default is MISSING


def _problem(field: str, value: Any, rule: str) -> Problem:
    return Problem("", None, None, field, value, rule)
