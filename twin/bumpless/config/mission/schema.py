"""JSON Schema of mission files, made from the declarations that read them."""

from functools import cache
from typing import Any

from bumpless.config.declare.schema import schema_of
from bumpless.config.mission.model import Document


@cache
def mission_json_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of mission files."""
    about = "Positions are NED: north, east, down in metres; depth is positive down."
    return schema_of(Document, "Bumpless mission", about)
