"""Hydrodynamic coefficients of a vehicle, from its geometry or from published tables."""

from bumpless.physics.hydrodynamics.coefficients import Coefficients, hull_coefficients

__all__ = ["Coefficients", "hull_coefficients"]
