"""How well a flight followed its reference in each mode, how smoothly, and what that cost."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from bumpless.campaign.geometry import wrapped
from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.parts import Azimuth, Screw
from bumpless.contract.modes import MODES
from bumpless.contract.units import EDGE_PER_SI

Floats = npt.NDArray[np.float64]
CHANNELS = ("depth_m", "cross_m", "heading_deg", "speed_mps")
AFTER_S = 15.0  # a switch is watched until so long after its ramp

KINDS = ("rms", "worst")
KEYS = tuple(look.key for look in MODES)
TRACKING = tuple(f"{mode}_{channel}_{kind}" for mode in KEYS for channel in CHANNELS for kind in KINDS)
COST = ("largest_step", "energy_j", "fin_travel_deg", "reversals")


def tracking(log: npt.NDArray) -> dict[str, float]:
    """RMS and worst of the error against the reference, by mode and channel; NaN for a mode not flown.

    Depth and heading are the plant's true ones, cross-track and speed the autopilot's own errors.
    """
    eta, reference = log["eta"], log["reference"]
    errors = np.stack(
        [
            reference[:, 2] - eta[:, 2],
            log["cross_track"],
            np.degrees(wrapped(reference[:, 5] - eta[:, 5])),
            log["error"][:, 0],
        ],
        axis=1,
    )
    out: list[float] = []
    for look in MODES:
        part = errors[log["mode"] == look.mode]
        if len(part):
            figures = np.stack([np.sqrt(np.mean(part**2, axis=0)), np.abs(part).max(axis=0)], axis=1)
        else:
            figures = np.full((len(CHANNELS), 2), np.nan)
        out += figures.ravel().tolist()
    return dict(zip(TRACKING, out, strict=True))


def cost(log: npt.NDArray, vehicle: Vehicle) -> dict[str, float]:
    """`COST` of a flight: largest step of the commands over their bounds about the switches, energy at the
    shafts in J, travel of all fins in degrees, and how often a screw's command changed its sign."""
    screws = [i for i, command in enumerate(vehicle.commands) if command.unit == "rpm"]
    fins = vehicle.slots("fin")
    u = np.array(log["u"][:, : len(vehicle.commands)])
    steps = np.diff(u, axis=0)
    signs = np.sign(u[:, screws])
    return {
        "largest_step": _largest_step(log, vehicle, steps),
        "energy_j": shaft_energy(log, vehicle),
        "fin_travel_deg": float(np.degrees(np.abs(steps[:, fins]).sum())),
        "reversals": float(np.count_nonzero(signs[1:] * signs[:-1] < 0.0)),
    }


def _largest_step(log: npt.NDArray, vehicle: Vehicle, steps: Floats) -> float:
    """Largest norm of a cycle's change of the commands over their bounds, from a switch to AFTER_S after its
    ramp; NaN without a switch."""
    edges = [max(abs(c.lower), abs(c.upper)) / EDGE_PER_SI[c.unit] for c in vehicle.commands]
    count = round(AFTER_S / vehicle.control_period_s)
    ramping = np.append(log["kappa"][1:] < 1.0, False)[: len(steps)]
    ramping |= np.diff(log["mode"]) != 0
    watched = np.zeros(len(steps), bool)
    for row in np.flatnonzero(ramping & ~np.append(ramping[1:], False)):
        watched[row : row + 1 + count] = True
    watched |= ramping
    sizes = np.linalg.norm(steps[watched] / np.array(edges), axis=1)
    return float(sizes.max()) if len(sizes) else float("nan")


def shaft_energy(log: npt.NDArray, vehicle: Vehicle) -> float:
    """Work at all shafts, J: 2 pi n Q with Q = rho D^5 (K_Q n|n| - slope |n| V_A / D).

    Source: Gao et al. 2026, eqs. (8)-(12).
    """
    rho, dt, total = vehicle.environment.water_density_kgpm3, vehicle.control_period_s, 0.0
    feedback = log["u_feedback"]
    for i, screw in _screws(vehicle):
        n = np.array(feedback[:, i])
        inflow = (1.0 - screw.wake_fraction) * np.einsum(
            "ij,ij->i", log["nu_r_hat"], _ways(screw, i, feedback)
        )
        d = screw.diameter_m
        torque = screw.torque_coefficient * n * np.abs(n) - screw.torque_slope * np.abs(n) * inflow / d
        total += float(np.abs(2.0 * np.pi * n * rho * d**5 * torque).sum()) * dt
    return total


def _screws(vehicle: Vehicle) -> Iterator[tuple[int, Screw]]:
    """Every screw with the place of its shaft speed in u."""
    first = 0
    for actuator in vehicle.actuators:
        if isinstance(actuator, Screw):
            yield first, actuator
        first += len(actuator.commands)


def _ways(screw: Screw, i: int, feedback: npt.NDArray) -> Floats:
    """(n, 3) unit vectors along which the screw at place i of u pushes; a pod's turn with its angle."""
    if isinstance(screw, Azimuth):
        angle = feedback[:, i + 1]
        return np.stack([np.cos(angle), np.sin(angle), np.zeros(len(angle))], axis=1)
    way = np.array(screw.direction) / np.linalg.norm(screw.direction)  # type: ignore[attr-defined]
    return np.broadcast_to(way, (len(feedback), 3))
