"""Names that people give to uploaded files: safe in a path, in an address and on every system."""

from bumpless.contract.names import FILE, BadName

__all__ = ["BadName", "checked_name"]


def checked_name(name: str, *endings: str) -> str:
    """`name` without its ending (one of `endings`), if it may name a file. Raises BadName."""
    for ending in endings:
        name = name.removesuffix(ending)
    if not FILE.allows(name):
        raise BadName(f"name = {name!r}; must be {FILE.words}")
    return name
