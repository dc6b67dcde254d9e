"""JSON Schema (2020-12) of a model, for editors, forms and other languages."""

from typing import Any

from pydantic import TypeAdapter

from bumpless.config.declare.models import fields_of

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def schema_of(cls: type, title: str, description: str) -> dict[str, Any]:
    """The whole schema of files that hold one instance of the model."""
    return {"$schema": DIALECT, **TypeAdapter(cls).json_schema(), "title": title, "description": description}


def partial(cls: type) -> dict[str, Any]:
    """The schema of tables that may leave out any section of the model, and any field of a section."""
    sections = {key: optional_fields(field.kind) for key, field in fields_of(cls).items()}
    return {"type": "object", "additionalProperties": False, "properties": sections}


def optional_fields(cls: type) -> dict[str, Any]:
    """The schema of a model's table in which nothing must be given and nothing has a default."""
    schema = TypeAdapter(cls).json_schema()
    for field in schema["properties"].values():
        field.pop("default", None)
    return {name: part for name, part in schema.items() if name != "required"}
