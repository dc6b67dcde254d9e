"""Names that people give to uploaded files: safe in a path, in an address and on every system."""

import os
import stat
from pathlib import Path

from bumpless.contract.names import FILE, BadName, NameRule

__all__ = ["BadName", "checked_name", "why_no_file"]


def checked_name(name: str, *endings: str) -> str:
    """`name` without its ending (one of `endings`), if it may name a file. Raises BadName."""
    for ending in endings:
        name = name.removesuffix(ending)
    if not FILE.allows(name):
        raise BadName(f"name = {name!r}; must be {FILE.words}")
    return name


def why_no_file(path: Path, rule: NameRule = FILE, most_bytes: int | None = None) -> str:
    """Why an entry of a folder can't be offered as a file of ours; "" when it can. Opens nothing.

    A pipe would hang whoever opens it, a link to itself or an odd name would break a whole list. Raises
    FileNotFoundError when it is gone.
    """
    if not rule.allows(path.stem):
        return f"its name must be {rule.words}"
    try:
        found = os.stat(path)
    except FileNotFoundError:
        if path.is_symlink():
            return "it is a link to nothing"
        raise
    except OSError as error:
        return f"it cannot be looked at: {error.strerror}"
    if not stat.S_ISREG(found.st_mode):
        return "it is a folder" if stat.S_ISDIR(found.st_mode) else "it is no ordinary file"
    if most_bytes is not None and found.st_size > most_bytes:
        return f"it has {found.st_size} bytes, more than {most_bytes}"
    return ""
