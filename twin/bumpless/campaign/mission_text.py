"""A mission back as the text of a mission file, so that a drawn flight can be kept and flown by itself."""

import io
from dataclasses import asdict
from typing import Any

from ruamel.yaml import YAML

from bumpless.config.mission import Mission

_INTERNAL = ("source", "text")


def mission_text(mission: Mission) -> str:
    """YAML that `parse_mission` reads back to an equal mission, but for its source and text."""
    return as_yaml({key: value for key, value in asdict(mission).items() if key not in _INTERNAL})


def as_yaml(table: dict[str, Any]) -> str:
    """YAML of plain data."""
    out = io.StringIO()
    yaml = YAML(typ="safe", pure=True)
    yaml.default_flow_style = None
    yaml.sort_base_mapping_type_on_output = False  # type: ignore[attr-defined]
    yaml.dump(_plain(table), out)
    return out.getvalue()


def _plain(value: Any) -> Any:
    """Lists for tuples; fields that say nothing are left out."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items() if item is not None}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value
