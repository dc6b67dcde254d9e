"""What our design adds to the published method, each with what it does and how to switch it off alone.

`off` lays the published behaviour over the design; `bumpless_paper.study.ablation` flies with each of them.
All scenarios share them where they have a meaning, the baselines S1 to S3 included. The priced ramp belongs
to bumpless switching and so to S4 to S7 only, what makes easing up to the constrained allocator and so to S3
to S7, gains after a fault to S6 and S7.
"""

from dataclasses import dataclass

from bumpless_paper.study.scenarios import Overrides

_NONE, _SAME = [0.0] * 6, [1.0] * 6
_ALL = ("S1", "S2", "S3", "S4", "S5", "S6", "S7")


@dataclass(frozen=True)
class Extension:
    """One addition to the method."""

    name: str
    about: str
    by: tuple[str, ...]  # the scenarios that fly with it
    off: Overrides


EXTENSIONS: tuple[Extension, ...] = (
    Extension(
        "priced ramp",
        "while kappa < 1 the allocator pays for increments of the commands over their bounds, "
        "(1 - kappa) mu ||u - u_prev||^2, so that neither noise, nor fins used as brakes, nor a screw that "
        "reverses shakes them in a transition",
        _ALL[3:],
        {"bumpless": {"ramp_increment_price": 0.0}},
    ),
    Extension(
        "smooth shaft reversal",
        "a screw passes through zero thrust with finite slope, since n = sqrt(T) has none",
        _ALL,
        {"allocation": {"shaft_smoothing": 0.0}},
    ),
    Extension(
        "slow flow",
        "the allocator sees a lagged flow, so that noise of the velocity log does not move the fins",
        _ALL,
        {"guidance": {"flow_filter_s": 0.0}},
    ),
    Extension(
        "easing made up for",
        "thrust that the smooth reversal missed is asked for in the next cycle, the more the farther the "
        "screw is from zero, as the map's inflow term is one cycle old",
        _ALL[2:],
        {"allocation": {"easing_made_up": False}},
    ),
    Extension(
        "smoothed errors",
        "first-order lags on e and e' in front of the PID",
        _ALL,
        {"guidance": {"error_filter_s": _NONE, "rate_filter_s": _NONE}},
    ),
    Extension(
        "scheduled limits",
        "integral and demand limits of fin channels follow the gain schedule, as the fins' authority does",
        _ALL,
        {"guidance": {"schedule_limits": False}},
    ),
    Extension(
        "current-aware guidance",
        "the estimated current is made good by a crab angle, an approach speed above the drift and, in H, a "
        "heading along the current; the heading reference turns at a limited rate",
        _ALL,
        {"guidance": {"crab_gain": 0.0, "heading_rate_degps": 0.0}},
    ),
    Extension(
        "gains after a fault",
        "once a fault is known, pitch and yaw are flown with larger K_P and K_D, surge with a smaller K_I: "
        "fins are used to their limits and the weakened screw does not make the vehicle lose its flow",
        _ALL[5:],
        {"allocation": {"fault_kp": _SAME, "fault_ki": _SAME, "fault_kd": _SAME}},
    ),
)
