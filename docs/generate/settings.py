"""The server's settings, from the model that reads them."""

from pathlib import Path
from typing import Any

from pydantic.fields import FieldInfo

from bumpless_server.settings import PREFIX, Settings
from docs.generate.markdown import NOTE, code, table

HEAD = """# Settings

Every setting of the server. Set it in the environment by the name in the first column; `bumpless serve` has
an option for the common ones (see [Commands](cli.md)). An option wins over the environment. A name that does
not exist is refused with the nearest one that does. A list is written `a,b`.

"""


def page() -> str:
    """Markdown: one row per setting."""
    rows = [
        (code(PREFIX + name.upper()), kind(field), code(default(field)), field.description or "")
        for name, field in Settings.model_fields.items()
    ]
    return NOTE + HEAD + table(("setting", "what it may be", "default", "what it does"), rows)


def kind(field: FieldInfo) -> str:
    """The type and the bounds of a setting, in words."""
    words = {bool: "`true` or `false`", int: "whole number", float: "number", str: "text", Path: "path"}
    hint: Any = field.annotation
    options = getattr(hint, "__args__", ())
    if options and all(isinstance(option, str) for option in options):
        return " or ".join(code(option) for option in options)
    bounds = [
        f"{sign} {value:g}"
        for rule in field.metadata
        for attribute, sign in (("ge", "≥"), ("gt", ">"), ("le", "≤"), ("lt", "<"))
        if (value := getattr(rule, attribute, None)) is not None
    ]
    return ", ".join([words.get(hint, "list" if "tuple" in str(hint) else "text"), *bounds])


def default(field: FieldInfo) -> str:
    """The default as it would be written in the environment."""
    value = field.default
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, tuple):
        return ",".join(value)
    return "" if value is None else str(value)
