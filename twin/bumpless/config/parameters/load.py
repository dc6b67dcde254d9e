"""Plain tables in and out of the parameters: the vehicle file's, a mission's, JSON's."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Protocol, cast

from bumpless.config.declare import Broken, Unread, as_table, fields_of, read, unknown
from bumpless.config.parameters.model import Parameters
from bumpless.config.problems import Problem, ProblemsError


class ParameterError(ProblemsError):
    """Parameters that can't be read: unknown or missing keys, wrong types, numbers out of range."""


class Tuned(Protocol):
    """What must be known of a vehicle to read and check its parameters."""

    @property
    def control(self) -> Mapping[str, Any]:
        """The raw tables of its file."""
        ...

    @property
    def commands(self) -> Sequence[Any]:
        """One entry for each number that its actuators are told."""
        ...

    def problem(self, path: str, value: Any, rule: str) -> Problem:
        """A broken rule at its place in the vehicle's files."""
        ...


def default_parameters(vehicle: Tuned) -> Parameters:
    """Parameters of the vehicle file's control tables, `vehicle.control`.

    Keys that have a default in the declaration may be left out.
    Raises ParameterError with every problem; fields are dotted paths such as `forward.kp`.
    """
    tables: dict[str, Any] = {section: dict[str, Any]() for section in fields_of(Parameters)}
    tables.update(vehicle.control)
    try:
        return read(Parameters, tables)
    except Unread as error:
        broken = error.broken
    problems = [vehicle.problem(f"control.{path}", value, rule) for path, value, rule in broken]
    raise ParameterError(
        replace(problem, field=one.path) for problem, one in zip(problems, broken, strict=True)
    )


def with_overrides(parameters: Parameters, overrides: Mapping[str, Any]) -> Parameters:
    """The same with some numbers replaced, `{"hover": {"lambda": 0.1}}`; raises ParameterError."""
    broken: list[Broken] = []
    changed: dict[str, Any] = {}
    known = fields_of(Parameters)
    for name, table in overrides.items():
        if name not in known:
            broken.append(Broken(str(name), None, unknown(name, known)))
        elif not isinstance(table, Mapping):
            broken.append(Broken(name, table, "must hold named fields"))
        else:
            present, given = getattr(parameters, name), cast("Mapping[str, Any]", table)
            try:
                changed[name] = read(cast("type[Any]", type(present)), as_table(present) | dict(given))
            except Unread as error:
                broken += [Broken(f"{name}.{one.path}", one.value, one.rule) for one in error.broken]
    if broken:
        raise ParameterError(Problem("", None, None, *one) for one in broken)
    return replace(parameters, **changed)


def as_dict(parameters: Parameters) -> dict[str, dict[str, Any]]:
    """Nested plain values with the keys of the files; `with_overrides` reads it back."""
    return {name: as_table(section) for name, section in as_table(parameters).items()}
