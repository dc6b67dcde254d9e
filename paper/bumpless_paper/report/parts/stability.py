"""Proposition 2, computed: contraction of each mode, jump of each switch, the smallest dwell.

Source: Gao et al. 2026, Proposition 2.
"""

import math

from bumpless.config.mission import shipped_mission
from bumpless.config.vehicle import load_vehicle
from bumpless.contract.modes import MODE_LETTERS
from bumpless.stability import Dwell, check_dwell, dwell_warning
from bumpless_paper.report.content import Grid, Part
from bumpless_paper.report.labels import coordinate
from bumpless_paper.report.parts import Progress

MISSIONS = ("docking_current", "docking", "rov_docking", "remus_docking")


def part(progress: Progress) -> Part:
    """Check the dwell time of each mission."""
    found: dict[str, Dwell] = {}
    hashes = {}
    for k, name in enumerate(MISSIONS):
        mission = shipped_mission(name)
        found[name] = check_dwell(mission, load_vehicle(mission.vehicle))
        hashes[f"mission {name}"] = mission.sha256
        progress((k + 1) / len(MISSIONS))
    return Part(
        "stability",
        "Switching stability (Proposition 2)",
        "For each mode the compiled closed loop (plant, sensors' rates, navigation, PID, allocation) is "
        "linearised about its reference by finite differences, and each switch from its first cycle to the "
        "end of its ramp. A multiple quadratic Lyapunov function that falls from switch to switch gives the "
        "smallest dwell for which any order of switches is stable. It is a sufficient condition for the "
        "worst order of switches repeated for ever, near the reference; a docking switches a few times.",
        [_dwell_table(found), _mode_table(found), _switch_table(found)],
        notes=[f"{name}: {text}" for name, dwell in found.items() if (text := dwell_warning(dwell))],
        numbers={
            name: {
                "dwell_in_use": d.in_use,
                "dwell_needed": d.needed if math.isfinite(d.needed) else None,
                "spectral_radius": d.radius,
                "slowest_in": d.slowest,
            }
            for name, d in found.items()
        },
        hashes=hashes,
    )


def _dwell_table(found: dict[str, Dwell]) -> Grid:
    rows = []
    for name, d in found.items():
        needed = int(d.needed) if math.isfinite(d.needed) else None
        seconds = None if needed is None else needed * d.period_s
        said = "proven" if d.enough else "not proven"
        rows.append([name, d.states, d.in_use, d.in_use * d.period_s, needed, seconds, d.ramp, said])
    return Grid(
        "dwell",
        "Dwell time in use and dwell time proven enough",
        "A dash: some mode does not contract, so no dwell is proven. In still water a torpedo in hover has "
        "no yaw authority at all: its fins need flow.",
        [
            "mission",
            "states",
            "N_dwell in use",
            "(s)",
            "N_dwell proven",
            "(s)",
            "of it ramp (cycles)",
            "dwell in use",
        ],
        rows,
    )


def _mode_table(found: dict[str, Dwell]) -> Grid:
    rows = []
    for name, d in found.items():
        contraction = {} if d.certificate is None else d.certificate.rho
        rhos = {MODE_LETTERS[i]: float(rho ** (1.0 / d.period)) for i, rho in contraction.items()}
        for mode, radius in d.radius.items():
            slow = -d.period_s / math.log(radius) if radius < 1.0 - 1e-9 else None
            rows.append([name, mode, radius, slow, coordinate(d.slowest[mode]), rhos.get(mode)])
    return Grid(
        "contraction",
        "Contraction of each mode",
        "Spectral radius of the linearised loop per control cycle, its slowest time constant and the "
        "coordinate that time constant is strongest in; rho: contraction of the Lyapunov function per cycle.",
        ["mission", "mode", "spectral radius", "slowest time constant (s)", "strongest in", "rho"],
        [[*row[:2], f"{row[2]:.6f}", *row[3:5], "–" if row[5] is None else f"{row[5]:.6f}"] for row in rows],
    )


def _switch_table(found: dict[str, Dwell]) -> Grid:
    rows = []
    for name, d in found.items():
        if d.certificate is not None:
            for (i, j), mu in d.certificate.mu.items():
                rows.append([name, f"{MODE_LETTERS[i]}→{MODE_LETTERS[j]}", mu, d.certificate.gain[i, j]])
    return Grid(
        "jumps",
        "Jump of each switch",
        "mu bounds the Lyapunov function after the ramp and n more cycles by mu rho^n times that before; "
        "last column: what is left of it at the proven dwell, less than 1.",
        ["mission", "switch", "mu", "V after / V before"],
        rows,
    )
