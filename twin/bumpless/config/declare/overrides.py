"""A part of one model that lays some fields over an instance of another."""

from dataclasses import KW_ONLY, dataclass
from typing import Any

from pydantic_core import CoreSchema

from bumpless.config.declare.notes import Note
from bumpless.config.declare.schema import partial


@dataclass(frozen=True)
class Overrides(Note):
    """Some sections of the model `of`, and of each some fields; laid over an instance of it elsewhere."""

    _: KW_ONLY
    of: type

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: Any) -> dict[str, Any]:
        return super().__get_pydantic_json_schema__(schema, handler) | partial(self.of)
