"""The same code flies all shipped vehicles: one docking flight of each."""

from bumpless.config.mission import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.modes import MODE_LETTERS
from bumpless.sim.twin import simulate
from bumpless_paper.report.content import Figure, Grid, Part
from bumpless_paper.report.parts import Progress
from bumpless_paper.report.parts.flights import command_figure, pose_figure, track_figure, wrench_figure

FLIGHTS = {"ts100": "docking", "bluerov2_heavy": "rov_docking", "remus100": "remus_docking"}


def part(progress: Progress) -> Part:
    """Fly each vehicle's docking mission."""
    from bumpless.metrics import Columns, metrics_of

    rows, hashes = [], {}
    figures: list[Figure] = []
    for k, (name, flight) in enumerate(FLIGHTS.items()):
        vehicle, mission = load_vehicle(name), shipped_mission(flight)
        result = simulate(mission, vehicle)
        m = metrics_of(Columns.from_log(result.log, len(vehicle.commands)), vehicle)
        flown = [int(result.log["mode"][0]), *(s.to_mode for s in m.switches)]
        modes = "→".join(MODE_LETTERS[mode] for mode in flown)
        rows.append(
            [
                vehicle.name,
                " ".join(vehicle.controllable),
                len(vehicle.actuators),
                modes,
                float(result.log["range_true"].min()),
                m.residual_rms_true,
                m.increment_violations,
                m.demand_step_violations,
            ]
        )
        hashes |= {f"vehicle {name}": vehicle.sha256, f"mission {flight}": mission.sha256}
        runs, said = {vehicle.name: result}, f"{mission.title}. {mission.summary}"
        figures.append(track_figure(f"{name}_track", f"{vehicle.name}: track", said, runs))
        figures.append(pose_figure(f"{name}_pose", f"{vehicle.name}: depth and attitude", "", runs))
        for kind in dict.fromkeys(("thruster", *sorted(a.kind for a in vehicle.actuators))):
            title = f"{vehicle.name}: {kind}s"
            figures.append(command_figure(f"{name}_{kind}s", title, "", runs, kind))
        figures.append(wrench_figure(f"{name}_wrench", f"{vehicle.name}: wrench", "", result))
        progress((k + 1) / len(FLIGHTS))
    return Part(
        "vehicles",
        "Three vehicles, one code",
        "A vehicle is data: allocator, envelopes, autopilot and plant name none. The torpedo with vertical "
        "thrusters brakes and hovers; the ROV hovers at rest with thrust sideways; REMUS, buoyant and with "
        "nothing that pushes up, down or sideways, cannot stop: it holds depth by pitch and passes through "
        "the docking point at the slowest speed at which its fins steer.",
        [
            Grid(
                "vehicle_flights",
                "Docking flights",
                "Proposition 1 is checked in every cycle: bounds and increments kept, demand continuous.",
                [
                    "vehicle",
                    "wrench",
                    "actuators",
                    "modes flown",
                    "closest to the point (m)",
                    "RMS e_tau, true (N, N·m)",
                    "increment bound broken",
                    "demand stepped",
                ],
                rows,
            )
        ],
        figures,
        hashes=hashes,
    )
