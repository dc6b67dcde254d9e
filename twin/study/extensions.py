"""What our design adds to the published method, each with what it does and how to switch it off alone.

`off` lays the published behaviour over the design; `twin.study.ablation` flies with each of them.
All scenarios share them where they have a meaning, the baselines S1 to S3 included; the priced ramp
belongs to bumpless switching and so to S4 to S6 only.
"""

from dataclasses import dataclass

from twin.study.scenarios import Overrides

_NONE = [0.0] * 6


@dataclass(frozen=True)
class Extension:
    """One addition to the method."""

    name: str
    about: str
    shared: bool  # by S1, S2 and S3
    off: Overrides


EXTENSIONS: tuple[Extension, ...] = (
    Extension(
        "priced ramp",
        "while kappa < 1 the allocator pays for increments, (1 - kappa) mu ||x - x_prev||^2, so that neither "
        "noise nor fins used as brakes shake the commands in a transition",
        False,
        {"bumpless": {"ramp_increment_price": 0.0}},
    ),
    Extension(
        "smooth shaft reversal",
        "a screw passes through zero thrust with finite slope, since n = sqrt(T) has none",
        True,
        {"allocation": {"shaft_smoothing": 0.0}},
    ),
    Extension(
        "slow flow",
        "the allocator sees a lagged flow, so that noise of the velocity log does not move the fins",
        True,
        {"guidance": {"flow_filter_s": 0.0}},
    ),
    Extension(
        "passive fin damping",
        "turning rates are left out of the allocator's flow: what fins do against turning stays damping",
        True,
        {"guidance": {"flow_rates": 1.0}},
    ),
    Extension(
        "smoothed errors",
        "first-order lags on e and e' in front of the PID",
        True,
        {"guidance": {"error_filter_s": _NONE, "rate_filter_s": _NONE}},
    ),
    Extension(
        "scheduled limits",
        "integral and demand limits of fin channels follow the gain schedule, as the fins' authority does",
        True,
        {"guidance": {"schedule_limits": False}},
    ),
    Extension(
        "current-aware guidance",
        "the estimated current is made good by a crab angle, an approach speed above the drift and, in H, a "
        "heading along the current; the heading reference turns at a limited rate",
        True,
        {"guidance": {"crab_gain": 0.0, "heading_rate_degps": 0.0}},
    ),
)
