"""What a file declared, as plain data again: for its identity and for the manifest."""

from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Any

from bumpless.config.declare import as_table


def plain(value: Any) -> Any:
    """Tables, lists and values, as JSON holds them."""
    if is_dataclass(value):
        return plain(as_table(value))
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return value
