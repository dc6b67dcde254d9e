"""Runs compared as one HTML file to send: lines laid over each other, ghosts in 3-D, figures, what differs.

Needs the extra `report`.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bumpless.contract.extras import imported
from bumpless.contract.units import DEG
from bumpless.contract.version import software_version
from bumpless.review.compare import Comparison, compare
from bumpless.review.figures import moments
from bumpless.review.report import rendered
from bumpless.review.scene3d import COLOURS, MakeHull, scene
from bumpless.review.subject import subject_of
from bumpless.runs.open_flight import open_flight
from bumpless.runs.run import Run

ALIGNED = {
    "start": "the start",
    "reverse": "the first switch to reverse",
    "hover": "the first switch to hover",
    "end": "the end",
}
DASHES: list[Any] = ["-", "--", ":", "-.", (0, (5, 5)), (0, (1, 2))]
MOST_POINTS = 900
GOOD = ("docked", "held")


def comparison_report(
    paths: Sequence[Path | Sequence[Path]], align: str = "start", make_hull: MakeHull | None = None
) -> str:
    """The report of two to six recorded runs; the first is what the others are compared with.

    paths: of each its file, or those of its pieces in order.

    Raises ValueError for another number of them, for one without figures, or a moment that is none.
    """
    if align not in ALIGNED:
        raise ValueError(f"runs can be aligned on {', '.join(ALIGNED)}, not on {align!r}")
    comparison = compare([subject_of(path) for path in paths])
    runs = [open_flight([path] if isinstance(path, Path) else path) for path in paths]
    zeros = [moments(subject.metrics).get(align, 0.0) for subject in comparison.subjects]
    letters = [chr(65 + k) for k in range(len(runs))]
    return rendered(
        "comparison.html.j2",
        scene(runs, zeros, make_hull),
        subjects=comparison.subjects,
        letters=letters,
        colours=COLOURS,
        aligned=ALIGNED[align],
        verdict=verdict_of(comparison),
        good=all(subject.outcome in GOOD for subject in comparison.subjects),
        drawings=[("Motion, tracking and wrench", _lines(runs, zeros, letters))],
        figures=comparison.figures,
        settings=comparison.settings,
        version=software_version(),
    )


def verdict_of(comparison: Comparison) -> str:
    """One sentence: how each ended, and of how many figures each is better or worse than the first."""
    parts = []
    for k, subject in enumerate(comparison.subjects):
        ended = subject.outcome.replace("_", " ") or "was not judged"
        if k == 0:
            parts.append(f"A {ended}")
            continue
        better, worse = (
            sum(row.changes[k] == change for row in comparison.figures) for change in ("better", "worse")
        )
        parts.append(f"{chr(65 + k)} {ended}, better by {better} figures and worse by {worse}")
    return "; ".join(parts) + "."


def _lines(runs: Sequence[Run], zeros: Sequence[float], letters: Sequence[str]) -> str:
    imported("matplotlib", "report")
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    from bumpless.review.drawings import STYLE, WIDTH_IN, broken, svg_of

    with matplotlib.rc_context(STYLE):
        figure, many = pyplot.subplots(6, 1, sharex=True, figsize=(WIDTH_IN, 7.2), squeeze=False)
        for k, (run, zero) in enumerate(zip(runs, zeros, strict=True)):
            columns = run.columns
            rows = slice(None, None, max(1, -(-len(columns) // MOST_POINTS)))
            residual = np.linalg.norm(columns.tau_d - columns.tau_c, axis=1)
            time = broken(columns.time[rows], columns.gaps)
            signals = (
                ("depth, m", columns.eta_hat[:, 2]),
                ("surge, m/s", columns.nu_hat[:, 0]),
                ("heading, °", np.unwrap(columns.eta_hat[:, 5]) * DEG),
                ("cross-track, m", columns.cross_track),
                ("range, m", columns.range),
                ("‖τ_d − τ_c‖", residual),
            )
            for axes, (label, values) in zip(many[:, 0], signals, strict=True):
                axes.plot(time - zero, values[rows], color=COLOURS[k % len(COLOURS)],
                          linestyle=DASHES[k % len(DASHES)], label=letters[k])  # fmt: skip
                axes.set_ylabel(label)
                axes.margins(x=0)
        many[0, 0].invert_yaxis()
        many[0, 0].legend(loc="upper right", ncols=len(runs), frameon=False, fontsize=7)
        many[-1, 0].set_xlabel("s from the moment they are aligned on")
        return svg_of(figure)
