"""A parameter by its path: `hover.lambda`, or `hover.kd[5]` for one number of a row."""

import difflib
import re
from collections.abc import Mapping
from typing import Any

from bumpless.config.parameters import Parameters, as_dict

_PATH = re.compile(r"(\w+)\.(\w+)(?:\[(\d+)\])?")


def changes_of(parameters: Parameters, values: Mapping[str, float]) -> dict[str, dict[str, Any]]:
    """Overrides as `with_overrides` takes them. Raises ValueError for a path that leads nowhere."""
    tables = as_dict(parameters)
    changes: dict[str, dict[str, Any]] = {}
    for path, value in values.items():
        found = _PATH.fullmatch(path)
        if found is None:
            raise ValueError(f"{path}: must be section.key or section.key[index]")
        section, key, index = found.groups()
        if section not in tables or key not in tables[section]:
            raise ValueError(f"{path}: no such parameter{_near(path, tables)}")
        table = changes.setdefault(section, {})
        before = table.get(key, tables[section][key])
        if index is None:
            table[key] = round(value) if isinstance(before, int) and not isinstance(before, bool) else value
            continue
        if not isinstance(before, list) or int(index) >= len(before):
            raise ValueError(f"{path}: no such number in the row")
        table[key] = [value if k == int(index) else old for k, old in enumerate(before)]
    return changes


def _near(path: str, tables: Mapping[str, Mapping[str, Any]]) -> str:
    known = [f"{section}.{key}" for section, table in tables.items() for key in table]
    near = difflib.get_close_matches(path.partition("[")[0], known, n=1)
    return f"; did you mean {near[0]}?" if near else ""


def value_at(parameters: Parameters, path: str) -> float:
    """The number at a path. Raises ValueError for a path that leads nowhere."""
    found = _PATH.fullmatch(path)
    if found is None or changes_of(parameters, {path: 0.0}) is None:
        raise ValueError(f"{path}: no such parameter")
    section, key, index = found.groups()
    value = as_dict(parameters)[section][key]
    return value if index is None else value[int(index)]
