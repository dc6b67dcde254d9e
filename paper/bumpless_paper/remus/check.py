"""The pipeline fed with the REMUS geometry against the thesis that the method comes from.

`remus_check()` gives one row per published coefficient: ours, theirs, their ratio, and for each deviation
beyond 5 % the reason, with what our pipeline gives under another reading of the thesis, if there is one.
The twin's own arrangement differs from the thesis (Munk's moment sits in C_A, fin forces in the actuators);
here the thesis' combined coefficients are put together again.

Source: Prestero 2001, chapter 4 and its tables.
"""

import json
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.config.vehicle.parts import Fin, MyringHull
from bumpless.contract.units import WRENCH
from bumpless.physics.hydrodynamics.coefficients import Coefficients, hull_coefficients
from bumpless.physics.hydrodynamics.drag import fin_cross_flow_drag
from bumpless.physics.hydrodynamics.published import bilinear, fin_lift, flow_force
from bumpless_paper.remus.notes import Reason, reason_of

PUBLISHED = Path(__file__).with_name("published.json")
TOLERANCE = 0.05
RATES = "uvwpqr"
Array = NDArray[np.float64]


@dataclass(frozen=True)
class Row:
    """One coefficient, SI. Without `reason` when ours and theirs agree within TOLERANCE.

    reread: ours under the reason's other reading of the thesis; None where it has none.
    """

    name: str
    ours: float
    theirs: float
    reason: Reason | None = None
    reread: float | None = None

    @property
    def ratio(self) -> float:
        """Ours over theirs."""
        return self.ours / self.theirs

    @property
    def agrees(self) -> bool:
        """Whether the two differ by at most TOLERANCE."""
        return abs(self.ratio - 1.0) <= TOLERANCE

    @property
    def explained(self) -> bool:
        """Whether the other reading gives the printed value within TOLERANCE."""
        return self.reread is not None and abs(self.reread / self.theirs - 1.0) <= TOLERANCE

    @property
    def unit(self) -> str:
        """kg times a power of m: N or N m over what the coefficient multiplies, radians left out."""
        linear = sum(self.name[2:].count(rate) for rate in "uvw")
        power = (1 if self.name[0] in "XYZ" else 2) - linear
        return {-1: "kg/m", 0: "kg", 1: "kg·m", 2: "kg·m²"}[power]


def remus_check(vehicle: Vehicle | None = None) -> tuple[Row, ...]:
    """All rows, in the order of the published table; the shipped `remus100` unless another is given."""
    vehicle = vehicle or load_vehicle("remus100")
    published = json.loads(PUBLISHED.read_text(encoding="utf-8"))["coefficients"]
    ours = {name: thesis_coefficient(vehicle, name) for name in published}
    return tuple(_row(vehicle, name, ours[name], theirs) for name, theirs in published.items())


def _row(vehicle: Vehicle, name: str, ours: float, theirs: float) -> Row:
    reason = reason_of(name)
    if reason is None or abs(ours / theirs - 1.0) <= TOLERANCE:
        return Row(name, ours, theirs)
    if not reason.reading:
        return Row(name, ours, theirs, reason)
    return Row(name, ours, theirs, reason, reason.factor * thesis_coefficient(reason.read(vehicle), name))


def thesis_coefficient(vehicle: Vehicle, name: str) -> float:
    """A coefficient by its name: row, then what it multiplies: X_udot, Y_vv (v|v|), M_uw (u w), Y_uudr."""
    coefficients = hull_coefficients(by_form(vehicle))
    fins = [a for a in vehicle.actuators if isinstance(a, Fin)]
    rho = vehicle.environment.water_density_kgpm3
    row, term = WRENCH.index(name[0]), name[2:]
    if term.endswith("dot"):
        return -coefficients.M_A[row, RATES.index(term[0])]
    if term.startswith("uud"):  # rudder: horizontal plane; stern plane: vertical plane, down for nose down
        side = 1 if term == "uudr" else -1
        return side * float(fin_lift(fins, rho)[row, 1 if side > 0 else 2])
    a, b = (RATES.index(rate) for rate in term)
    if a == b and not (row == 0 and a > 0):
        drag = coefficients.D_quadratic + fin_cross_flow_drag(fins, rho)
        return -drag[row, a]
    return bilinear(lambda nu: _bilinear_force(coefficients, fins, rho, nu)[row], a, b)


def _bilinear_force(c: Coefficients, fins: list[Fin], rho: float, nu: Array) -> Array:
    """-C_A(nu) nu, body lift and fin lift without deflection, in forward flow: all terms nu_a nu_b."""
    return flow_force(c.M_A, fins, rho, nu) - nu[0] * (c.D_lift @ nu)


def by_form(vehicle: Vehicle) -> Vehicle:
    """The vehicle with what strip theory makes of its form, not with coefficients that its file states."""
    if not isinstance(vehicle.hull, MyringHull) or vehicle.hull.coefficients is None:
        return vehicle
    return replace(vehicle, hull=replace(vehicle.hull, coefficients=None))


def table() -> str:
    """The comparison as text, one line per coefficient."""
    lines = [f"{'':8}{'ours':>10}{'thesis':>10}{'ratio':>8}"]
    for row in remus_check():
        letter = row.reason.letter if row.reason else ""
        lines.append(f"{row.name:8}{row.ours:10.4g}{row.theirs:10.4g}{row.ratio:8.3f}  {letter}".rstrip())
    return "\n".join(lines)


if __name__ == "__main__":
    print(table())
