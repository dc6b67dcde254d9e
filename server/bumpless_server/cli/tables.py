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
    """All figures of a run in three small tables."""
    figures = [
        ["RMS e_tau, model (N, N·m)", number(m.residual_rms)],
        ["RMS e_tau, true wrench", number(m.residual_rms_true)],
        ["r_sat, cycles with a command at its bound", f"{m.saturation_ratio:.1%}"],
        ["d_u F→R, commands over their bounds", number(m.d_u_fr)],
        ["d_u R→H, commands over their bounds", number(m.d_u_rh)],
        ["final range (m)", number(m.final_range_m)],
        ["allocation mean / p95 / max (µs)", _times(m)],
        ["allocation within tolerance", f"{m.solved_ratio:.1%}"],
        ["increment bound broken (cycles)", str(m.increment_violations)],
        ["demand step beyond the ramp (cycles)", str(m.demand_step_violations)],
    ]
    if m.missing_cycles:
        figures.append(["cycles missing in the log", str(m.missing_cycles)])
    parts = [table(["figure", "value"], figures)]
    if m.switches:
        parts.append(_switches(m))
    if m.modes:
        parts.append(_modes(m))
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
        ]
        for s in m.switches
    ]
    return table(["switch", "at (s)", "d_u over bounds", "d_u in deg and rpm"], rows)


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
    head = ["mode", "s", "speed m/s", "depth RMS m", "p-p m", "roll RMS °", "pitch °", "yaw °", "RMS e_tau"]
    return table(head, rows)
