"""The parameters themselves: frozen dataclasses, named after the keys of the vehicle file.

Wrench order is [X Y Z K M N], error order [u v z phi theta psi], actuators in the vehicle file's
order. Commands in R are divided by their amplitude bounds, so its weights carry no unit.
"""

from dataclasses import dataclass
from typing import Literal

Allocator = Literal["mdca", "wls", "pid_direct"]
Solver = Literal["osqp", "active_set", "daqp"]
Effectiveness = Literal["known", "estimated"]
DirectMap = Literal["thrust", "shaft_speed"]
IntegralAtSwitch = Literal["keep", "rescale", "reset"]
PathLaw = Literal["alos", "aalos_fossen2024"]


@dataclass(frozen=True)
class ModeParameters:
    """One mode's weights and gains.

    Source: Gao et al. 2026, eq. (44) for the gains, eqs. (45)-(52) for {Q, R, lambda},
    eq. (54) for N_sw.
    """

    q_diagonal: tuple[float, ...]  # diagonal of Q, shape (6,), 1/N^2 or 1/(N m)^2
    r_diagonal: tuple[float, ...]  # diagonal of R, shape (n_u,)
    lambda_: float  # written `lambda` in files
    ramp_cycles: int  # N_sw of a switch into this mode
    kp: tuple[float, ...]  # diagonal of K_P, shape (6,), N or N m per m/s, m or rad
    ki: tuple[float, ...]  # diagonal of K_I, shape (6,), the same per second
    kd: tuple[float, ...]  # diagonal of K_D, shape (6,), the same times second
    integral_limit: tuple[float, ...]  # bound of |K_I e_I|, shape (6,), N or N m
    demand_limit: tuple[float, ...]  # bound of |tau_d|, shape (6,), N or N m
    increment_share: float = 1.0  # of the rate limits that this mode may use; ramps as Q, R, lambda do


@dataclass(frozen=True)
class SupervisorParameters:
    """When modes change: d_RH^L < d_RH^U < d_FR^L < d_FR^U < d_HF^U, and the detection filter.

    Source: Gao et al. 2026, eq. (53). The filter (M of N, then hold) stands in front of chi and
    counts camera frames; 1 of 1 with no hold gives the published automaton.
    """

    range_rh_lower_m: float
    range_rh_upper_m: float
    range_fr_lower_m: float
    range_fr_upper_m: float
    range_hf_upper_m: float
    dwell_cycles: int  # N_dwell
    detection_hits: int  # M
    detection_window: int  # N
    detection_hold_cycles: int  # camera frames for which chi stays 1 after the filter last passed


@dataclass(frozen=True)
class BumplessParameters:
    """Each switching mechanism on its own, and how integrators are aligned.

    Source: Gao et al. 2026, eqs. (54)-(57); aligned are depth and heading there, and nothing bleeds.
    Differs: other channels may be aligned too, the aligned offset may decay, and integration may be
    scaled by kappa during the ramp; what happens to integrals that are not aligned is chosen; the ramp may
    tighten the increment bound or price increments.
    """

    ramp: bool = True
    integrator_alignment: bool = True
    warm_start_projection: bool = True
    align_channels: tuple[float, ...] = (0.0, 0.0, 1.0, 0.0, 0.0, 1.0)  # 1 where aligned, shape (6,)
    align_bleed_s: float = 0.0  # time constant of the aligned offset's decay; 0 keeps it
    scale_integration: bool = False
    integral_at_switch: IntegralAtSwitch = "keep"  # K_I e_I kept, e_I kept (so K_I e_I rescaled), or reset
    ramp_increment_share: float = 1.0  # of du_max at kappa = 0, growing to 1 with kappa^4
    ramp_increment_price: float = 0.0  # weight of ||u - u_prev||^2 at kappa = 0, fading with kappa


@dataclass(frozen=True)
class AllocationParameters:
    """Which allocator runs and how hard it tries. Source: Gao et al. 2026, eqs. (45)-(52)."""

    allocator: Allocator = "mdca"
    solver: Solver = "osqp"
    sqp_iterations: int = 8
    kkt_tolerance: float = 1e-8  # of the projected gradient in bound-normalised commands
    fault_tolerant: bool = False  # allocate with the degraded map and softened constraints
    effectiveness: Effectiveness = "known"  # told of faults, or estimating them from residuals
    fault_evidence: float = 10.0  # log-likelihood ratio from which an estimated loss is a fault
    effectiveness_blend_s: float = 2.0  # over which an estimated loss reaches the allocator
    anti_windup_per_s: float = 1.0  # feedback of the allocation residual into the integrals
    increment_price: float = 0.0  # weight of ||u - u_prev||^2, commands over their bounds
    shaft_smoothing: float = 0.0  # thrust share below which a screw is eased through zero
    direct_map: DirectMap = "thrust"  # pid_direct: demand to thrust, or straight to shaft speed
    degraded_map: bool = True  # fault tolerance: use the effectiveness as it is
    priority: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # fault tolerance: factors on Q, shape (6,)
    slack_price: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)  # fault tolerance: P; 0 allows no slack
    easing_made_up: bool = False  # thrust that eased screws missed is asked for in the next cycle
    fault_kp: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # fault tolerance: factors on K_P, (6,)
    fault_ki: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # on K_I
    fault_kd: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0)  # on K_D


@dataclass(frozen=True)
class GuidanceParameters:
    """How references are made, and how gains follow speed.

    Source: Gao et al. 2026, eqs. (41)-(44); the speed laws are ours.
    """

    law: PathLaw = "alos"
    look_ahead_m: float = 5.0  # Delta
    adaptation_gain: float = 0.002  # gamma, 1/s
    depth_rate_mps: float = 0.02  # the depth reference moves no faster
    pitch_look_ahead_m: float = 0.0  # depth by pitch, as a vehicle without heave needs it; 0: by heave
    pitch_adaptation_gain: float = 0.01  # 1/s, how fast the trim pitch is learnt
    pitch_max_deg: float = 20.0
    speed_min_mps: float = 0.0  # no slower surge reference: below it the fins do not steer
    acceleration_mps2: float = 0.05  # nor does the speed reference
    reverse_speed_slope_per_s: float = 0.08  # u_d = slope * range + offset, at most the maximum
    reverse_speed_offset_mps: float = 0.08
    reverse_speed_max_mps: float = 0.4
    hover_speed_gain_per_s: float = 0.1  # u_d = gain * along-track error, within +-maximum
    hover_speed_max_mps: float = 0.1
    hover_cross_gain: float = 0.5  # share of the cross-track law kept in hover, scaled by the inflow
    schedule_speed_mps: float = 0.3  # speed through water above which scheduled channels get full gain
    schedule_min: float = 0.2  # least share of their gain
    scheduled_channels: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0, 1.0, 1.0)  # 1 where scheduled, shape (6,)
    schedule_limits: bool = False  # integral and demand limits of scheduled channels follow speed as well
    flow_filter_s: float = 0.0  # lag on the velocity through water that schedule and allocator see
    flow_drift: float = 1.0  # share of v, w in that flow: fins steady the hull unless the allocator undoes it
    flow_rates: float = 1.0  # share of p, q, r in that flow: fins damp turning unless the allocator undoes it
    heading_rate_degps: float = 0.0  # the heading reference turns no faster; 0: no limit
    crab_gain: float = 0.0  # share of the estimated drift that the heading makes good at once
    error_filter_s: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)  # lag on e before the PID, shape (6,)
    rate_filter_s: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)  # lag on e', shape (6,)


@dataclass(frozen=True)
class Parameters:
    """Everything the autopilot is tuned with."""

    forward: ModeParameters
    reverse: ModeParameters
    hover: ModeParameters
    supervisor: SupervisorParameters
    bumpless: BumplessParameters
    allocation: AllocationParameters
    guidance: GuidanceParameters

    @property
    def modes(self) -> tuple[ModeParameters, ModeParameters, ModeParameters]:
        """In the order of records.FORWARD, REVERSE, HOVER."""
        return self.forward, self.reverse, self.hover
