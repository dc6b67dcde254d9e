"""What makes a switch bumpless, each mechanism on its own."""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, Row, Switch, model
from bumpless.config.names import ERRORS

IntegralAtSwitch = Literal["keep", "rescale", "reset"]


@model
class BumplessParameters:
    """Each switching mechanism on its own, and how integrators are aligned.

    Source: Gao et al. 2026, eqs. (54)-(57); aligned are depth and heading there, and nothing bleeds.
    Differs: other channels may be aligned too, the aligned offset may decay, and integration may be
    scaled by kappa during the ramp; what happens to integrals that are not aligned is chosen; the ramp may
    tighten the increment bound or price increments.
    """

    ramp: Annotated[bool, Switch("Ramp of the weights", live=True, record="ramp")] = True
    ramp_smooth: Annotated[
        bool,
        Switch("Ramp without corners", record="ramp_smooth",
               help="κ with two continuous derivatives; off: straight, as published."),
    ] = False  # fmt: skip
    integrator_alignment: Annotated[bool, Switch("Alignment of integrators", live=True, record="align")] = (
        True
    )
    warm_start_projection: Annotated[
        bool, Switch("Projection of the last command into the new bounds", live=True, record="project")
    ] = True
    align_channels: Annotated[
        tuple[float, ...],
        Row("Channels whose integrators are aligned", "", 0.0, 1.0, names=ERRORS, record="align_channels",
            help="1 where aligned."),
    ] = (0.0, 0.0, 1.0, 0.0, 0.0, 1.0)  # fmt: skip
    align_bleed_s: Annotated[
        float,
        Number("Decay of the aligned offset; 0 keeps it", "s", 0.0, 1000.0, record="align_bleed",
               help="Time constant."),
    ] = 0.0  # fmt: skip
    scale_integration: Annotated[
        bool, Switch("Scale integration by κ during the ramp", record="scale_integration")
    ] = False
    integral_at_switch: Annotated[
        IntegralAtSwitch,
        Choice("What integrals that are not aligned do", record="integral_at_switch",
               help="K_I e_I is kept, e_I is kept (so K_I e_I is rescaled), or both are reset."),
    ] = "keep"  # fmt: skip
    ramp_increment_share: Annotated[
        float,
        Number("Share of the rate limits as a ramp begins", "", 0.001, 1.0, record="ramp_increment_share",
               help="Grows to 1 with κ⁴."),
    ] = 1.0  # fmt: skip
    ramp_increment_price: Annotated[
        float,
        Number("Price of increments as a ramp begins", "", 0.0, 1e6, record="ramp_increment_price",
               help="Weight of ‖u - u_prev‖² at κ = 0; fades with κ."),
    ] = 0.0  # fmt: skip
