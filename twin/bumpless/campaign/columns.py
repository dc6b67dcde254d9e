"""The columns of a campaign's results."""

from typing import TYPE_CHECKING

from bumpless.campaign.figures import NUMBERS
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.quantities import NAMES

if TYPE_CHECKING:
    import pyarrow as pa

TEXTS = ("mission", "outcome", "why", "reason")


def schema_of(prepared: Prepared) -> "pa.Schema":
    """Number and seed, how it ended, its figures, and a column `draw_...` per drawn quantity."""
    import pyarrow as pa

    numbers = ("current_mps", "current_relative_deg", *NUMBERS)
    fields = [("number", pa.int64()), ("seed", pa.int64())]
    fields += [(name, pa.string()) for name in TEXTS]
    fields += [(name, pa.float64()) for name in numbers]
    for name in prepared.campaign.draw:
        fields.append((f"draw_{name}", pa.string() if name in NAMES else pa.float64()))
    return pa.schema(fields)
