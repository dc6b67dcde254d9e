"""The software's version, as pages, logs and the vehicle's description show it."""

from functools import cache
from importlib.metadata import PackageNotFoundError, version


@cache
def software_version() -> str:
    """Version of the installed package; "0+unknown" when run from a bare folder."""
    try:
        return version("bumpless")
    except PackageNotFoundError:
        return "0+unknown"
