"""The tank study: what is measured of a flight in the basin.

Source: Gao et al. 2026, section 4.3, appendix A.2, tables A5 and A6. As there, figures come from samples at
1 Hz: RMS about the segment's mean, peak-to-peak, mean speed; command RMS without removing the mean; largest
step between adjacent samples within 2 s of a switch. Depth and attitude are the navigation's: the depth
cell's own noise, white and the same in all three scenarios, would hide what the vehicle does.
"""

import itertools

import numpy as np
from numpy.typing import NDArray

from bumpless.contract.enums import FORWARD, HOVER, REVERSE
from bumpless.contract.modes import MODE_LETTERS
from bumpless.contract.units import DEG, RPM
from bumpless.sim.twin import Result

Array = NDArray[np.float64]
RATE_HZ, WINDOW_S = 1.0, 2.0
MISSIONS = {"S1": "tank1", "S2": "tank2", "S3": "tank3"}
GOALS = {"depth_rms_m": 0, "roll_rms_deg": 2, "pitch_rms_deg": 3, "yaw_rms_deg": 4}  # columns of `hover_row`


def samples(run: Result) -> np.ndarray:
    """LOG rows at 1 Hz."""
    return run.log[:: round(1.0 / (RATE_HZ * run.vehicle.control_period_s))]


def segments(rows: np.ndarray) -> dict[int, np.ndarray]:
    """Rows of the last stay in each mode, by mode."""
    edges = [0, *(np.flatnonzero(np.diff(rows["mode"])) + 1).tolist(), len(rows)]
    return {int(rows["mode"][a]): rows[a:b] for a, b in itertools.pairwise(edges)}


def rms(values: Array) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def about_mean(values: Array) -> float:
    """RMS about the mean."""
    return rms(values - values.mean())


def per_mode(run: Result) -> dict[str, list[float]]:
    """Table A6: mode -> duration, N, depth RMS and peak-to-peak, attitude RMS, speed, commands' RMS."""
    out = {}
    for mode, stay in sorted(segments(samples(run)).items()):
        angles = DEG * np.unwrap(stay["eta_hat"][:, 3:6], axis=0)
        fins = DEG * stay["u"][:, run.vehicle.slots("fin")]
        out[MODE_LETTERS[mode]] = [
            float(stay["time"][-1] - stay["time"][0]) + 1.0 / RATE_HZ,
            float(len(stay)),
            about_mean(stay["eta_hat"][:, 2]),
            float(np.ptp(stay["eta_hat"][:, 2])),
            *(about_mean(angles[:, k]) for k in range(3)),
            float(stay["nu_hat"][:, 0].mean()),
            *(rms(RPM * stay["u"][:, i]) for i in run.vehicle.slots("thruster")),
            rms(fins),
        ]
    return out


def steps(run: Result, before: int, after: int) -> list[float]:
    """Largest step between adjacent 1 Hz samples near the last switch: propeller rpm, fins deg, roll deg."""
    rows, mode = samples(run), run.log["mode"]
    at = np.flatnonzero((mode[:-1] == before) & (mode[1:] == after)) + 1
    if len(at) == 0:
        return [float("nan")] * 3
    near = rows[np.abs(rows["time"] - run.log["time"][at[-1]]) <= WINDOW_S + 0.5 / RATE_HZ]
    screw = RPM * near["u"][:, run.vehicle.slots("thruster")[0]]
    fins = DEG * near["u"][:, run.vehicle.slots("fin")]
    roll = DEG * near["eta_hat"][:, 3]
    return [float(np.abs(np.diff(values, axis=0)).max()) for values in (screw, fins, roll)]


def hover_row(run: Result) -> list[float]:
    """Table A5: hover's RMS and the steps around both switches."""
    hover = per_mode(run).get("H", [float("nan")] * 12)
    return [*hover[2:8], *steps(run, FORWARD, REVERSE), *steps(run, REVERSE, HOVER)]


def about_reference(run: Result) -> list[float]:
    """RMS in H of depth (m), roll, pitch and yaw (deg) about what was asked for, every cycle."""
    stay = segments(run.log)[HOVER]
    errors = stay["reference"][:, 2:6] - stay["eta"][:, 2:6]
    errors[:, 1:] = DEG * ((errors[:, 1:] + np.pi) % (2 * np.pi) - np.pi)
    return [rms(errors[:, k]) for k in range(4)]
