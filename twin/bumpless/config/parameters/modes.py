"""One mode's weights and gains."""

from typing import Annotated

from pydantic import Field

from bumpless.config.capacity import MAX_ACTUATORS
from bumpless.config.declare import Number, Row, model
from bumpless.config.names import ERRORS, WRENCH

PER_WRENCH = "1/N² or 1/(N·m)²"


def errors(label: str, unit: str, max: float, record: str, help: str = "") -> Row:
    """One number for each controlled error."""
    return Row(label, unit, 0.0, max, names=ERRORS, record=record, help=help)


@model
class ModeParameters:
    """Weights and gains of one mode.

    Source: Gao et al. 2026, eq. (44) for the gains, eqs. (45)-(52) for {Q, R, lambda},
    eq. (54) for N_sw.
    """

    q_diagonal: Annotated[
        tuple[float, ...],
        Row("Q, weight of the wrench error", PER_WRENCH, 0.0, 1e6, names=WRENCH, live=True, record="Q"),
    ]
    r_diagonal: Annotated[
        tuple[float, ...],
        Row("R, weight of the commands", "", 1e-6, 1e6, most=MAX_ACTUATORS, live=True, record="R",
            help="Commands are divided by their amplitude bounds first."),
    ]  # fmt: skip
    lambda_: Annotated[
        float, Number("λ, price of commands", "", 1e-9, 1e3, live=True, record="lam"), Field(alias="lambda")
    ]
    ramp_cycles: Annotated[
        int, Number("N_sw, ramp into this mode", "cycles", 0, 1000, live=True, record="n_sw", stored=float)
    ]
    kp: Annotated[tuple[float, ...], errors("K_P", "N or N·m per unit error", 1e4, "K_P")]
    ki: Annotated[tuple[float, ...], errors("K_I", "N or N·m per unit error and second", 1e4, "K_I")]
    kd: Annotated[tuple[float, ...], errors("K_D", "N or N·m per unit error rate", 1e4, "K_D")]
    integral_limit: Annotated[
        tuple[float, ...],
        errors("Bound of the integral action", "N or N·m", 1e4, "integral_limit", "Of |K_I e_I|."),
    ]
    demand_limit: Annotated[
        tuple[float, ...], errors("Bound of the demand", "N or N·m", 1e5, "demand_limit", "Of |τ_d|.")
    ]
    increment_share: Annotated[
        float,
        Number("Share of the rate limits in use", "", 0.001, 1.0, record="increment_share",
               help="Ramps as Q, R and λ do."),
    ] = 1.0  # fmt: skip
