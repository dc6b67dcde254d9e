"""Campaign files: their fields from the declaration, and every quantity that may be drawn."""

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.quantities import QUANTITIES, Quantity
from bumpless.config.declare.reference import tables
from docs.generate.markdown import NOTE

HEAD = """# Campaign files

A campaign is a YAML file; [how to fly one](../campaigns.md). Fields marked required have no default. What may
stand in `parameters` is [a page of its own](parameters.md), as is [a whole mission](mission.md).

"""
DRAWN = """## What may be drawn

`along`, `across` and `relative` are in axes of the target's approach heading: along is the way in, across is
to starboard of it. A quantity that is not drawn leaves the mission and the vehicle as they are.

| quantity | unit | range | what it is |
|---|---|---|---|
"""


def page() -> str:
    """Markdown: the fields, then the quantities."""
    fields = "\n".join(tables(Campaign)).rstrip("\n")
    quantities = "\n".join(line(name, quantity) for name, quantity in QUANTITIES.items())
    return f"{NOTE}{HEAD}{fields}\n\n{DRAWN}{quantities}\n"


def line(name: str, quantity: Quantity) -> str:
    """The row of one quantity."""
    ends = f"{quantity.low:g} to {quantity.high:g}" if quantity.high > quantity.low else "names"
    return f"| `{name}` | {quantity.unit} | {ends} | {quantity.about} |"
