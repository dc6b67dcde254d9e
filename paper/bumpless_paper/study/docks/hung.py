"""`python -m bumpless_paper.study.docks.hung`: how far a hung dock may swing and still be entered.

The funnel mission again and again, with a drawn current near the axis, drawn gusts, period and phase.
"""

import argparse
from collections import Counter
from dataclasses import replace

import numpy as np

from bumpless.config.mission import Mission, missions_folder, parse_mission
from bumpless.config.mission.sea import CurrentVariation
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.metrics import Columns, figures_of
from bumpless.metrics.capture import capture_of
from bumpless.sim.twin import simulate

SWINGS_M = ((0.0, 0.0), (0.02, 0.04), (0.05, 0.1), (0.1, 0.2))  # sway and heave, amplitudes


def drawn(mission: Mission, number: int, sway: float, heave: float) -> Mission:
    """The mission in a current of 0.03 to 0.12 m/s within 6 deg of the axis, its dock swinging."""
    rng, sea, motion = np.random.default_rng(number), mission.environment, mission.target.motion
    assert motion
    speed, angle = rng.uniform(0.03, 0.12), np.radians(rng.uniform(-6.0, 6.0))
    current = (float(-speed * np.cos(angle)), float(speed * np.sin(angle)), 0.0)
    period, phase = float(rng.uniform(6.0, 12.0)), float(rng.uniform(-180.0, 180.0))
    moves = replace(motion, amplitude_ned_m=(0.0, sway, heave), period_s=period, phase_deg=phase)
    return replace(
        mission,
        seed=number,
        target=replace(mission.target, motion=moves),
        environment=replace(
            sea,
            current_ned_mps=current,
            current_variation=CurrentVariation(std_mps=0.004, time_constant_s=60.0),
        ),
    )


def row(mission: Mission, vehicle: Vehicle, numbers: range, sway: float, heave: float) -> str:
    """One line: how many ended how, and the largest force."""
    endings, forces = Counter[str](), []
    for number in numbers:
        one = drawn(mission, number, sway, heave)
        columns = Columns.from_log(simulate(one, vehicle).log, len(vehicle.commands))
        endings[figures_of(columns, vehicle, one, "completed")[1].ending.words] += 1
        capture = capture_of(columns)
        forces.append(capture.force_max_n if capture else 0.0)
    ended = ", ".join(f"{count} {word}" for word, count in endings.most_common())
    force = f"median force {np.median(forces):.0f} N, most {max(forces):.0f} N"
    return f"sway {sway:.2f} m, heave {heave:.2f} m: {ended}; {force}"


def main() -> None:
    """Print a line for each swing."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=4300000)
    parser.add_argument("--count", type=int, default=40)
    asked = parser.parse_args()
    mission = parse_mission((missions_folder() / "docking_funnel.yaml").read_text(), "docking_funnel.yaml")
    for sway, heave in SWINGS_M:
        numbers = range(asked.first, asked.first + asked.count)
        print(row(mission, load_vehicle("ts100"), numbers, sway, heave))


if __name__ == "__main__":
    main()
