"""When modes change, and the filter of the detection in front of it."""

from typing import Annotated

from bumpless.config.declare import Number, model


def distance(label: str, record: str) -> Number:
    """A threshold of the range to the target."""
    return Number(label, "m", 0.01, 1000.0, live=True, record=record)


@model
class SupervisorParameters:
    """When modes change: d_RH^L < d_RH^U < d_FR^L < d_FR^U < d_HF^U, and the detection filter.

    Source: Gao et al. 2026, eq. (53). The filter (M of N, then hold) stands in front of chi and
    counts camera frames; 1 of 1 with no hold gives the published automaton.
    """

    range_rh_lower_m: Annotated[float, distance("d_RH^L, reverse to hover", "d_rh_l")]
    range_rh_upper_m: Annotated[float, distance("d_RH^U, hover to reverse", "d_rh_u")]
    range_fr_lower_m: Annotated[float, distance("d_FR^L, forward to reverse", "d_fr_l")]
    range_fr_upper_m: Annotated[float, distance("d_FR^U, reverse to forward", "d_fr_u")]
    range_hf_upper_m: Annotated[float, distance("d_HF^U, hover to forward", "d_hf_u")]
    dwell_cycles: Annotated[
        int, Number("N_dwell, shortest stay in a mode", "cycles", 0, 10000, live=True, record="n_dwell")
    ]
    detection_hits: Annotated[int, Number("M, detections needed", "frames", 1, 62, live=True, record="hits")]
    detection_window: Annotated[
        int, Number("N, out of this many", "frames", 1, 62, live=True, record="window")
    ]
    detection_hold_cycles: Annotated[
        int,
        Number("Detection held for", "frames", 0, 10000, live=True, record="hold",
               help="χ stays 1 for so many camera frames after the filter last passed."),
    ]  # fmt: skip
