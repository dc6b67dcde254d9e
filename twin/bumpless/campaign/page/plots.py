"""The page's pictures, as SVG.

Drawn by Matplotlib: an SVG of some ten kilobytes with text as text, which prints and needs no script. Plotly
and Bokeh bring 1 to 4 MB of script into every page, Altair draws nothing without its own.
"""

import io
from typing import TYPE_CHECKING, Any

import numpy as np

from bumpless.campaign.summary import share_of

if TYPE_CHECKING:
    import pyarrow as pa

SPEEDS, SECTORS, BINS = 5, 12, 6
DARK, MID, LIGHT = "#1d3557", "#457b9d", "#a8b8c8"
_STYLE: Any = {
    "svg.fonttype": "none",
    "svg.hashsalt": "bumpless",  # the same numbers give the same bytes
    "font.family": "sans-serif",
    "font.size": 9.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def current_map(table: "pa.Table") -> str:
    """Share that docked over the current's speed and where it flows to; "" where there is no current."""
    speed, toward = _column(table, "current_mps"), np.radians(_column(table, "current_relative_deg"))
    if not len(speed) or np.ptp(speed) < 1e-9:
        return ""
    docked = _docked(table).astype(float)
    rings = np.linspace(0.0, speed.max(), SPEEDS + 1)
    half = np.pi / SECTORS
    edges = np.linspace(-half, 2.0 * np.pi - half, SECTORS + 1)
    turned = (toward + half) % (2.0 * np.pi) - half
    count, *_ = np.histogram2d(speed, turned, [rings, edges])
    good, *_ = np.histogram2d(speed, turned, [rings, edges], weights=docked)
    share = np.ma.masked_where(count == 0, good / np.maximum(count, 1.0))
    figure, axes = figure_of(5.4, 4.4, polar=True)
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    mesh = axes.pcolormesh(edges, rings, share, cmap="RdYlBu", vmin=0.0, vmax=1.0, edgecolors="white", lw=0.5)
    axes.grid(False)
    axes.tick_params(axis="x", pad=12.0)
    axes.set_rlabel_position(45.0)
    axes.set_xticks(np.radians([0, 90, 180, 270]), ["from astern", "to starboard", "against", "to port"])
    axes.set_yticks(rings[1:], [f"{ring:.2g}" for ring in rings[1:]])
    figure.colorbar(mesh, ax=axes, label="share docked", shrink=0.8, pad=0.14)
    return svg_of(
        figure, "Share that docked over current speed, m/s, and direction from the approach heading"
    )


def quantity_bars(table: "pa.Table") -> str:
    """Share that docked along each drawn number, with its interval; "" when none was drawn."""
    names = [name for name in table.column_names if name.startswith("draw_") and _is_number(table, name)]
    names = [name for name in names if np.ptp(_column(table, name)) > 0.0]
    if not names:
        return ""
    columns = min(3, len(names))
    rows = -(-len(names) // columns)
    figure, grid = figure_of(8.4, 1.9 * rows + 0.4, rows, columns)
    docked = _docked(table)
    for axes, name in zip(grid, names, strict=False):
        _bars(axes, _column(table, name), docked)
        axes.set_xlabel(name.removeprefix("draw_"))
        axes.set_ylim(0.0, 1.0)
    for axes in grid[len(names) :]:
        axes.set_visible(False)
    return svg_of(figure, "Share that docked along each drawn quantity, with its 95 % interval")


def _bars(axes: Any, values: np.ndarray, docked: np.ndarray) -> None:
    """Bins of as many flights each; distinct values where there are few."""
    known = np.unique(values)
    edges = known if len(known) <= BINS else np.quantile(values, np.linspace(0.0, 1.0, BINS + 1)[:-1])
    place = np.searchsorted(edges, values, side="right") - 1
    for k in range(len(edges)):
        inside = place == k
        if not inside.any():
            continue
        share = share_of(int(docked[inside].sum()), int(inside.sum()))
        x = float(values[inside].mean())
        axes.plot([x, x], [share.low, share.high], color=LIGHT, lw=3.0, solid_capstyle="round")
        axes.plot([x], [share.share], "o", color=DARK, ms=4.0)


def _docked(table: "pa.Table") -> np.ndarray:
    return np.array([name == "docked" for name in table.column("outcome").to_pylist()])


def _column(table: "pa.Table", name: str) -> np.ndarray:
    return np.array(table.column(name).to_pylist(), float)


def _is_number(table: "pa.Table", name: str) -> bool:
    return str(table.schema.field(name).type) == "double"


def figure_of(width: float, height: float, rows: int = 1, columns: int = 1, polar: bool = False) -> Any:
    """A figure apart from pyplot, so that no state and no window is left behind."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(_STYLE):
        if polar:
            figure = Figure((width, height), layout="constrained")
            return figure, figure.add_subplot(projection="polar")
        figure = Figure((width, height))
        # by hand, in inches: Matplotlib's own layouts draw all axes once more to find the margins
        margins = {"left": 0.35 / width, "right": 1.0 - 0.1 / width, "bottom": 0.45 / height}
        margins |= {"top": 1.0 - 0.1 / height, "hspace": 0.4, "wspace": 0.2}
        grid = figure.subplots(rows, columns, squeeze=False, gridspec_kw=margins).ravel()
    return figure, list(grid)


def svg_of(figure: Any, title: str) -> str:
    """The figure as an element to put into a page, named for those who do not see it."""
    import matplotlib

    out = io.StringIO()
    with matplotlib.rc_context(_STYLE):
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Title": title})
    text = out.getvalue()
    return text[text.index("<svg") :].replace("<svg", f'<svg role="img" aria-label="{title}"', 1)
