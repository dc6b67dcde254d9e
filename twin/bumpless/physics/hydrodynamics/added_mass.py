"""Added mass of a Myring hull with a cross of fins, by strip theory.

Source: Prestero 2001, section 4.3; Newman 1977; Blevins 1979.
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bumpless.config.vehicle.parts import Fin
from bumpless.physics.hydrodynamics.myring import HullStrips


def spheroid_axial_factor(fineness: float) -> float:
    """Added mass of a prolate spheroid moving along its axis over its displaced mass, Lamb's k_1.

    Differs: Prestero reads the factor from Blevins' table; this is the closed form behind the table.
    Source: Lamb 1932, article 114.
    """
    if fineness <= 1.0:
        return 0.5
    e = math.sqrt(1.0 - fineness**-2)
    alpha_0 = 2 * (1 - e**2) / e**3 * (0.5 * math.log((1 + e) / (1 - e)) - e)
    return alpha_0 / (2.0 - alpha_0)


def axial_added_mass(strips: HullStrips, rho: float) -> float:
    """-X_udot in kg: the spheroid with the hull's length and diameter.

    Source: Prestero 2001, section 4.3 (axial added mass).
    """
    length, diameter = strips.hull.length_m, strips.hull.diameter_m
    return spheroid_axial_factor(length / diameter) * rho * math.pi / 6 * length * diameter**2


def fin_tip_radius(fins: Sequence[Fin]) -> float:
    """Largest distance of a fin tip from the x axis, m, lift acting at mid span."""
    return max(fin.arm_m + fin.span_m / 2 for fin in fins)


def section_added_mass(strips: HullStrips, fins: Sequence[Fin], rho: float) -> NDArray[np.float64]:
    """Added mass per length (kg/m) of each section moving sideways: circle, or circle with a cross of fins.

    Four fins at right angles give the same value in every direction, so X- and +-tails need one formula.
    Source: Prestero 2001, section 4.3 (crossflow added mass).
    """
    r = strips.radius
    m_a = math.pi * rho * r**2
    if fins:
        a = fin_tip_radius(fins)
        at_fins = _finned(strips, fins)
        m_a[at_fins] = math.pi * rho * (a**2 - r[at_fins] ** 2 + r[at_fins] ** 4 / a**2)
    return m_a


def _finned(strips: HullStrips, fins: Sequence[Fin]) -> NDArray[np.bool_]:
    aft = min(fin.x_m - fin.chord_m / 2 for fin in fins)
    fore = max(fin.x_m + fin.chord_m / 2 for fin in fins)
    return (strips.x >= aft) & (strips.x <= fore)


def roll_added_inertia(fins: Sequence[Fin], rho: float) -> float:
    """-K_pdot in kg m^2: a cross of four fins, 2/pi rho a^4 per length; a bare hull has none.

    Source: Prestero 2001, section 4.3 (rolling added mass).
    """
    if not fins:
        return 0.0
    chord = sum(fin.chord_m for fin in fins) / len(fins)
    return 2 / math.pi * rho * fin_tip_radius(fins) ** 4 * chord


def added_mass(strips: HullStrips, fins: Sequence[Fin], rho: float) -> NDArray[np.float64]:
    """M_A, (6, 6), kg | kg m | kg m^2, about O_b; symmetric.

    A section at x moves with v + x r in sway and w - x q in heave, hence the signs of the coupling terms.
    """
    m_a = section_added_mass(strips, fins, rho)
    lateral = strips.integral(m_a)
    first = strips.integral(m_a * strips.x)
    second = strips.integral(m_a * strips.x**2)
    M_A = np.diag(
        [axial_added_mass(strips, rho), lateral, lateral, roll_added_inertia(fins, rho), second, second]
    )
    M_A[1, 5] = M_A[5, 1] = first
    M_A[2, 4] = M_A[4, 2] = -first
    return M_A
