"""What a speed asks for in thrust, by the vehicle's file. Beyond the paper."""

from bumpless.jit import inline

T_MADE = 3.0  # s, of the speed that commands should have made
SURE_DRAG = 0.75  # of the hull: with less than this no brake is blamed


@inline
def surge_drag(model, u_r):
    """(X_u + X_uu |u_r|) u_r, N, at the speed u_r through water, m/s."""
    return (model.D_linear[0, 0] + model.D_quadratic[0, 0] * abs(u_r)) * u_r


@inline
def surge_mass(model):
    """m - X_u', kg."""
    return model.M_RB[0, 0] + model.M_A[0, 0]
