"""Which allocator runs, how hard it tries, and what it does about faults."""

from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, Row, Switch, model
from bumpless.config.names import ERRORS, WRENCH
from bumpless.config.parameters.modes import PER_WRENCH

Allocator = Literal["mdca", "wls", "pid_direct"]
Solver = Literal["osqp", "active_set", "daqp"]
Effectiveness = Literal["known", "estimated"]
DirectMap = Literal["thrust", "shaft_speed", "thrust_in_flow"]
ONES = (1.0,) * 6


def factors(label: str, max: float, names: tuple[str, ...], record: str) -> Row:
    """Factors that a fault-tolerant allocator applies once a fault is known."""
    return Row(f"Factors on {label} after a known fault", "", 0.0, max, names=names, record=record)


@model
class AllocationParameters:
    """Which allocator runs and how hard it tries. Source: Gao et al. 2026, eqs. (45)-(52)."""

    allocator: Annotated[Allocator, Choice("Allocator", record="allocator")] = "mdca"
    solver: Annotated[Solver, Choice("Solver of the quadratic programs")] = "osqp"
    sqp_iterations: Annotated[int, Number("SQP iterations per cycle", "", 1, 50, record="sqp_iterations")] = 8
    kkt_tolerance: Annotated[
        float,
        Number("KKT residual that counts as solved", "", 1e-12, 1.0, record="kkt_tolerance",
               help="Of the projected gradient in bound-normalised commands."),
    ] = 1e-8  # fmt: skip
    fault_tolerant: Annotated[
        bool,
        Switch("Fault tolerance", record="fault_tolerant",
               help="Allocate with the degraded map and softened constraints."),
    ] = False  # fmt: skip
    effectiveness: Annotated[
        Effectiveness,
        Choice("Where the effectiveness comes from", record="estimate",
               help="Told of faults, or estimating them from residuals."),
    ] = "known"  # fmt: skip
    fault_evidence: Annotated[
        float, Number("Log-likelihood ratio that makes a fault", "", 3.0, 1000.0, record="fault_evidence")
    ] = 10.0
    effectiveness_blend_s: Annotated[
        float,
        Number("Blend of an estimated loss", "s", 0.0, 60.0, record="effectiveness_blend",
               help="Time over which it reaches the allocator."),
    ] = 2.0  # fmt: skip
    anti_windup_per_s: Annotated[
        float, Number("Residual fed back into the integrals", "1/s", 0.0, 100.0, record="anti_windup")
    ] = 1.0
    increment_price: Annotated[
        float,
        Number("Price of increments", "", 0.0, 1e6, record="increment_price",
               help="Weight of ‖u - u_prev‖², commands over their bounds; 0 as published."),
    ] = 0.0  # fmt: skip
    saddle_escapes: Annotated[
        int, Number("Looks for a way out of a saddle, per cycle", "", 0, 10, record="escapes")
    ] = 3
    fins_brake: Annotated[
        bool,
        Switch("Fins may brake",
               help="Off: the allocator takes their drag as given; it goes to the vehicle's model."),
    ] = True  # fmt: skip
    shaft_smoothing: Annotated[
        float,
        Number("Thrust share eased through zero", "", 0.0, 1.0,
               help="Below it a screw is eased through zero; it goes to the vehicle's model."),
    ] = 0.0  # fmt: skip
    direct_map: Annotated[
        DirectMap,
        Choice("What pid_direct maps the demand to", record="direct_map",
               help="To thrust, straight to shaft speed, or to thrust with what the inflow takes made up."),
    ] = "thrust"  # fmt: skip
    degraded_map: Annotated[
        bool,
        Switch(
            "Degraded map", record="degraded_map", help="Fault tolerance: use the effectiveness as it is."
        ),
    ] = True
    priority: Annotated[tuple[float, ...], factors("Q", 1e6, WRENCH, "priority")] = ONES
    slack_price: Annotated[
        tuple[float, ...],
        Row("P, price of slack; 0 allows none", PER_WRENCH, 0.0, 1e9, names=WRENCH, record="slack_price"),
    ] = (0.0,) * 6
    easing_made_up: Annotated[
        bool,
        Switch("Eased thrust is made up", record="easing_made_up",
               help="Thrust that eased screws missed is asked for in the next cycle."),
    ] = False  # fmt: skip
    fault_kp: Annotated[tuple[float, ...], factors("K_P", 100.0, ERRORS, "fault_gains[0]")] = ONES
    fault_ki: Annotated[tuple[float, ...], factors("K_I", 100.0, ERRORS, "fault_gains[1]")] = ONES
    fault_kd: Annotated[tuple[float, ...], factors("K_D", 100.0, ERRORS, "fault_gains[2]")] = ONES
