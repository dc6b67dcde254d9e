"""Packages that only some installations have, and the sentence that says which extra brings one."""

import importlib
from types import ModuleType


class ExtraMissing(ImportError):
    """A package that this installation lacks; the text says what to install."""


def imported(module: str, extra: str) -> ModuleType:
    """The module, which the extra of that name brings. Raises ExtraMissing."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise missing(error, extra) from error


def missing(error: ModuleNotFoundError, extra: str) -> ExtraMissing:
    """What to say when `error` was raised by an import that needs `extra`."""
    name = (error.name or "a package").partition(".")[0]
    return ExtraMissing(f"this needs {name}, which is not installed: pip install 'bumpless[{extra}]'")
