"""The part of the parameters that may change in flight, as the contract's message, and back onto a base.

Which fields that is the declarations say (`live=True`); the message has a field of the same name for each.
"""

from typing import TYPE_CHECKING, Any, cast

from bumpless.config.declare import Broken, Unread, as_table, fields_of, read, unknown
from bumpless.config.parameters.load import with_overrides
from bumpless.config.parameters.model import Parameters
from bumpless.config.problems import Problem

if TYPE_CHECKING:
    from bumpless.contract import bumpless_pb2


def live_fields() -> dict[str, list[str]]:
    """Keys that may change in flight, by section."""
    sections = {
        name: [key for key, field in fields_of(section.kind).items() if field.note.live]
        for name, section in fields_of(Parameters).items()
    }
    return {name: keys for name, keys in sections.items() if keys}


def to_message(parameters: Parameters) -> "bumpless_pb2.Parameters":
    """What may change in flight as `bumpless.Parameters`."""
    from bumpless.contract import bumpless_pb2

    message = bumpless_pb2.Parameters()
    for name, keys in live_fields().items():
        table, target = as_table(getattr(parameters, name)), getattr(message, name)
        for key in keys:
            if isinstance(table[key], list):
                getattr(target, key).extend(table[key])
            else:
                setattr(target, key, table[key])
    return message


def from_message(message: "bumpless_pb2.Parameters", base: Parameters) -> Parameters:
    """`base` with every section that the message carries laid over it.

    Raises ParameterError for numbers out of their range; `check`, for rules between them, comes after.
    """
    tables: dict[str, dict[str, Any]] = {}
    for name, keys in live_fields().items():
        if message.HasField(name):  # type: ignore[arg-type]
            source = getattr(message, name)
            tables[name] = {key: _plain(getattr(source, key)) for key in keys}
    return with_overrides(base, tables)


def live_problems(given: Any) -> list[Problem]:
    """What is wrong with a whole set of live parameters as nested plain values; none may be absent."""
    if not isinstance(given, dict):
        return [Problem("", None, None, "", given, "must be an object of parameters")]
    live, sections = live_fields(), cast("dict[Any, Any]", given)
    found = [Broken(str(name), None, unknown(name, live)) for name in sections if name not in live]
    for name, keys in live.items():
        if name not in sections:
            found.append(Broken(name, None, "is missing"))
            continue
        wanted = _without_others(name, keys, sections[name])
        found += [Broken(f"{name}.{one.path}" if one.path else name, one.value, one.rule) for one in wanted]
    return [Problem("", None, None, *one) for one in found]


def _without_others(name: str, keys: list[str], table: Any) -> list[Broken]:
    """What is wrong with the live part of a section; the fields that are not live are no part of it."""
    model = fields_of(Parameters)[name].kind
    others = [key for key in fields_of(model) if key not in keys]
    known = cast("dict[Any, Any]", table) if isinstance(table, dict) else None
    strangers = [key for key in known if key in others] if known else []
    found = [Broken(key, (known or {})[key], "may not change in flight") for key in strangers]
    try:
        read(model, table)
    except Unread as error:
        found += [one for one in error.broken if one.path not in others]
    missing = [key for key in keys if known is not None and key not in known]
    told = {one.path for one in found}
    return found + [Broken(key, None, "is missing") for key in missing if key not in told]


def _plain(value: Any) -> Any:
    return value if isinstance(value, bool | int | float) else list(value)
