"""The library's public face, from its own `__all__`, signatures and docstrings."""

import inspect
from typing import Any

import bumpless
from docs.generate.markdown import NOTE

HEAD = """# Python

`import bumpless`: the names below are the library's open face, used by the command line, the server and the
tests alike. Everything else may change without a word.

"""


def names(module: Any = bumpless) -> list[str]:
    """The open names."""
    return list(getattr(module, "__all__", ()))


def page(module: Any = bumpless) -> str:
    """Markdown: a chapter per open name."""
    text = inspect.cleandoc(module.__doc__ or "")
    return (
        NOTE
        + HEAD
        + text
        + "\n\n"
        + "\n".join(_chapter(name, getattr(module, name)) for name in names(module))
    )


def _chapter(name: str, thing: Any) -> str:
    if not callable(thing):
        return f"## {name}\n\n`{thing!r}`\n"
    text = f"## {name}\n\n```python\n{name}{_signature(thing)}\n```\n\n{_words(thing)}\n"
    if inspect.isclass(thing):
        for member, value in vars(thing).items():
            if not member.startswith("_") and (
                inspect.isfunction(value) or isinstance(value, property | classmethod)
            ):
                text += f"\n### {name}.{member}\n\n" + _member(member, value)
    return text


def _member(name: str, value: Any) -> str:
    if isinstance(value, property):
        kind = inspect.signature(value.fget).return_annotation if value.fget else inspect.Signature.empty
        shown = f": {inspect.formatannotation(kind)}" if kind is not inspect.Signature.empty else ""
        return f"```python\n{name}{shown}\n```\n\n{_words(value)}\n"
    plain = value.__func__ if isinstance(value, classmethod) else value
    return f"```python\n{name}{_signature(plain)}\n```\n\n{_words(plain)}\n"


def _signature(thing: Any) -> str:
    declared = getattr(thing, "__pydantic_fields__", None)
    if declared:  # types, ranges and meanings stand in the pages of what people write
        return f"({', '.join(declared)})"
    try:
        return str(inspect.signature(thing)).replace("'", "")
    except (TypeError, ValueError):
        return "(...)"


def _words(thing: Any) -> str:
    return inspect.cleandoc(inspect.getdoc(thing) or "")
