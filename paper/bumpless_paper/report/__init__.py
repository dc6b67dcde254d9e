"""`bumpless reproduce`: every published number beside ours, as data, figures and one page.

A part (`bumpless_paper.report.parts`) is a function that flies, fits or counts and returns a `Part`: tables,
figures and the same numbers for machines. `bumpless_paper.report.page` makes the page of them. Nothing here
touches a file; the command line does.
"""

from bumpless_paper.report.content import Comparison, Figure, Grid, Panel, Part, Series, Solid
from bumpless_paper.report.page import page_of

__all__ = ["Comparison", "Figure", "Grid", "Panel", "Part", "Series", "Solid", "page_of"]
