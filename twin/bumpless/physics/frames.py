"""Every rotation and change of frame: NED world {N}, forward-starboard-down body {B}, Euler zyx.

Source: Fossen 2021, ch. 2; Gao et al. 2026, eq. (6)-(7).
"""

from math import atan2, cos, pi, sin

from bumpless.jit import inline, jit


@inline
def wrap(angle):
    """Angle in [-pi, pi), rad."""
    if -pi <= angle < pi:
        return angle
    return (angle + pi) % (2.0 * pi) - pi


@jit
def body_to_ned(phi, theta, psi, v, out):
    """out = R_nb(phi, theta, psi) v ; v and out of shape (3,). Source: Gao et al. 2026, eq. (6)-(7)."""
    cf, sf, ct, st, cp, sp = cos(phi), sin(phi), cos(theta), sin(theta), cos(psi), sin(psi)
    x, y, z = v[0], v[1], v[2]
    out[0] = cp * ct * x + (cp * st * sf - sp * cf) * y + (sp * sf + cp * cf * st) * z
    out[1] = sp * ct * x + (cp * cf + sf * st * sp) * y + (st * sp * cf - cp * sf) * z
    out[2] = -st * x + ct * sf * y + ct * cf * z


@jit
def ned_to_body(phi, theta, psi, v, out):
    """out = R_nb^T v ; v and out of shape (3,)."""
    cf, sf, ct, st, cp, sp = cos(phi), sin(phi), cos(theta), sin(theta), cos(psi), sin(psi)
    x, y, z = v[0], v[1], v[2]
    out[0] = cp * ct * x + sp * ct * y - st * z
    out[1] = (cp * st * sf - sp * cf) * x + (cp * cf + sf * st * sp) * y + ct * sf * z
    out[2] = (sp * sf + cp * cf * st) * x + (st * sp * cf - cp * sf) * y + ct * cf * z


@jit
def euler_rates(phi, theta, p, q, r):
    """(phi', theta', psi') = T(phi, theta) [p q r]. Singular at theta = +-pi/2.

    Source: Gao et al. 2026, eq. (6)-(7).
    """
    sf, cf, ct = sin(phi), cos(phi), cos(theta)
    ct = ct if abs(ct) > 1e-6 else 1e-6
    tt = sin(theta) / ct
    return p + sf * tt * q + cf * tt * r, cf * q - sf * r, (sf * q + cf * r) / ct


@inline
def direction(north, east):
    """Heading of a horizontal vector, rad from north, clockwise."""
    return atan2(east, north)
