"""What a campaign keeps of a flight's figures: those of `bumpless.runs.figures`, as every run has them."""

from typing import TYPE_CHECKING

from bumpless.contract.bumpless_pb2 import Metrics
from bumpless.contract.modes import LOOKS, MODES
from bumpless.metrics import Outcome

if TYPE_CHECKING:
    from bumpless.metrics.errors import EndErrors

Figures = dict[str, float]
NOTHING = float("nan")

OUTCOME = {"held_s": "held_s", "tries": "tries", "closest_m": "closest_m", "closest_s": "closest_s"}
ERRORS = {
    "range_m": "position_m",
    "depth_m": "depth_m",
    "heading_deg": "heading_deg",
    "speed_mps": "speed_mps",
}
METRICS = {
    "duration_s": "duration_s",
    "wrench_error_rms": "residual_rms_true",  # by the plant's true wrench
    "step_fr": "d_u_fr",  # in the paper's window
    "step_rh": "d_u_rh",
    "late_step_fr": "d_u_fr_settling",  # to the ramp's end and 15 s more
    "late_step_rh": "d_u_rh_settling",
    "energy_j": "shaft_energy_j",
    "fin_travel_deg": "fin_travel_deg",
    "reversals": "screw_reversals",
}
CHANNELS = {
    "depth_m": "depth_error_{}_m",
    "cross_m": "cross_track_error_{}_m",
    "heading_deg": "heading_error_{}_deg",
    "speed_mps": "speed_error_{}_mps",
}
KINDS = {"rms": "rms", "worst": "max"}

_OF_MODE = {
    f"{channel}_{kind}": field.format(word)
    for channel, field in CHANNELS.items()
    for kind, word in KINDS.items()
}
TRACKING = tuple(f"{look.key}_{name}" for look in MODES for name in _OF_MODE)
END = tuple(f"{when}_{name}" for when in ("end", "believed") for name in ERRORS)
NUMBERS = (*OUTCOME, *END, *METRICS, "largest_step", *TRACKING)


def figures(metrics: Metrics, outcome: Outcome) -> Figures:
    """`NUMBERS` of a flight; NaN for what did not happen.

    end_ and believed_: errors of the last cycle, true and believed. largest_step: of the commands over their
    bounds, over all switches, each to its ramp's end and 15 s more.
    """
    out = dict.fromkeys(NUMBERS, NOTHING)
    for name, field in OUTCOME.items():
        value = getattr(outcome, field)
        out[name] = NOTHING if value is None else float(value)
    _end(out, "end", outcome.true_errors)
    _end(out, "believed", outcome.believed_errors)
    for name, field in METRICS.items():
        out[name] = float(getattr(metrics, field))
    out["largest_step"] = max((s.command_step_settling for s in metrics.switches), default=NOTHING)
    for mode in metrics.modes:
        key = LOOKS[mode.mode].key
        for name, field in _OF_MODE.items():
            out[f"{key}_{name}"] = getattr(mode, field)
    return out


def _end(out: Figures, when: str, errors: "EndErrors | None") -> None:
    if errors is not None:
        for name, field in ERRORS.items():
            out[f"{when}_{name}"] = getattr(errors, field)
