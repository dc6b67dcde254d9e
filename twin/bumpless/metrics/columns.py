"""The columns of a run that its figures are made of."""

from collections.abc import Sequence
from dataclasses import Field, dataclass, fields, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
import numpy.typing as npt

from bumpless.contract.enums import FLYING
from bumpless.contract.units import EDGE_PER_SI

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

GAP_S = 0.5  # cycles missing for less are no gap to tell of
FLOWN = (0, *FLYING)  # phases whose rows count; 0: not said
MOST_ODD = 10  # cycles at the end with a number that is none: more are no slip any more


@dataclass(frozen=True)
class DockColumns:
    """How the hull meets a dock to enter; all but `captured` is truth, NaN where nobody knew it."""

    captured: Integers  # (n,) 1: its latch has closed
    contact_force: Floats  # (n,) N, largest sum of normal forces since the row before
    contact_most: Floats  # (n,) N, what dock and hull bear
    nose_depth: Floats  # (n,) m, of the nose behind its entry
    nose_offset: Floats  # (n,) m, of the nose from its axis

    @classmethod
    def from_rows(cls, rows: npt.NDArray[Any]) -> Self | None:
        """From LOG rows; None where there is no dock to enter."""
        if "contact_most" not in (rows.dtype.names or ()) or not np.any(rows["contact_most"] > 0.0):
            return None
        return cls(**{f.name: np.array(rows[f.name]) for f in fields(cls)})


@dataclass(frozen=True)
class Columns:
    """One row per control cycle (n rows, n_u actuators), named and scaled as in `sim.log.LOG`.

    Only cycles in which the mission ran are kept. Columns of truth are NaN where nobody knew it, those of
    the docking automaton 0 where there is none.
    """

    time: Floats  # (n,) s since mission start
    cycle: Integers  # (n,)
    mode: Integers  # (n,) FORWARD, REVERSE, HOVER
    kappa: Floats  # (n,)
    range: Floats  # (n,) m, to the observation point
    depth: Floats  # (n,) m, measured
    eta_hat: Floats  # (n, 6) m and rad
    nu_hat: Floats  # (n, 6) m/s and rad/s
    nu_r_hat: Floats  # (n, 3) velocity through water, body
    reference: Floats  # (n, 6) [u_d v_d z_d phi_d theta_d psi_d]
    cross_track: Floats  # (n,) m, as believed
    tau_d: Floats  # (n, 6) N and N m
    tau_plus: Floats  # (n, 6)
    tau_minus: Floats  # (n, 6)
    tau_c: Floats  # (n, 6) by the allocator's model
    tau: Floats  # (n, 6) the plant's true wrench
    observation_point: Floats  # (n, 3) NED, as believed
    target: Floats  # (n, 4) believed position NED, m, and approach heading, rad
    eta: Floats  # (n, 6) truth
    nu: Floats  # (n, 6) truth
    target_true: Floats  # (n, 3) truth
    stage: Integers  # (n,) DockingStage; 0 where the published automaton flies
    tried: Integers  # (n,) approaches begun
    reason: Integers  # (n,) WaveOffReason of the last wave-off; 0: none yet
    approach: Floats  # (n,) approach heading in use, rad; where `stage` is not 0
    u: Floats  # (n, n_u) commands, rad or rev/s
    u_feedback: Floats  # (n, n_u) as measured
    du_max: Floats  # (n, n_u) increment bound of the cycle
    status: Integers  # (n,) SolveStatus
    solve_time: Floats  # (n,) s
    dock: DockColumns | None = None  # where there is a dock to enter
    lost: bool = False  # after the last row the vehicle's state was no number any more, up to the end

    @classmethod
    def from_log(cls, log: npt.NDArray[Any], n_u: int) -> Self:
        """From an array of LOG rows; rows outside the mission are left out."""
        flown = np.isin(log["phase"], FLOWN)
        rows = log if flown.all() else log[flown]  # a mask copies whole rows, and columns are copied below
        named = log.dtype.names or ()
        absent: Any = np.zeros(len(rows), np.int64)
        columns: dict[str, Any] = {
            f.name: np.array(rows[f.name] if f.name in named else absent) for f in cls.numbers()
        }
        for name in ("u", "u_feedback", "du_max"):
            columns[name] = columns[name][:, :n_u]
        return cls(**columns, dock=DockColumns.from_rows(rows))

    @classmethod
    def numbers(cls) -> "list[Field[Any]]":
        """The fields that have one row per cycle, but for those of a dock."""
        return [f for f in fields(cls) if f.name not in ("dock", "lost")]

    def rows(self, chosen: npt.NDArray[np.bool_]) -> Self:
        """Those of `chosen` (n,) alone."""
        if chosen.all():
            return self
        dock = self.dock and DockColumns(*(getattr(self.dock, f.name)[chosen] for f in fields(DockColumns)))
        return replace(self, **{f.name: getattr(self, f.name)[chosen] for f in self.numbers()}, dock=dock)

    def as_told(self, units: Sequence[str]) -> Self:
        """The same after its way over the bus, in deg and rpm: what a log holds, to the bit.

        A cycle in which the vehicle said a number that is none is not in it. units: of each actuator's
        command, "deg" or "rpm".
        """
        return self._turned(units)._finite()

    def _finite(self) -> Self:
        told = [getattr(self, name) for name in TOLD]
        if np.isfinite(sum(float(column.sum()) for column in told)):
            return self
        whole = np.all([np.isfinite(column.reshape(len(self), -1)).all(1) for column in told], axis=0)
        odd = len(self) - 1 - int(np.flatnonzero(whole)[-1]) if whole.any() else len(self)
        return replace(self.rows(whole), lost=odd > MOST_ODD)

    def _turned(self, units: Sequence[str]) -> Self:
        edge = np.array([EDGE_PER_SI[unit] for unit in units])
        turned = ("eta_hat", "nu_hat", "reference", "eta", "nu")
        angles = {name: getattr(self, name).copy() for name in turned}
        for values in angles.values():
            values[:, 3:] = np.radians(values[:, 3:] * EDGE_PER_SI["deg"])
        target = self.target.copy()
        target[:, 3] = np.radians(target[:, 3] * EDGE_PER_SI["deg"])
        return replace(
            self,
            u=self.u * edge / edge,
            u_feedback=self.u_feedback * edge / edge,
            du_max=self.du_max * edge / edge,
            approach=np.radians(self.approach * EDGE_PER_SI["deg"]),
            solve_time=self.solve_time * 1e6 * 1e-6,
            target=target,
            **angles,
        )

    @cached_property
    def heading(self) -> Floats:
        """(n,) approach heading, rad: the one in use, or the target's own."""
        return np.where(self.stage != 0, self.approach, self.target[:, 3])

    def __len__(self) -> int:
        return len(self.time)

    @cached_property
    def follows(self) -> npt.NDArray[np.bool_]:
        """(n,) whether the row before is the cycle before; False for the first row and after a gap."""
        first = np.zeros(min(len(self), 1), bool)
        return np.concatenate([first, np.diff(self.cycle) == 1])

    @property
    def gaps(self) -> list[tuple[float, float]]:
        """(last time before, first time after) of each stretch longer than GAP_S without a row, s."""
        ends = np.flatnonzero(~self.follows[1:] & (np.diff(self.time) > GAP_S))
        return [(float(self.time[k]), float(self.time[k + 1])) for k in ends]

    @property
    def missing(self) -> int:
        """Cycles between the first and the last that are not in the log."""
        return int(self.cycle[-1] - self.cycle[0] + 1 - len(self)) if len(self) else 0


# what a vehicle itself says in each cycle, and not whoever knows the truth
TOLD = (
    "time", "kappa", "range", "depth", "eta_hat", "nu_hat", "nu_r_hat", "reference", "cross_track", "tau_d",
    "tau_plus", "tau_minus", "tau_c", "observation_point", "target", "approach", "u", "u_feedback", "du_max",
    "solve_time",
)  # fmt: skip


def dots(a: Floats, b: Floats) -> Floats:
    """(n,) scalar products of the rows of a and b (n, k), as NumPy's to the bit.

    By columns, for NumPy takes rows of a few numbers one after the other: a third of the time.
    """
    if a.shape[1] >= 8:  # from there on it sums in another order
        return np.sum(a * b, axis=1)
    total = a[:, 0] * b[:, 0]
    for k in range(1, a.shape[1]):
        total += a[:, k] * b[:, k]
    return total


def lengths(vectors: Floats) -> Floats:
    """(n,) length of each row of (n, k)."""
    return np.sqrt(dots(vectors, vectors))
