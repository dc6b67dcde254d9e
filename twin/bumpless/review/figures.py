"""Every figure of a run by a name, with its unit, what it means, and whether less of it is better."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import MODES
from bumpless.contract.modes import LOOKS

Better = Literal["less", "more", ""]
Metrics = Mapping[str, Any]  # bumpless.Metrics as JSON, None for what there is none of


@dataclass(frozen=True)
class Figure:
    """One figure. `key` names it in gates and answers; `better` is "" where neither is."""

    key: str
    label: str
    unit: str
    decimals: int
    better: Better
    about: str

    def of(self, metrics: Metrics) -> float | None:
        """Its value in a run; None where it has none."""
        head, _, tail = self.key.partition(".")
        if not tail:
            return _number(metrics.get(head))
        if head == "end":
            outcome = metrics.get("outcome") or {}
            errors = outcome.get("true_errors") or outcome.get("believed_errors") or {}
            return _number(errors.get(tail, outcome.get(tail)))
        for mode in metrics.get("modes") or ():
            if mode.get("mode") == f"MODE_{head.upper()}":
                return _number(mode.get(tail))
        return None


_WHOLE = (
    Figure("end.position_m", "Position error at the end", "m", 3, "less", "3-D, from the observation point"),
    Figure("end.heading_deg", "Heading error at the end", "°", 2, "", "From the approach heading"),
    Figure("end.closest_m", "Closest approach", "m", 2, "", "Of the hull's axis to the marker"),
    Figure("duration_s", "Duration", "s", 1, "", "Mission time flown"),
    Figure("residual_rms", "Residual RMS", "", 4, "less", "Size of tau_d - tau_c over all cycles"),
    Figure("residual_rms_true", "Residual RMS, true", "", 4, "less", "The same against the plant's wrench"),
    Figure("saturation_ratio", "Saturation ratio", "", 4, "less", "Of cycles with a command at its bound"),
    Figure("d_u_fr", "d_u F→R", "", 4, "less", "Largest step of the commands over their bounds within 2 s"),
    Figure("d_u_rh", "d_u R→H", "", 4, "less", "Largest step of the commands over their bounds within 2 s"),
    Figure("d_u_fr_settling", "d_u F→R, settling", "", 4, "less", "The same until 15 s after the ramp"),
    Figure("d_u_rh_settling", "d_u R→H, settling", "", 4, "less", "The same until 15 s after the ramp"),
    Figure("shaft_energy_j", "Shaft energy", "J", 1, "less", "Torque times speed of every screw"),
    Figure("fin_travel_deg", "Fin travel", "°", 0, "less", "Way of all fins together, as measured"),
    Figure("screw_reversals", "Reversals", "", 0, "less", "Changes of a screw's sense of rotation"),
    Figure("solved_ratio", "Solved share", "", 4, "more", "Share of cycles within the solver's tolerance"),
    Figure("solve_time_p95_us", "Solve time, p95", "µs", 0, "less", "Of the allocator, per cycle"),
    Figure("increment_violations", "Increment violations", "", 0, "less", "Proposition 1; must be 0"),
    Figure("demand_step_violations", "Demand step violations", "", 0, "less", "Proposition 1; must be 0"),
    Figure("missing_cycles", "Missing cycles", "", 0, "less", "Not in the log"),
)  # fmt: skip
_OF_A_MODE = (
    ("duration_s", "time", "s", 1, "", "Spent in the mode"),
    ("depth_error_rms_m", "depth error RMS", "m", 3, "less", "Believed minus reference"),
    ("depth_error_max_m", "depth error, largest", "m", 3, "less", "Believed minus reference"),
    ("cross_track_error_rms_m", "cross-track RMS", "m", 3, "less", "From the path or approach line"),
    ("heading_error_rms_deg", "heading error RMS", "°", 2, "less", "Believed minus reference"),
    ("speed_error_rms_mps", "speed error RMS", "m/s", 3, "less", "Surge over ground, minus reference"),
    ("depth_rms_m", "depth RMS about its mean", "m", 3, "less", "The paper's figure"),
    ("pitch_rms_deg", "pitch RMS about its mean", "°", 3, "less", "The paper's figure"),
    ("residual_rms", "residual RMS", "", 4, "less", "Size of tau_d - tau_c in the mode"),
)


def _of_modes() -> Iterable[Figure]:
    for mode in MODES:
        look = LOOKS[mode]
        for name, label, unit, decimals, better, about in _OF_A_MODE:
            yield Figure(f"{look.key}.{name}", f"{look.letter}: {label}", unit, decimals, better, about)  # type: ignore[arg-type]


FIGURES: dict[str, Figure] = {figure.key: figure for figure in (*_WHOLE, *_of_modes())}


def moments(metrics: Metrics) -> dict[str, float]:
    """Mission times that runs can be laid over each other at: start, first switches, end; s."""
    found = {"start": 0.0}
    for switch in metrics.get("switches") or ():
        to = pb.Mode.Value(switch.get("to_mode", "MODE_UNSPECIFIED"))
        at = _number(switch.get("time_s"))
        if to in LOOKS and at is not None:
            found.setdefault(LOOKS[to].key, at)
    end = _number(metrics.get("duration_s"))
    return found if end is None else found | {"end": end}


def _number(value: Any) -> float | None:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None
