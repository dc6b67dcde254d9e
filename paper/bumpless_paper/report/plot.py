"""Panels as inline SVG: axes, curves, shaded modes. Colours come from the page's style sheet."""

import itertools
import math
from html import escape

import numpy as np
from numpy.typing import NDArray

from bumpless.contract.modes import MODE_LETTERS
from bumpless_paper.report.content import Panel, Series
from bumpless_paper.report.ticks import decades, number, ticks

WIDTH, HEIGHT = 860, 250
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 16, 40
POINTS = 700  # kept of a curve on the page; the CSV has them all
Array = NDArray[np.float64]


def panel_svg(panel: Panel, width: int = WIDTH, height: int = HEIGHT) -> str:
    """The panel as one <svg> with its legend."""
    x_low, x_high = _range([s.x for s in panel.series], panel.log_x, 0.0)
    y_low, y_high = _range([s.y for s in panel.series], panel.log_y, 0.06)
    inner_w, inner_h = width - LEFT - RIGHT, height - TOP - BOTTOM
    if panel.equal:
        scale = min(inner_w / (x_high - x_low), inner_h / (y_high - y_low))
        x_mid, y_mid = (x_low + x_high) / 2, (y_low + y_high) / 2
        x_low, x_high = x_mid - inner_w / scale / 2, x_mid + inner_w / scale / 2
        y_low, y_high = y_mid - inner_h / scale / 2, y_mid + inner_h / scale / 2

    def px(x: Array | float) -> Array:
        return LEFT + inner_w * _share(np.asarray(x, float), x_low, x_high, panel.log_x)

    def py(y: Array | float) -> Array:
        return TOP + inner_h * (1.0 - _share(np.asarray(y, float), y_low, y_high, panel.log_y))

    out = [f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{escape(panel.y_label)}">']
    for start, end, mode in panel.spans:
        a, b = float(px(max(start, x_low))), float(px(min(end, x_high)))
        out.append(
            f'<rect class="m{mode}" x="{a:.1f}" y="{TOP}" width="{max(b - a, 0):.1f}" height="{inner_h}"/>'
        )
        out.append(f'<text class="mode" x="{(a + b) / 2:.1f}" y="{TOP + 12}">{MODE_LETTERS[mode]}</text>')
    for x in decades(x_low, x_high) if panel.log_x else ticks(x_low, x_high, 8):
        at = float(px(x))
        out.append(f'<path class="grid" d="M{at:.1f} {TOP}v{inner_h}"/>')
        out.append(f'<text class="tx" x="{at:.1f}" y="{TOP + inner_h + 15}">{number(float(x))}</text>')
    for y in decades(y_low, y_high) if panel.log_y else ticks(y_low, y_high, 5):
        at = float(py(y))
        out.append(f'<path class="grid" d="M{LEFT} {at:.1f}h{inner_w}"/>')
        out.append(f'<text class="ty" x="{LEFT - 6}" y="{at + 4:.1f}">{number(float(y))}</text>')
    for x, word in panel.marks:
        at = float(px(x))
        out.append(f'<path class="mark" d="M{at:.1f} {TOP}v{inner_h}"/>')
        out.append(f'<text class="mode" x="{at:.1f}" y="{TOP + 24}">{escape(word)}</text>')
    for series in panel.series:
        out.append(_curve(series, px(series.x), py(series.y)))
    out.append(f'<rect class="frame" x="{LEFT}" y="{TOP}" width="{inner_w}" height="{inner_h}"/>')
    out.append(
        f'<text class="label" x="{LEFT + inner_w / 2}" y="{height - 6}">{escape(panel.x_label)}</text>'
    )
    middle = TOP + inner_h / 2
    out.append(
        f'<text class="label" transform="translate(13 {middle}) rotate(-90)">{escape(panel.y_label)}</text>'
        "</svg>"
    )
    names = dict.fromkeys((s.name, s.colour, s.style) for s in panel.series)
    if len(names) > 1 or any(name for name, _, _ in names):
        keys = "".join(
            f'<span><i class="k{colour} {style}"></i>{escape(name)}</span>' for name, colour, style in names
        )
        out.append(f'<div class="legend">{keys}</div>')
    return "".join(out)


def _curve(series: Series, x: Array, y: Array) -> str:
    good = np.isfinite(x) & np.isfinite(y)
    x, y = x[good], y[good]
    if series.style == "dots":
        points = "".join(f"M{a:.1f} {b:.1f}h0" for a, b in zip(x, y, strict=True))
        return f'<path class="dots s{series.colour}" d="{points}"/>'
    keep = thinned(x, y)
    if len(keep) == 0:
        return ""
    words = [f"M{x[keep[0]]:.1f} {y[keep[0]]:.1f}"]
    for k in keep[1:]:
        words.append(f"H{x[k]:.1f}V{y[k]:.1f}" if series.style == "steps" else f"L{x[k]:.1f} {y[k]:.1f}")
    return f'<path class="curve {series.style} s{series.colour}" d="{"".join(words)}"/>'


def thinned(x: Array, y: Array) -> NDArray[np.int64]:
    """Indices of at most about POINTS samples: of each stretch its lowest and its highest stay."""
    n = len(x)
    if n <= POINTS:
        return np.arange(n)
    edges = np.linspace(0, n, POINTS // 2 + 1).astype(int)
    keep = {0, n - 1}
    for a, b in itertools.pairwise(edges):
        keep.update((a + int(np.argmin(y[a:b])), a + int(np.argmax(y[a:b]))))
    return np.array(sorted(keep))


def _range(arrays: list[Array], log: bool, margin: float) -> tuple[float, float]:
    values = np.concatenate([np.asarray(a, float).ravel() for a in arrays]) if arrays else np.zeros(1)
    values = values[np.isfinite(values) & ((values > 0.0) | (not log))]
    if len(values) == 0:
        return (1.0, 10.0) if log else (0.0, 1.0)
    low, high = float(values.min()), float(values.max())
    if log:
        return low / 1.2, high * 1.2
    if high - low < 1e-12:
        return low - 0.5, high + 0.5
    return low - margin * (high - low), high + margin * (high - low)


def _share(value: Array, low: float, high: float, log: bool) -> Array:
    if log:
        return (np.log10(np.maximum(value, 1e-300)) - math.log10(low)) / (math.log10(high) - math.log10(low))
    return (value - low) / (high - low)
