"""The head of the page: what was found, what falls short and why, and what the symbols mean."""

from collections.abc import Mapping
from html import escape
from typing import Any

from bumpless_paper.report.labels import label
from bumpless_paper.report.outcomes import outcomes_html, rows_of
from bumpless_paper.report.shortfalls import WHERE, shortfalls
from bumpless_paper.report.ticks import share

GLOSSARY: tuple[tuple[str, str], ...] = (
    ("F, R, H", "modes: forward, reverse (braking towards the target), hover"),
    ("S1 … S7", "scenarios, which differ in allocator, switching and fault handling only"),
    ("τ_d, τ_c", "demanded wrench; wrench by the allocator's map at the commands (N and N·m)"),
    ("e_τ", "τ_d minus the achieved wrench; its norm mixes N and N·m, as in the paper"),
    ("u", "commands: fin deflections and shaft speeds"),
    ("d_u,FR, d_u,RH", "largest step of the commands from one cycle to the next around a switch"),
    ("r_sat", "share of cycles in which any command rests at an amplitude bound"),
    ("κ", "how far a ramp after a switch has gone, 0 to 1"),
    ("s", "slack: how much of the demand the fault-tolerant allocator gives up"),
    ("S3→S4", "change of a figure from the first scenario to the second; S4 ≤ S2: of S4 against S2"),
    ("plant", "the simulated vehicle and its sea; the autopilot keeps one nominal model of it"),
)


def summary_html(parts: Mapping[str, Any]) -> str:
    """HTML of outcomes and findings in the parts at hand (as in reproduce.json), and the glossary."""
    found = "".join(f"<li>{escape(line)}</li>" for line in findings(parts))
    short = "".join(f"<li>{escape(line)}</li>" for line in shortfalls(dict(parts)))
    out = outcomes_html(rows_of(parts))
    out += f'<h2>In short</h2><ul class="summary">{found}</ul>' if found else ""
    if short:
        where = escape(WHERE[0].upper() + WHERE[1:])
        out += f'<h2>What falls short, and why</h2><p>{where}.</p><ul class="summary">{short}</ul>'
    words = "".join(f"<dt>{escape(term)}</dt><dd>{escape(said)}</dd>" for term, said in GLOSSARY)
    return f"{out}<details><summary>Symbols and words</summary><dl>{words}</dl></details>"


def findings(parts: Mapping[str, Any]) -> list[str]:
    """One line per part that has a headline."""
    n = {name: part["numbers"] for name, part in parts.items()}
    out = []
    if "table3" in n:
        out.append(
            f"Table 3: every indicator within {share(n['table3']['largest_deviation'], 1)} under the paper's "
            f"sampling, which itself misses {share(n['table3']['force_volume_missed'])} of the force set."
        )
    if "robustness" in n:
        r = n["robustness"]
        unseen = sum(of >= 0.9 for of in r["held_out_share"].values())
        out.append(
            f"Goals: {len(r['met'])} of {len(r['share'])} hold on at least 90 % of {r['plants']} drawn "
            f"plants with one fixed set of parameters, {unseen} on as many plants that had no part in "
            "choosing them."
        )
    for name, table in (("table6", "Table 6"), ("table7", "Table 7")):
        if name in n:
            told = ", ".join(
                f"{_change(key)} {100 * c['ours']:+.0f} % (paper {100 * c['paper']:+.0f} %)".replace("-", "−")
                for key, c in n[name]["changes"].items()
                if c["paper"] is not None
            )
            out.append(f"{table}, nominal plant: {told}.")
    if "diagnosis" in n:
        d, s = n["diagnosis"], n["diagnosis"]["unseen"]
        out.append(
            f"S7: the autopilot finds the propeller's fault by itself on {s['found']} of {s['flights']} "
            f"plants that it was not tuned on, and names another actuator on {s['found'] - s['isolated']}; "
            f"{d['false_alarms']} false alarms in {d['healthy_hours']:.1f} hours without a fault."
        )
    if "remus" in n:
        r = n["remus"]
        out.append(
            f"Hydrodynamics: {r['within_5_percent']} of {r['coefficients']} REMUS coefficients within 5 %, "
            f"{r['explained']} more under another reading of the thesis."
        )
    if "physics" in n:
        out.append(f"Plant: {n['physics']['passed']} of {n['physics']['checks']} cross-checks pass.")
    return out


def _change(key: str) -> str:
    """S3_to_S4_d_u_FR -> S3→S4 d_u, F→R."""
    first, _, rest = key.partition("_to_")
    second, _, figure = rest.partition("_")
    return f"{first}→{second} {label(figure)}"
