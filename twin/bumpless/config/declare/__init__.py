"""One declaration for each number: a model of annotated fields, from which all else is made.

To declare a field: `name: Annotated[type, Note(...)] = default` in a class under `@model`. That one line
gives the check and its words (`read`), the JSON Schema (`schema`), the catalogue for forms (`catalogue`),
the field of the compiled world's record and its filling (`record`) and the line of the reference page
(`reference`).
"""

from bumpless.config.declare.models import MISSING, Field, as_table, fields_of, model, parts_of, tag_of
from bumpless.config.declare.notes import (
    Choice,
    Entries,
    Note,
    Number,
    Part,
    Row,
    Switch,
    Text,
    Words,
)
from bumpless.config.declare.overrides import Overrides
from bumpless.config.declare.read import Broken, Unread, read, unknown

__all__ = [
    "MISSING",
    "Broken",
    "Choice",
    "Entries",
    "Field",
    "Note",
    "Number",
    "Overrides",
    "Part",
    "Row",
    "Switch",
    "Text",
    "Unread",
    "Words",
    "as_table",
    "fields_of",
    "model",
    "parts_of",
    "read",
    "tag_of",
    "unknown",
]
