"""What may stand in missions, vehicles and parameters: for forms, editors and other programs."""

from typing import Literal

from fastapi import APIRouter

from bumpless_server.web.answers.declared import FieldEntry, Schema
from bumpless_server.web.answers.refusal import REFUSALS

router = APIRouter(prefix="/api", responses=REFUSALS)

Format = Literal["mission", "vehicle", "parameters"]


@router.get("/fields/{kind}")
def fields(kind: Format) -> list[FieldEntry]:
    """Every field with its path, type, unit, range, default, label and help, and whether it is live."""
    from bumpless.config.formats import field_catalogue

    return [FieldEntry.model_validate(entry) for entry in field_catalogue(kind)]


@router.get("/schemas/{kind}")
def schema(kind: Format) -> Schema:
    """The JSON Schema (2020-12) of such files."""
    from bumpless.config.formats import SCHEMAS

    return Schema.model_validate(SCHEMAS[kind]())
