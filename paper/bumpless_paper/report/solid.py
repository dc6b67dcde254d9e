"""Convex bodies in space as inline SVG: one fixed view from above ahead, faces shaded by their slope."""

from html import escape

import numpy as np
from numpy.typing import NDArray

from bumpless_paper.report.content import Solid
from bumpless_paper.report.ticks import number

SIZE = 400
_VIEW = np.array([0.55, 0.75, -0.45])  # from which the body is seen; z points down as in the body frame
Array = NDArray[np.float64]


def solid_svg(solid: Solid) -> str:
    """The body in its own box; each axis is scaled to the box, so that flat sets can be seen too."""
    low, high = solid.vertices.min(axis=0), solid.vertices.max(axis=0)
    span = np.where(high - low > 1e-9, high - low, 1.0)
    unit = (solid.vertices - (low + high) / 2) / span
    right, up, depth = _axes()
    x, y = _project(unit, right, up)
    out = [f'<svg viewBox="0 0 {SIZE} {SIZE}" role="img" aria-label="{escape(solid.name)}">']
    out += _box(right, up)
    corners = unit[solid.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    shade = np.abs(normal @ depth) / np.where(length > 0, length, 1.0)
    order = np.argsort((corners.mean(axis=1)) @ depth)
    for f in order:
        if length[f] < 1e-12:
            continue
        points = " ".join(f"{x[v]:.1f},{y[v]:.1f}" for v in solid.faces[f])
        out.append(f'<polygon class="face" style="--l:{0.25 + 0.6 * shade[f]:.2f}" points="{points}"/>')
    if len(solid.faces) == 0:
        out.append(_flat(x, y))
    if solid.inner is not None:
        a, b = _project((solid.inner - (low + high) / 2) / span, right, up)
        out.append(
            '<path class="dots s1" d="'
            + "".join(f"M{p:.1f} {q:.1f}h0" for p, q in zip(a, b, strict=True))
            + '"/>'
        )
    out += _axes_text(low, high, right, up, solid.axes)
    out.append(f'<text class="label" x="{SIZE / 2}" y="14">{escape(solid.name)}</text></svg>')
    return "".join(out)


def _flat(x: Array, y: Array) -> str:
    angle = np.arctan2(y - y.mean(), x - x.mean())
    points = " ".join(f"{x[k]:.1f},{y[k]:.1f}" for k in np.argsort(angle))
    return f'<polygon class="face" style="--l:.6" points="{points}"/>'


def _axes() -> tuple[Array, Array, Array]:
    depth = _VIEW / np.linalg.norm(_VIEW)
    right = np.cross(depth, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    up = np.cross(right, depth)
    return right, (up if up[2] < 0 else -up), depth


def _project(points: Array, right: Array, up: Array) -> tuple[Array, Array]:
    scale = 0.52 * SIZE
    return SIZE / 2 + scale * (points @ right), SIZE / 2 + 6 - scale * (points @ up)


def _box(right: Array, up: Array) -> list[str]:
    out = []
    corners = np.array([[i, j, k] for i in (-0.5, 0.5) for j in (-0.5, 0.5) for k in (-0.5, 0.5)])
    x, y = _project(corners, right, up)
    for a in range(8):
        for b in range(a + 1, 8):
            if np.sum(np.abs(corners[a] - corners[b])) == 1.0:
                out.append(f'<path class="grid" d="M{x[a]:.1f} {y[a]:.1f}L{x[b]:.1f} {y[b]:.1f}"/>')
    return out


def _axes_text(low: Array, high: Array, right: Array, up: Array, axes: tuple[str, str, str]) -> list[str]:
    """Name and range of each axis, drawn over the body."""
    out = []
    for axis in range(3):
        edge = np.array([0.5, 0.5, 0.5])
        edge[axis] = 0.0
        if axis == 2:
            edge[:2] = [-0.5, 0.5]
        px, py = _project(edge[None, :], right, up)
        text = f"{axes[axis]}: {number(float(low[axis]), 3)} … {number(float(high[axis]), 3)}"
        if axis == 2:  # along the upright edge on the left
            turned = f"translate({px[0] - 10:.1f} {py[0]:.1f}) rotate(-90)"
            out.append(f'<text class="axis" transform="{turned}">{escape(text)}</text>')
            continue
        shift = (-4, 4)[axis]
        out.append(f'<text class="axis" x="{px[0] + shift:.1f}" y="{py[0] + 16:.1f}">{escape(text)}</text>')
    return out
