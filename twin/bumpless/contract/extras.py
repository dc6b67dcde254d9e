"""Packages that only some installations have, and the sentence that says which extra brings them."""

import importlib
from importlib.util import find_spec
from types import ModuleType


class ExtraMissing(ImportError):
    """A package that this installation lacks; the text says what to install."""


def lack_of(extra: str, *modules: str) -> str:
    """One sentence when any of these modules is not installed; "" when all are."""
    gone = [name for name in modules if find_spec(name) is None]
    if not gone:
        return ""
    are = "is" if len(gone) == 1 else "are"
    return f"{', '.join(gone)} {are} not installed: pip install 'bumpless[{extra}]'"


def imported(module: str, extra: str) -> ModuleType:
    """The module, which the extra of that name brings. Raises ExtraMissing."""
    if lack := lack_of(extra, module):
        raise ExtraMissing(lack)
    return importlib.import_module(module)
