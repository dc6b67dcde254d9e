"""`bumpless reproduce`: every published number beside ours, as data, figures and one page.

A part (`twin.report.parts`) is a function that flies, fits or counts and returns a `Part`: tables,
figures and the same numbers for machines. `twin.report.page` makes the page of them. Nothing here
touches a file; the command line does.
"""

from twin.report.content import Comparison, Figure, Grid, Panel, Part, Series, Solid
from twin.report.page import page_of

__all__ = ["Comparison", "Figure", "Grid", "Panel", "Part", "Series", "Solid", "page_of"]
