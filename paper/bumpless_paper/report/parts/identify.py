"""Which vehicle gives Table 3: least squares over its parameters, and what the table leaves open.

Source: Gao et al. 2026, table 3, under the sampling of section 2.6.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from bumpless.config.vehicle import load_vehicle
from bumpless.physics.actuators import FIN, THRUSTER
from bumpless.physics.envelope import sampled_sets
from bumpless.physics.model import build_model
from bumpless_paper.report.content import Figure, Grid, Panel, Part, Series
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.envelopes import GROUPS, SPEED, indicators, paper_rows
from bumpless_paper.report.ticks import share

Array = NDArray[np.float64]
START = 0.25  # of each parameter, how far from the shipped value the search begins
DETERMINED = 0.05  # relative uncertainty below which a parameter counts as determined
SEEDS = (0, 1)
DIGITS = 0.5e-4  # half of the last printed digit
MODEL_ERROR = 0.01  # of each indicator: the paper's fin data are not quite linear and parabolic


@dataclass(frozen=True)
class Parameter:
    """One number of the vehicle that the search may scale. fields: of MODEL; kind: whose."""

    name: str
    field: str
    kind: int
    index: int | None = None  # coordinate of a position
    lateral: bool = True  # thrusters: those off the axis, or the one on it


PARAMETERS = (
    Parameter("fin lift slope", "C_La", FIN),
    Parameter("fin drag rise", "C_D2", FIN),
    Parameter("fin drag at zero", "C_D0", FIN),
    Parameter("fins aft of O_b", "position", FIN, 0),
    Parameter("radial arm of the fins", "position", FIN, 1),
    Parameter("main propeller thrust", "T_nn", THRUSTER, lateral=False),
    Parameter("main propeller torque", "Q_nn", THRUSTER, lateral=False),
    Parameter("vertical thrust", "T_nn", THRUSTER),
    Parameter("vertical torque", "Q_nn", THRUSTER),
    Parameter("half spacing of the verticals", "position", THRUSTER, 1),
)


def scaled_model(model: np.record, factors: Array) -> np.record:
    """A copy with each parameter multiplied by its factor."""
    out = model.copy()
    off_axis = np.abs(model["position"][:, 1]) > 1e-6
    for parameter, factor in zip(PARAMETERS, factors, strict=True):
        rows = model["kind"] == parameter.kind
        rows &= np.arange(len(rows)) < int(model["n_u"])
        if parameter.kind == THRUSTER:
            rows &= off_axis == parameter.lateral
        if parameter.index is None:
            for name in [parameter.field] + (["T_nn_reverse"] if parameter.field == "T_nn" else []):
                out[name][rows] *= factor
        elif parameter.kind == FIN and parameter.index == 1:
            out["position"][rows, 1:] *= factor
        else:
            out["position"][rows, parameter.index] *= factor
    return out


def sampled_indicators(model: np.record, seed: int = 0) -> Array:
    """The printed indicators of the paper's sampling: those of Table 3 that are numbers."""
    printed = paper_rows()
    sets = sampled_sets(model, SPEED, seed)
    rows = [
        value
        for row in GROUPS
        for value, paper in zip(indicators(sets[row]), printed[row], strict=True)
        if paper is not None
    ]
    return np.array(rows)


def uncertainty(model: np.record) -> Array:
    """Relative standard deviation of each indicator: of the random draw, the printed digits, the model."""
    draws = np.array([sampled_indicators(model, seed) for seed in range(6)])
    printed = printed_values()
    drawn, rounded = draws.std(axis=0) / draws.mean(axis=0), DIGITS / printed / np.sqrt(3)
    return np.sqrt(drawn**2 + rounded**2 + MODEL_ERROR**2)


def printed_values() -> Array:
    """Table 3's numbers in the order of `sampled_indicators`."""
    return np.array([v for row in paper_rows().values() for v in row if v is not None])


def part(progress: Progress) -> Part:
    """Fit the parameters to Table 3 from a start a quarter off; then ask what the table determines."""
    vehicle = load_vehicle("ts100")
    model = build_model(vehicle)
    printed, n = printed_values(), len(PARAMETERS)
    sigma = uncertainty(model)
    calls = [0]

    def misfit(logs: Array, seed: int = SEEDS[0]) -> Array:
        calls[0] += 1
        progress(min(0.9, calls[0] / 220))
        ours = sampled_indicators(scaled_model(model, np.exp(logs)), seed)
        return (np.log(ours) - np.log(printed)) / sigma

    def held(logs: Array) -> Array:
        return np.concatenate([misfit(logs), 1e-2 * (logs - start)])

    signs = np.where(np.arange(n) % 2 == 0, 1.0, -1.0)
    start = np.log1p(START * signs)
    fit = least_squares(held, start, diff_step=2e-2, max_nfev=14)
    jacobian = _jacobian(misfit, fit.x)
    _, values, directions = np.linalg.svd(jacobian)
    values = np.concatenate([values, np.zeros(n - len(values))])
    deviation = np.sqrt(np.sum((directions / np.maximum(values, 1e-9)[:, None]) ** 2, axis=0))
    factors = np.exp(fit.x)
    rows = [
        [
            p.name,
            float(factors[i]),
            float(deviation[i]) if deviation[i] < 10 else None,
            "determined" if deviation[i] < DETERMINED else "not determined",
        ]
        for i, p in enumerate(PARAMETERS)
    ]
    weights = [
        [
            f"σ{k + 1}",
            float(values[k]),
            1.0 / float(values[k]) if values[k] > 1e-6 else None,
            _direction(directions[k]),
        ]
        for k in range(n)
    ]
    relative = np.exp(misfit(fit.x) * sigma) - 1.0
    progress(1.0)
    order = np.arange(1, n + 1, dtype=float)
    return Part(
        "identify",
        "The vehicle behind Table 3",
        f"Starting {share(START)} off in every parameter, least squares under the paper's own sampling comes "
        f"to within {share(float(np.abs(relative).max()), 1)} of every printed indicator. Ten numbers and "
        f"their errors determine {sum(r[3] == 'determined' for r in rows)} of {n} parameters to 5 %; the "
        "singular values say which combinations are left open, and there the vehicle file says 'assumed'.",
        [
            Grid(
                "identified",
                "Parameters found, over those of the vehicle file",
                "Standard deviation: relative, from draws, printed digits and 1 % of model error.",
                ["parameter", "found / file", "standard deviation", "by Table 3"],
                rows,
            ),
            Grid(
                "singular_values",
                "Directions in parameter space",
                "Singular values of d ln(indicator) / d ln(parameter) over each indicator's uncertainty; a "
                "direction is known to about 1/σ. Named are the parameters with the largest share.",
                ["", "σ", "known to", "direction"],
                weights,
            ),
        ],
        [
            Figure(
                "identify_singular_values",
                "Singular values",
                "A steep fall divides what the table determines from what it does not.",
                [Panel("index", "σ", [Series("", order, np.maximum(values, 1e-3), 0, "dots")], log_y=True)],
            )
        ],
        numbers={
            "largest_misfit": float(np.abs(relative).max()),
            "determined": [r[0] for r in rows if r[3] == "determined"],
            "undetermined": [r[0] for r in rows if r[3] != "determined"],
            "evaluations": calls[0],
        },
        hashes={"vehicle ts100": vehicle.sha256},
    )


def _jacobian(misfit, at: Array) -> Array:
    h = 2e-2
    columns = []
    for i in range(len(at)):
        step = np.zeros(len(at))
        step[i] = h
        columns.append(
            np.mean([(misfit(at + step, s) - misfit(at - step, s)) / (2 * h) for s in SEEDS], axis=0)
        )
    return np.array(columns).T


def _direction(v: Array) -> str:
    order = np.argsort(-np.abs(v))[:3]
    return ", ".join(f"{v[i]:+.2f} {PARAMETERS[i].name}" for i in order if abs(v[i]) > 0.2).replace("-", "−")
