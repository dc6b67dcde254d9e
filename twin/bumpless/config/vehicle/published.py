"""Published coefficients of a whole vehicle, in place of what strip theory makes of its form.

Symbols are the source's: row, then what the coefficient multiplies; SI and radians. A lift coefficient is of
the vehicle with its fins amidships, Munk's moment included: the plant takes off what fins and added mass add.
"""

from typing import Annotated

from bumpless.config.declare import Number, model


def coefficient(unit: str, help: str = "") -> Number:
    """One coefficient, named as in the source."""
    return Number("Published coefficient", unit, help=help)


@model
class PublishedCoefficients:
    """Source: Prestero 2001, tables of chapter 4 and appendices."""

    X_udot: Annotated[float, coefficient("kg")]
    Y_vdot: Annotated[float, coefficient("kg")]
    Y_rdot: Annotated[float, coefficient("kg·m")]
    Z_wdot: Annotated[float, coefficient("kg")]
    Z_qdot: Annotated[float, coefficient("kg·m")]
    K_pdot: Annotated[float, coefficient("kg·m²")]
    M_wdot: Annotated[float, coefficient("kg·m")]
    M_qdot: Annotated[float, coefficient("kg·m²")]
    N_vdot: Annotated[float, coefficient("kg·m")]
    N_rdot: Annotated[float, coefficient("kg·m²")]
    X_uu: Annotated[float, coefficient("kg/m")]
    Y_vv: Annotated[float, coefficient("kg/m")]
    Y_rr: Annotated[float, coefficient("kg·m")]
    Z_ww: Annotated[float, coefficient("kg/m")]
    Z_qq: Annotated[float, coefficient("kg·m")]
    K_pp: Annotated[float, coefficient("kg·m²")]
    M_ww: Annotated[float, coefficient("kg")]
    M_qq: Annotated[float, coefficient("kg·m²")]
    N_vv: Annotated[float, coefficient("kg")]
    N_rr: Annotated[float, coefficient("kg·m²")]
    Y_uv: Annotated[float, coefficient("kg/m")]
    Y_ur: Annotated[float, coefficient("kg")]
    Z_uw: Annotated[float, coefficient("kg/m")]
    Z_uq: Annotated[float, coefficient("kg")]
    M_uw: Annotated[float, coefficient("kg")]
    M_uq: Annotated[float, coefficient("kg·m")]
    N_uv: Annotated[float, coefficient("kg")]
    N_ur: Annotated[float, coefficient("kg·m")]
