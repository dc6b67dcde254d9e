"""Published coefficients of a whole vehicle, in place of what strip theory makes of its form.

Symbols are the source's: row, then what the coefficient multiplies; SI and radians. A lift coefficient is of
the vehicle with its fins amidships, Munk's moment included: the plant takes off what fins and added mass add.
"""

from typing import Annotated

from bumpless.config.declare import Number, model


def coefficient(unit: str) -> Number:
    """One coefficient, named as in the source, with its unit; radians left out."""
    return Number("Published coefficient", unit)


@model
class PublishedCoefficients:
    """Source: Prestero 2001, tables of chapter 4 and appendices."""

    @property
    def by_symbol(self) -> dict[str, float]:
        """The numbers by the source's symbols: "Y_vv"."""
        return {name.rpartition("_")[0]: value for name, value in vars(self).items()}

    X_udot_kg: Annotated[float, coefficient("kg")]
    Y_vdot_kg: Annotated[float, coefficient("kg")]
    Y_rdot_kgm: Annotated[float, coefficient("kg·m")]
    Z_wdot_kg: Annotated[float, coefficient("kg")]
    Z_qdot_kgm: Annotated[float, coefficient("kg·m")]
    K_pdot_kgm2: Annotated[float, coefficient("kg·m²")]
    M_wdot_kgm: Annotated[float, coefficient("kg·m")]
    M_qdot_kgm2: Annotated[float, coefficient("kg·m²")]
    N_vdot_kgm: Annotated[float, coefficient("kg·m")]
    N_rdot_kgm2: Annotated[float, coefficient("kg·m²")]
    X_uu_kgpm: Annotated[float, coefficient("kg/m")]
    Y_vv_kgpm: Annotated[float, coefficient("kg/m")]
    Y_rr_kgm: Annotated[float, coefficient("kg·m")]
    Z_ww_kgpm: Annotated[float, coefficient("kg/m")]
    Z_qq_kgm: Annotated[float, coefficient("kg·m")]
    K_pp_kgm2: Annotated[float, coefficient("kg·m²")]
    M_ww_kg: Annotated[float, coefficient("kg")]
    M_qq_kgm2: Annotated[float, coefficient("kg·m²")]
    N_vv_kg: Annotated[float, coefficient("kg")]
    N_rr_kgm2: Annotated[float, coefficient("kg·m²")]
    Y_uv_kgpm: Annotated[float, coefficient("kg/m")]
    Y_ur_kg: Annotated[float, coefficient("kg")]
    Z_uw_kgpm: Annotated[float, coefficient("kg/m")]
    Z_uq_kg: Annotated[float, coefficient("kg")]
    M_uw_kg: Annotated[float, coefficient("kg")]
    M_uq_kgm: Annotated[float, coefficient("kg·m")]
    N_uv_kg: Annotated[float, coefficient("kg")]
    N_ur_kgm: Annotated[float, coefficient("kg·m")]
