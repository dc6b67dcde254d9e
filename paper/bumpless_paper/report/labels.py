"""How the names of figures are shown to people; files and JSON keep the names themselves."""

import re

LABELS: dict[str, str] = {
    "rms_e_tau_all": "RMS e_τ, all cycles",
    "rms_e_tau_post": "RMS e_τ, from the fault",
    "rms_e_tau_model": "RMS e_τ, allocator's map",
    "rms_e_tau_true": "RMS e_τ, true wrench",
    "rms_e_tau_post_model": "RMS e_τ from the fault, allocator's map",
    "rms_e_tau_post_true": "RMS e_τ from the fault, true wrench",
    "r_sat_all": "r_sat, all cycles",
    "r_sat_increment": "share of cycles at an increment bound",
    "d_u_FR": "d_u, F→R",
    "d_u_RH": "d_u, R→H",
    "d_theta_fault": "pitch deviation after the fault",
    "d_psi_fault": "yaw deviation after the fault",
    "s_max": "largest slack",
    "s_rms": "RMS slack",
    "demand_step_violations": "steps of the demand at a switch",
    "integrator_alignment": "integrator alignment",
    "warm_start_projection": "warm-start projection",
    "u_mean_mps": "mean surge (m/s)",
    "duration_s": "duration (s)",
    "N": "samples",
    "delta_rms_deg": "fins RMS (°)",
}
_KINDS = {
    "bound": "over bounds",
    "thrust": "in thrust",
    "mixed": "° and rpm",
    "limit": "increment bound",
    "rms": "RMS",
    "peak": "peak",
    "moved": "moved",
}
_UNITS = {"m": "m", "deg": "°", "rpm": "rpm", "mps": "m/s", "s": "s"}
_WORDS = {
    "p2p": "peak to peak",
    "rms": "RMS",
    "np": "n_p",
    "nv1": "n_v1",
    "nv2": "n_v2",
    "FR": "F→R",
    "RH": "R→H",
}


def label(name: str) -> str:
    """A figure's or a column's name as people write it; a text in words comes back as it is."""
    name, _, unit = name.partition(" (")
    shown = _label(name)
    return f"{shown} ({unit}" if unit and unit != "1)" else shown


def _label(name: str) -> str:
    if name in LABELS:
        return LABELS[name]
    found = re.fullmatch(r"(d_u_FR|d_u_RH|d_theta_fault|d_psi_fault)_(\w+)", name)
    if found and found[2] in _KINDS:
        return f"{LABELS[found[1]]}, {_KINDS[found[2]]}"
    words = name.split("_")
    if " " in name or len(words) < 3 or words[-1] not in _UNITS:
        return name
    return f"{' '.join(_WORDS.get(word, word) for word in words[:-1])} ({_UNITS[words[-1]]})"


_AXES = ("position north", "position east", "depth", "roll", "pitch", "heading")
_ERRORS = ("surge", "sway", "depth", "roll", "pitch", "heading")


def coordinate(name: str) -> str:
    """A coordinate of the linearised loop, such as plant.eta[1], in words."""
    found = re.fullmatch(r"(plant|autopilot)\.(?:\w+\.)?(eta|nu|u|integral)\[(\d)\]", name)
    if not found:
        return name
    k = int(found[3])
    return {
        "eta": f"the vehicle's {_AXES[k % 6]}",
        "nu": f"the vehicle's rate in {_ERRORS[k % 6]}",
        "u": f"{'state' if found[1] == 'plant' else 'command'} of actuator {k + 1}",
        "integral": f"integral of {_ERRORS[k % 6]}",
    }[found[2]]
