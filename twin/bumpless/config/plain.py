"""What a plain value from YAML, TOML or JSON is, told to the type checker too.

`isinstance(value, dict)` leaves open what the table holds; these say that it may be anything.
"""

from typing import Any, TypeGuard


def is_table(value: Any) -> TypeGuard[dict[str, Any]]:
    """Named fields."""
    return isinstance(value, dict)


def is_list(value: Any) -> TypeGuard[list[Any]]:
    """A list, as files give it."""
    return isinstance(value, list)


def is_tuple(value: Any) -> TypeGuard[tuple[Any, ...]]:
    """A row as models hold it."""
    return isinstance(value, tuple)


def is_row(value: Any) -> TypeGuard[list[Any] | tuple[Any, ...]]:
    """A list or a row."""
    return isinstance(value, list | tuple)
