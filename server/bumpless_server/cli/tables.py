"""Figures as text for a terminal."""

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bumpless.contract import bumpless_pb2 as pb


def table(head: list[str], rows: list[list[str]]) -> str:
    """Columns aligned: the first to the left, the others to the right."""
    widths = [max(len(line[i]) for line in [head, *rows]) for i in range(len(head))]
    lines = []
    for line in [head, *rows]:
        cells = [
            c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(line, widths, strict=True))
        ]
        lines.append("  " + "  ".join(cells).rstrip())
    return "\n".join(lines)


def number(value: float, digits: int = 4) -> str:
    """A figure; a dash when there is none."""
    return "-" if math.isnan(value) else f"{value:.{digits}g}"


def metrics_text(m: "pb.Metrics") -> str:
    """All figures of a run in small tables: how it ended first."""
    figures = [
        ["shaft energy (J)", number(m.shaft_energy_j)],
        ["fin travel (°)", number(m.fin_travel_deg)],
        ["reversals of screws", str(m.screw_reversals)],
        ["RMS e_tau, model (N, N·m)", number(m.residual_rms)],
        ["RMS e_tau, true wrench", number(m.residual_rms_true)],
        ["r_sat, cycles with a command at its bound", f"{m.saturation_ratio:.1%}"],
        ["d_u F→R, within 2 s of the switch, over bounds", number(m.d_u_fr)],
        ["d_u F→R, from the switch to the ramp's end + 15 s", number(m.d_u_fr_settling)],
        ["d_u R→H, within 2 s of the switch, over bounds", number(m.d_u_rh)],
        ["d_u R→H, from the switch to the ramp's end + 15 s", number(m.d_u_rh_settling)],
        ["final range (m)", number(m.final_range_m)],
        ["allocation mean / p95 / max (µs)", _times(m)],
        ["allocation within tolerance", f"{m.solved_ratio:.1%}"],
        ["increment bound broken (cycles)", str(m.increment_violations)],
        ["demand step beyond the ramp (cycles)", str(m.demand_step_violations)],
    ]
    if m.missing_cycles:
        figures.append(["cycles missing in the log", str(m.missing_cycles)])
    parts = [_end(m.outcome)] if m.HasField("outcome") else []
    parts.append(table(["figure", "value"], figures))
    if m.switches:
        parts.append(_switches(m))
    if m.modes:
        parts += [_tracking(m), _modes(m)]
    return "\n\n".join(parts)


def _times(m: "pb.Metrics") -> str:
    values = (m.solve_time_mean_us, m.solve_time_p95_us, m.solve_time_max_us)
    return " / ".join(number(value, 3) for value in values)


def _switches(m: "pb.Metrics") -> str:
    from bumpless.contract.modes import LOOKS

    rows = [
        [
            f"{LOOKS[s.from_mode].letter}→{LOOKS[s.to_mode].letter}",
            f"{s.time_s:.2f}",
            number(s.command_step_normalised),
            number(s.command_step_raw),
            f"{s.settling_s:.1f}",
            number(s.command_step_settling),
            number(s.force_step_n, 3),
            number(s.moment_step_nm, 3),
            number(s.acceleration_step_mps2, 3),
            number(s.angular_acceleration_step_degps2, 3),
        ]
        for s in m.switches
    ]
    head = ["switch", "at s", "±2 s: d_u", "° and rpm", "settling s", "d_u", "true N", "N·m", "m/s²", "°/s²"]
    return table(head, rows)


def _end(outcome: "pb.Outcome") -> str:
    """True and believed errors of the last cycle."""
    rows = []
    for name, known in (("true", outcome.HasField("true_errors")), ("believed", True)):
        e = getattr(outcome, f"{name}_errors")
        values = (e.position_m, e.horizontal_m, e.depth_m, e.heading_deg, e.speed_mps)
        rows.append([name, *(number(value, 3) if known else "-" for value in values)])
    head = ["at the end", "position m", "horizontal m", "depth m", "heading °", "speed m/s"]
    near = f"closest approach of the hull to the marker (m): {number(outcome.closest_m, 3)}"
    return f"{table(head, rows)}\n  {near}, {number(outcome.closest_s, 3)} s after the start"


def _tracking(m: "pb.Metrics") -> str:
    """Errors about the references: RMS and worst."""
    from bumpless.contract.modes import LOOKS

    rows = [
        [
            LOOKS[mode.mode].letter,
            *(
                f"{number(rms, 2)} / {number(worst, 2)}"
                for rms, worst in (
                    (mode.depth_error_rms_m, mode.depth_error_max_m),
                    (mode.cross_track_error_rms_m, mode.cross_track_error_max_m),
                    (mode.heading_error_rms_deg, mode.heading_error_max_deg),
                    (mode.speed_error_rms_mps, mode.speed_error_max_mps),
                )
            ),
        ]
        for mode in m.modes
    ]
    head = ["error about the reference, RMS / worst", "depth m", "cross-track m", "heading °", "speed m/s"]
    return table(head, rows)


def _modes(m: "pb.Metrics") -> str:
    from bumpless.contract.modes import LOOKS

    rows = [
        [
            LOOKS[mode.mode].letter,
            f"{mode.duration_s:.2f}",
            number(mode.surge_speed_mean_mps, 3),
            number(mode.depth_rms_m, 3),
            number(mode.depth_peak_to_peak_m, 3),
            number(mode.roll_rms_deg, 3),
            number(mode.pitch_rms_deg, 3),
            number(mode.yaw_rms_deg, 3),
            number(mode.residual_rms, 3),
        ]
        for mode in m.modes
    ]
    head = ["about the mean", "s", "speed m/s", "depth RMS m", "p-p m", "roll RMS °", "pitch °", "yaw °"]
    head.append("RMS e_tau")
    return table(head, rows)
