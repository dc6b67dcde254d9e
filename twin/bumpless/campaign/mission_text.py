"""A mission back as the text of a mission file, so that a drawn flight can be kept and flown by itself."""

from dataclasses import fields, is_dataclass
from typing import Any

import yaml

from bumpless.config.mission import Mission
from bumpless.config.mission.model import Document
from bumpless.config.yaml_text import scalar


class _Dumper(yaml.SafeDumper):
    """Texts that `yaml_text` would take for something else are quoted; nothing is shared by anchors."""

    def ignore_aliases(self, data: Any) -> bool:
        """Every value is written where it stands."""
        return True

    def text(self, value: str) -> yaml.Node:
        """A text that reads back as that text."""
        style = None if isinstance(scalar(value), str) else '"'
        return self.represent_scalar("tag:yaml.org,2002:str", value, style=style)


_Dumper.add_representer(str, _Dumper.text)


def mission_text(mission: Mission) -> str:
    """YAML that `parse_mission` reads back to an equal mission, but for its source and text."""
    return as_yaml({field.name: getattr(mission, field.name) for field in fields(Document)})


def as_yaml(table: dict[str, Any]) -> str:
    """YAML of plain data and of declared parts."""
    return yaml.dump(
        _plain(table), Dumper=_Dumper, sort_keys=False, default_flow_style=None, allow_unicode=True
    )


def _plain(value: Any) -> Any:
    """Lists for tuples; fields that say nothing are left out."""
    if is_dataclass(value) and not isinstance(value, type):
        return _plain({field.name: getattr(value, field.name) for field in fields(value)})
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items() if item is not None}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value
