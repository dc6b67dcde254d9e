"""What turns a LOG row into messages besides the row itself: names, units, bounds, thresholds."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.units import EDGE_PER_SI

if TYPE_CHECKING:
    from bumpless.config.parameters import DockingParameters, Parameters, SupervisorParameters
    from bumpless.config.vehicle import Vehicle


@dataclass(frozen=True)
class ActuatorContext:
    """One command at the edge: in `unit`, as its amplitude bounds."""

    name: str
    unit: str  # "deg" or "rpm"
    scale: float  # `unit` per rad or per rev/s
    lower: float
    upper: float
    first: int  # the actuator's first command, where its effectiveness stands

    @property
    def tolerance(self) -> float:
        """Closer than this to a bound is at the bound, `unit`."""
        return 1e-6 * (self.upper - self.lower)


@dataclass(frozen=True)
class Context:
    """Constant between two changes of parameters; build it with `make_context`."""

    actuators: tuple[ActuatorContext, ...]
    supervisor: "SupervisorParameters"
    docking: "DockingParameters"
    solver: str
    period_s: float  # of control
    start_time_ns: int = 0  # UNIX time of mission time 0, for rows that carry no time of their own

    @cached_property
    def nameplates(self) -> pb.Actuators:
        """What never changes about the actuators, to be merged into each message."""
        return pb.Actuators(
            actuators=[
                pb.Actuator(name=a.name, unit=a.unit, amplitude_lower=a.lower, amplitude_upper=a.upper)
                for a in self.actuators
            ]
        )

    @cached_property
    def thresholds(self) -> pb.Supervisor:
        """The supervisor's thresholds, to be merged into each message."""
        s = self.supervisor
        return pb.Supervisor(
            range_rh_lower_m=s.range_rh_lower_m,
            range_rh_upper_m=s.range_rh_upper_m,
            range_fr_lower_m=s.range_fr_lower_m,
            range_fr_upper_m=s.range_fr_upper_m,
            range_hf_upper_m=s.range_hf_upper_m,
        )

    def with_parameters(self, parameters: "Parameters") -> "Context":
        """The same vehicle flying with other parameters."""
        return replace(
            self, supervisor=parameters.supervisor, docking=parameters.docking, solver=_solver(parameters)
        )


def make_context(vehicle: "Vehicle", parameters: "Parameters", start_time_ns: int = 0) -> Context:
    """The context of a vehicle that flies with `parameters`."""
    owners = [command.actuator for command in vehicle.commands]
    actuators = tuple(
        ActuatorContext(c.name, c.unit, EDGE_PER_SI[c.unit], c.lower, c.upper, owners.index(c.actuator))
        for c in vehicle.commands
    )
    return Context(
        actuators,
        parameters.supervisor,
        parameters.docking,
        _solver(parameters),
        vehicle.control_period_s,
        start_time_ns,
    )


def _solver(parameters: "Parameters") -> str:
    allocation = parameters.allocation
    return f"{allocation.allocator}/{allocation.solver}"
