"""Velocity over ground while the Doppler log doesn't track the bottom.

Through water it is still measured: the current as last estimated is added. Where nothing is, the vehicle's
own model goes on from the actuators' feedback.
"""

from bumpless.jit import jit
from bumpless.jit.memory import floats
from bumpless.physics.actuators import total_wrench
from bumpless.physics.dynamics import body_acceleration
from bumpless.physics.frames import ned_to_body
from bumpless.physics.lag import follow

SILENCE = 5  # samples of the log missed in a row, from which on the model goes on; a few are waited out


@jit
def add_current(gain, m, state):
    """Follow the measured velocity through water plus the current as last estimated."""
    flow = floats(3)
    ned_to_body(state.eta[3], state.eta[4], state.eta[5], state.current, flow)
    for k in range(3):
        state.nu[k] = follow(state.nu[k], m.water_velocity[k] + flow[k], gain)


@jit
def coast(dt, model, m, effectiveness, state):
    """Advance the velocity by the model's acceleration in the current as last estimated, actuators as they
    are: feedback, with the effectiveness (n,) believed."""
    flow, nu_r, still, tau, force, rate = floats(3), floats(6), floats(6), floats(6), floats(6), floats(6)
    eta, nu = state.eta, state.nu
    ned_to_body(eta[3], eta[4], eta[5], state.current, flow)
    for k in range(3):
        nu_r[k], nu_r[3 + k] = nu[k] - flow[k], nu[3 + k]
        still[k] = still[3 + k] = 0.0
    still[0] = nu[5] * flow[1] - nu[4] * flow[2]
    still[1] = nu[3] * flow[2] - nu[5] * flow[0]
    still[2] = nu[4] * flow[0] - nu[3] * flow[1]
    total_wrench(model, m.u_feedback, effectiveness, nu_r, tau)
    body_acceleration(model, eta, nu, nu_r, still, tau, force, rate)
    for k in range(3):
        nu[k] = follow(nu[k], nu[k] + rate[k], dt)
