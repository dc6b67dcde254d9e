"""The report's drawings as SVG: small, sharp in print, with their text as text."""

import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import Any

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.extras import imported
from bumpless.contract.modes import LOOKS
from bumpless.contract.units import DEG, EDGE_PER_SI
from bumpless.metrics import Columns
from bumpless.runs.run import Run

MOST_POINTS = 1200  # of a line: more is finer than print
WIDTH_IN = 7.2
INK, FAINT, TRACE, REFERENCE, ALARM = "#0f1b2a", "#aebccb", "#0369a1", "#7c3aed", "#b91c1c"
STYLE: Any = {
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 8,
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e3e9f0",
    "xtick.color": INK,
    "ytick.color": INK,
    "lines.linewidth": 1.1,
    "path.simplify": True,
    "path.simplify_threshold": 0.4,
    "svg.hashsalt": "bumpless",
}
Draw = Callable[[Any, "Lines"], None]


def drawings(run: Run, events: Sequence[Any]) -> list[tuple[str, str]]:
    """Title and SVG of each. Needs the extra `report`."""
    imported("matplotlib", "report")
    import matplotlib

    matplotlib.use("Agg")
    commands = run.vehicle.commands if run.vehicle is not None else ()
    columns, made = _thinned(run.columns, [command.unit for command in commands]), []
    names = [f"{command.name}, {command.unit}" for command in commands]
    with matplotlib.rc_context(STYLE):
        made.append(("Timeline", _timeline(columns, events)))
        made.append(("Motion, with its references", _stacked(columns, (_depth, _speed, _heading, _aside))))
        made.append(
            (
                "Demanded and achieved wrench",
                _stacked(columns, (_force("X", 0), _force("Z", 2), _force("M", 4), _force("N", 5))),
            )
        )
        made.append(
            ("Commands", _stacked(columns, tuple(_command(i, name) for i, name in enumerate(names)), 0.72))
        )
        made.append(("Track from above", _track(columns)))
    return made


@dataclass(frozen=True)
class Lines:
    """The columns that are drawn, thinned; see `metrics.Columns`."""

    time: np.ndarray
    mode: np.ndarray
    depth: np.ndarray
    eta_hat: np.ndarray
    nu_hat: np.ndarray
    reference: np.ndarray
    cross_track: np.ndarray
    tau_d: np.ndarray
    tau_c: np.ndarray
    u: np.ndarray  # in the commands' own units
    u_feedback: np.ndarray
    target: np.ndarray
    observation_point: np.ndarray
    gaps: list[tuple[float, float]]  # not recorded, s

    @property
    def broken(self) -> np.ndarray:
        """Time for a line, which ends where a gap begins."""
        return broken(self.time, self.gaps)

    @property
    def stays(self) -> list[tuple[int, float, float]]:
        """(mode, from, to) of each stay in a mode, s; a gap is part of none."""
        after = [int(np.searchsorted(self.time, end)) for _, end in self.gaps]
        cuts = {*(np.flatnonzero(np.diff(self.mode)) + 1).tolist(), *after}
        edges = [0, *sorted(cut for cut in cuts if 0 < cut < len(self.time)), len(self.time)]
        last = len(self.time) - 1
        ends = {b: self.time[b - 1] if b in after else self.time[min(b, last)] for b in edges[1:]}
        return [(int(self.mode[a]), self.time[a], ends[b]) for a, b in pairwise(edges)]


def broken(time: np.ndarray, gaps: Sequence[tuple[float, float]]) -> np.ndarray:
    """(n,) times with NaN for the first after each gap, so that a line over them is not drawn across it."""
    made = np.array(time, float)
    for _, end in gaps:
        row = int(np.searchsorted(time, end))
        if 0 < row < len(made):
            made[row] = np.nan
    return made


def _thinned(run: Columns, units: Sequence[str]) -> Lines:
    every = max(1, -(-len(run) // MOST_POINTS))
    edge = np.array([EDGE_PER_SI[unit] for unit in units]) if units else 1.0
    columns = {f.name: getattr(run, f.name)[::every] for f in fields(Lines) if f.name != "gaps"}
    columns["gaps"] = run.gaps
    return Lines(**columns | {name: columns[name] * edge for name in ("u", "u_feedback")})


def svg_of(figure: Any) -> str:
    """The figure as SVG, closed."""
    from matplotlib import pyplot

    out = io.StringIO()
    figure.savefig(out, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    text = out.getvalue()
    return text[text.index("<svg") :]


def _hatch(axes: Any, run: Lines) -> None:
    """What was not recorded."""
    for first, last in run.gaps:
        axes.axvspan(first, last, facecolor="none", edgecolor=FAINT, hatch="////", linewidth=0)


def _shade(axes: Any, run: Lines) -> None:
    """Modes as a faint ground with their letters: colour never alone."""
    _hatch(axes, run)
    for mode, first, last in run.stays:
        look = LOOKS.get(mode)
        if look is None:
            continue
        axes.axvspan(first, last, color=look.colour, alpha=0.12, linewidth=0)
        axes.text(
            first,
            1.01,
            f" {look.letter}",
            transform=axes.get_xaxis_transform(),
            fontsize=7,
            fontweight="bold",
        )


def _timeline(run: Lines, events: Sequence[Any]) -> str:
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(WIDTH_IN, 1.1))
    for mode, first, last in run.stays:
        look = LOOKS.get(mode)
        if look is not None:
            axes.axvspan(first, last, color=look.colour, linewidth=0)
            axes.text(first, 0.5, f" {look.letter} {look.name}", va="center", fontweight="bold", clip_on=True)
    _hatch(axes, run)
    for event in events:
        if event.severity >= pb.SEVERITY_WARNING:
            axes.axvline(event.stamp.mission_time_s, color=ALARM, linewidth=1.2)
    axes.set(xlim=(run.time[0], run.time[-1]), ylim=(0, 1), yticks=[], xlabel="mission time, s")
    axes.grid(visible=False)
    return svg_of(figure)


def _stacked(run: Lines, draws: Sequence[Draw], height: float = 1.15) -> str:
    from matplotlib import pyplot

    figure, many = pyplot.subplots(
        len(draws), 1, sharex=True, figsize=(WIDTH_IN, height * len(draws) + 0.3), squeeze=False
    )
    for axes, draw in zip(many[:, 0], draws, strict=True):
        _shade(axes, run)
        draw(axes, run)
        axes.margins(x=0)
    many[-1, 0].set_xlabel("mission time, s")
    return svg_of(figure)


def _pair(axes: Any, time: Any, value: Any, reference: Any, label: str) -> None:
    axes.plot(time, reference, color=REFERENCE, linestyle="--", linewidth=0.9)
    axes.plot(time, value, color=TRACE)
    axes.set_ylabel(label)


def _depth(axes: Any, run: Lines) -> None:
    _pair(axes, run.broken, run.depth, run.reference[:, 2], "depth, m")
    axes.invert_yaxis()


def _speed(axes: Any, run: Lines) -> None:
    _pair(axes, run.broken, run.nu_hat[:, 0], run.reference[:, 0], "surge, m/s")


def _heading(axes: Any, run: Lines) -> None:
    yaw = np.unwrap(run.eta_hat[:, 5])
    reference = yaw + (run.reference[:, 5] - yaw + np.pi) % (2 * np.pi) - np.pi
    _pair(axes, run.broken, yaw * DEG, reference * DEG, "heading, °")


def _aside(axes: Any, run: Lines) -> None:
    axes.plot(run.broken, run.cross_track, color=TRACE)
    axes.set_ylabel("cross-track, m")


def _force(letter: str, k: int) -> Draw:
    def draw(axes: Any, run: Lines) -> None:
        _pair(axes, run.broken, run.tau_c[:, k], run.tau_d[:, k], f"{letter}, {'N' if k < 3 else 'N·m'}")

    return draw


def _command(i: int, name: str) -> Draw:
    def draw(axes: Any, run: Lines) -> None:
        _pair(axes, run.broken, run.u_feedback[:, i], run.u[:, i], "")
        axes.set_ylabel(name.replace(", ", "\n"), rotation=0, ha="right", va="center")

    return draw


def _track(run: Lines) -> str:
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(WIDTH_IN, 3.0))
    for mode, look in LOOKS.items():
        there = np.where((run.mode == mode) & np.isfinite(run.broken), 1.0, np.nan)
        axes.plot(run.eta_hat[:, 1] * there, run.eta_hat[:, 0] * there, color=look.colour, label=look.name)
    axes.plot(run.target[-1, 1], run.target[-1, 0], "s", color=REFERENCE, label="target, as believed")
    axes.plot(
        run.observation_point[-1, 1],
        run.observation_point[-1, 0],
        "x",
        color=REFERENCE,
        label="observation point",
    )
    axes.set(xlabel="east, m", ylabel="north, m")
    axes.set_aspect("equal", adjustable="datalim")
    axes.legend(fontsize=7, frameon=False)
    return svg_of(figure)
