"""The sections of the parameters as records of the compiled world.

SUPERVISOR_SETTINGS = section_dtype("supervisor")
MDCA, WLS, PID_DIRECT = word_codes("allocation", "allocator")
"""

from typing import Any

import numpy as np

from bumpless.config.declare import fields_of
from bumpless.config.declare.record import codes, fill_record, record_dtype
from bumpless.config.parameters.model import Parameters

__all__ = ["fill_record", "section_dtype", "word_codes"]


def section_dtype(section: str) -> np.dtype:
    """Record of a section: "supervisor", "bumpless", "allocation", "guidance", or one of the modes'."""
    return record_dtype(_model(section))


def word_codes(section: str, key: str) -> tuple[int, ...]:
    """The numbers in the record that stand for the words of a field, in the declaration's order."""
    return codes(_model(section), key)


def _model(section: str) -> Any:
    return fields_of(Parameters)[section].kind
