"""What identification reads of a flight: what a vehicle at sea knows of itself, nothing of the truth."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle import Vehicle
from bumpless.contract.enums import CAPTURED, CREEP
from bumpless.contract.units import EDGE_PER_SI

if TYPE_CHECKING:
    from bumpless.runs.run import Run

Array = NDArray[np.float64]
TOUCHING = ("CREEP", "CAPTURED")  # the same in the contract's words


@dataclass(frozen=True)
class Flight:
    """One row per control cycle, n rows, in SI and radians."""

    cycle: NDArray[np.int64]  # (n,)
    eta: Array  # (n, 6) pose as estimated
    nu: Array  # (n, 6) velocity over ground as estimated
    current: Array  # (n, 3) NED, as estimated
    u: Array  # (n, 8) measured states of the actuators, unused slots zero
    disturbed: NDArray[np.bool_]  # (n,) after a fault that the autopilot knew of, or where a dock may touch

    @classmethod
    def from_log(cls, rows: NDArray[Any], n_u: int) -> Self:
        """From LOG rows of a vehicle with n_u commands."""
        faulty = (rows["faults"] != 0) | np.any(rows["effectiveness_hat"][:, :n_u] < 1.0, axis=1)
        touching = np.isin(rows["stage"], (CREEP, CAPTURED))
        names = ("cycle", "eta_hat", "nu_hat", "current_hat", "u_feedback")
        columns = (np.ascontiguousarray(rows[name]) for name in names)
        return cls(*columns, disturbed=_from_then_on(faulty) | touching)

    @classmethod
    def from_table(cls, table: Mapping[str, NDArray[Any]], vehicle: Vehicle) -> Self:
        """From `Run.table`. Raises: ValueError when the log lacks one of the columns."""
        try:
            return cls._of(table, vehicle)
        except KeyError as error:
            raise ValueError(f"the log has no column {error}") from error

    @classmethod
    def _of(cls, table: Mapping[str, NDArray[Any]], vehicle: Vehicle) -> Self:
        def vector(path: str, names: str = "x y z") -> Array:
            return np.stack([table[f"navigation.{path}{name}"] for name in names.split()], axis=1)

        angles = np.radians(vector("attitude.", "roll_deg pitch_deg yaw_deg"))
        rates = np.radians(vector("angular_rate_body_degps."))
        u, faulty = np.zeros((len(table["cycle"]), 8)), np.zeros(len(table["cycle"]), bool)
        for i, command in enumerate(vehicle.commands):
            u[:, i] = table[f"actuators.{command.name}.feedback_{command.unit}"] / EDGE_PER_SI[command.unit]
            faulty |= table[f"actuators.{command.name}.faulty"] == 1
            faulty |= table[f"actuators.{command.name}.effectiveness"] < 1.0
        return cls(
            cycle=table["cycle"],
            eta=np.hstack([vector("position_ned_m."), angles]),
            nu=np.hstack([vector("velocity_body_mps."), rates]),
            current=vector("current_estimate_ned_mps."),
            u=u,
            disturbed=_from_then_on(faulty) | np.isin(table["supervisor.docking_stage"], TOUCHING),
        )

    def __len__(self) -> int:
        return len(self.cycle)

    def __getitem__(self, rows: slice | NDArray[np.bool_]) -> "Flight":
        """Some of its rows."""
        return Flight(**{name: np.ascontiguousarray(column[rows]) for name, column in vars(self).items()})

    @property
    def usable(self) -> "Flight":
        """Without what isn't finite or is disturbed: neither a fault's loss nor a dock's force is a scale."""
        numbers = np.hstack([self.eta, self.nu, self.current, self.u])
        return self[np.isfinite(numbers).all(axis=1) & ~self.disturbed]


def flight_of(run: "Run") -> Flight:
    """The flight of a run that was flown or opened.

    Raises: ValueError when its log doesn't hold what it takes.
    """
    if run.vehicle is None:
        raise ValueError("the log describes no vehicle that can be read")
    return Flight.from_table(run.table(), run.vehicle)


def _from_then_on(known: NDArray[np.bool_]) -> NDArray[np.bool_]:
    return np.maximum.accumulate(known) if len(known) else known
