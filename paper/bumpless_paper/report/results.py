"""The results page (docs/results.md): made from the numbers of `bumpless reproduce`, never by hand."""

from collections.abc import Sequence
from typing import Any

from bumpless_paper.report.labels import label
from bumpless_paper.report.outcomes import HEAD, rows_of
from bumpless_paper.report.parts import PARTS
from bumpless_paper.report.shortfalls import WHERE, shortfalls
from bumpless_paper.report.ticks import number, percent, share, words

BEGIN, END = "<!-- results:begin -->", "<!-- results:end -->"
TABLES = ("table3", "table3_missed", "table6", "table7", "table8", "tableA5", "goals", "dwell")


def small(document: dict[str, Any]) -> dict[str, Any]:
    """The part of reproduce.json that the page needs: numbers, hashes and a few tables."""
    parts = {
        name: {
            "tables": {id: table for id, table in part["tables"].items() if id in TABLES},
            "numbers": part["numbers"],
            "hashes": part["hashes"],
        }
        for name, part in document["parts"].items()
    }
    return {**document, "parts": parts}


def renewed(old: dict[str, Any], new: dict[str, Any]) -> dict[str, Any]:
    """The new document, with the old one's parts where it has none of its own; in the order of the page."""
    parts = old.get("parts", {}) | new["parts"]
    return {**new, "parts": {name: parts[name] for name in PARTS if name in parts}}


def with_results(page: str, document: dict[str, Any]) -> str:
    """The page with its results made anew. ValueError when it has no place for them."""
    head, begin, rest = page.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"docs/results.md has no {BEGIN} ... {END}")
    return f"{head}{BEGIN}\n{results_text(document)}{END}{tail}"


def results_text(document: dict[str, Any]) -> str:
    """Markdown: what counts, then Table 3, goals, definitions, extensions, tables 6 to 8, the tank, and what
    falls short."""
    parts = document["parts"]
    blocks = [outcomes_text(parts), fair_text(parts), honest_text(parts)] if "outcome" in parts else []
    blocks += [_table3(parts["table3"]), _goals(parts["robustness"])]
    if "readings" in parts["robustness"]["numbers"]:
        blocks.append(_readings(parts["robustness"]))
    if "extensions" in parts:
        blocks.append(_extensions(parts["extensions"]))
    blocks.append(_scenarios(parts))
    if "diagnosis" in parts:
        blocks.append(diagnosis_text(parts["diagnosis"]))
    blocks += [_tank(parts["tank"]), _ground(parts), _short(parts)]
    return "\n\n".join(blocks) + "\n"


def outcomes_text(parts: dict[str, Any]) -> str:
    """Markdown: the table that leads."""
    of = parts["outcome"]["numbers"]
    rows = [list(row.cells) for row in rows_of(parts)]
    return (
        "**Does it dock?** TS-100 as it ships, on drawn missions that had no part in any choice (numbers "
        "from "
        f"{of['first']:,} on), judged by the truth.\n\n{_markdown(list(HEAD), rows, words=(1, 2, 3, 4, 5))}"
    )


def fair_text(parts: dict[str, Any]) -> str:
    """Markdown: allocator by ramp on the docking vehicle."""
    n = parts["fair"]["numbers"]
    rows = []
    for row in n["rows"].values():
        m, gentle = row["median"], row["gentle"]
        low, high = row["docked_interval"]
        rows.append([
            row["title"], f"{share(row['docked'])} ({share(low)} – {share(high)})",
            str(row["endings"].get("collided", 0)),
            number(m["late_step_fr"], 2), share(gentle["fr"]),
            number(m["late_step_rh"], 2), share(gentle["rh"]),
            number(m["wrench_error_rms"], 2), number(m["reverse_depth_m_rms"], 2), number(m["energy_j"], 3),
            number(m["fin_travel_deg"], 3),
        ])  # fmt: skip
    head = ["allocator", "docked", "collided", "step F→R", "≤ 0.05 on", "step R→H", "≤ 0.05 on", "true e_τ",
            "depth R (m)", "energy (J)", "fins (°)"]  # fmt: skip
    return (
        f"**Allocator by ramp on the docking vehicle**, {n['flights']} drawn flights into a current. S2, S3 "
        "and S4 each fly the best gains of a search of their own, with the same budget and score; steps from "
        f"the switch until 15 s after the ramp, medians.\n\n{_markdown(head, rows)}"
    )


def honest_text(parts: dict[str, Any]) -> str:
    """Markdown: the published automaton, judged by the mission."""
    n = parts["honest"]["numbers"]
    rows = [
        [
            row["title"], share(row["docked"]), share(row["held"]), share(row["time_over"]),
            share(row["collided"]),
            number(row["median"]["settling_FR"], 2), number(row["median"]["settling_RH"], 2),
            number(row["median"]["e_tau_true"], 2),
        ]
        for row in n["rows"].values()
    ]  # fmt: skip
    head = ["allocator", "docked", "held", "time over", "collided", "step F→R", "step R→H", "true e_τ"]
    return (
        f"**The published method, judged so**: the paper's automaton, guidance and mission on {n['plants']} "
        f"wide plants. It docks on {share(max(one['docked'] for one in n['rows'].values()))} of them at "
        "best, and its ramp defers the step past the paper's window of 2 s.\n\n" + _markdown(head, rows)
    )


def _markdown(head: list[str], rows: list[list[str]], words: Sequence[int] = ()) -> str:
    sides = ["---" if k == 0 or k in words else "--:" for k in range(len(head))]
    lines = [head, sides, *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _pair(paper: float | None, ours: float | None) -> str:
    return f"{number(paper, 3)} / **{number(ours, 3)}**"


def _comparison(table: dict[str, Any]) -> list[list[str]]:
    return [
        [label, *(_pair(p, o) for p, o in zip(row["paper"], row["ours"], strict=True))]
        for label, row in table["rows"].items()
    ]


def _table3(part: dict[str, Any]) -> str:
    n, table = part["numbers"], part["tables"]["table3"]
    force, moment = n["force_volume_missed"], n["moment_volume_missed"]
    return (
        "**Table 3, paper / ours** under the paper's own sampling; the farthest indicator is "
        f"{share(n['largest_deviation'], 1)} off. Sampling itself misses {share(force)} of the force set's "
        f"volume and {share(moment)} of the moment set's, which the exact sets show.\n\n"
        + _markdown(["at 0.2 m/s", *table["columns"]], _comparison(table))
    )


def _goals(part: dict[str, Any]) -> str:
    n, table = part["numbers"], part["tables"]["goals"]
    rows = [[words(str(cell)) for cell in row[:-1]] for row in table["rows"]]
    met = sum(of >= 0.9 for of in n.get("held_out_share", {}).values())
    unseen = f", {met} on plants that had no part in choosing them" if "held_out_share" in n else ""
    return (
        f"**Goals on {n['plants']} drawn plants**, one fixed set of parameters: {len(n['met'])} of "
        f"{len(n['share'])} hold on at least 90 % of them{unseen}.\n\n"
        + _markdown(table["columns"][:-1], rows)
    )


def _readings(part: dict[str, Any]) -> str:
    """Every goal under the definitions that the paper leaves open, one line each."""
    rows = []
    for name, (ours, *others) in part["numbers"]["readings"].items():
        told = "; ".join(f"{read['definition']}: **{share(read['share'])}**" for read in others)
        rows.append([words(name), ours["definition"], f"**{share(ours['share'])}**", told])
    head = ["goal", "our definition", "holds on", "under other definitions it holds on"]
    return "**Definitions decide these figures**, so here is each goal under the others too.\n\n" + _markdown(
        head, rows, words=(1, 3)
    )


def _extensions(part: dict[str, Any]) -> str:
    n = part["numbers"]
    rows = [
        [name, *("; ".join(words(goal) for goal in goals) or "–" for goals in found.values())]
        for name, found in n["needed"].items()
    ]
    return (
        "**What was added to the published method**, each switched off alone: the goals that hold on 90 % of "
        f"{n['plants']} plants only with it, those whose share it raises and those whose share it lowers by "
        "5 % or more.\n\n" + _markdown(["extension", "needed for", "helps", "costs"], rows, words=(1, 2, 3))
    )


def _scenarios(parts: dict[str, Any]) -> str:
    out = []
    for name, title in (
        ("table6", "Table 6, no fault"),
        ("table7", "Table 7, fault of the main propeller"),
        ("table8", "Table 8, runtime of the allocator"),
    ):
        table = parts[name]["tables"][name]
        head = ["paper / ours", *(label(column) for column in table["columns"])]
        out.append(f"**{title}**\n\n{_markdown(head, _comparison(table))}")
    return "\n\n".join(out)


def diagnosis_text(part: dict[str, Any]) -> str:
    """Markdown: what `bumpless_paper.study.diagnosis` found of S7."""
    n = part["numbers"]
    head = ["S7", "found", "named rightly", "delay, median (s)", "90 %", "error, median", "90 %"]
    rows = []
    for plants, key in (("nominal, five seeds", "nominal"), ("tuned on", "tuned"), ("never seen", "unseen")):
        s = n[key]
        delay, error = (
            [number(s[k][q], 2) if s[k][q] is not None else "not found" for q in ("median", "q90")]
            for k in ("delay_s", "error")
        )
        rightly = share(s["isolated"] / s["found"] if s["found"] else None)
        rows.append([plants, f"{s['found']} of {s['flights']}", rightly, *delay, *error])
    told = n["plant_figures"]["rms_e_tau_post_true"]
    return (
        "**S7, the fault of Table 7 found by the autopilot itself** on plants that its numbers were tuned on "
        f"and on plants they never saw; {n['false_alarms']} false alarms in {n['healthy_hours']:.1f} hours "
        f"without a fault. e_τ after it, median change from S5: S6 {percent(told['S6/S5'] - 1.0)}, S7 "
        f"{percent(told['S7/S5'] - 1.0)}.\n\n" + _markdown(head, rows)
    )


def _tank(part: dict[str, Any]) -> str:
    table, goals = part["tables"]["tableA5"], part["numbers"]["goals"]
    rows = []
    for name, goal in goals.items():
        k = table["columns"].index(name)
        paper = [table["rows"][label]["paper"][k] for label in ("S1", "S2", "S3")]
        rows.append(
            [
                label(name),
                f"{percent(paper[1] / paper[0] - 1)} / **{percent(goal['S1_to_S2'])}**",
                f"{percent(paper[2] / paper[0] - 1)} / **{percent(goal['S1_to_S3'])}**",
                "better" if goal["met"] else "worse",
            ]
        )
    head = ["hover, against S1 (no allocation)", "S2 allocation", "S3 and bumpless", "S3"]
    return "**Tank study, paper / ours**, change of the RMS about the mean\n\n" + _markdown(head, rows)


def _ground(parts: dict[str, Any]) -> str:
    remus, physics, fit = (parts[name]["numbers"] for name in ("remus", "physics", "identify"))
    known, open_ = fit["determined"], fit["undetermined"]
    more = ", and a reason for each of the others"
    if "explained" in remus:
        more = (
            f", {remus['explained']} more under another reading"
            f" of the thesis, {remus['unexplained']} under none found"
        )
    return (
        f"**Ground.** {physics['passed']} of {physics['checks']} cross-checks of the plant pass (energy, "
        "symmetry, order of the integrator, SciPy's rotations, an independent root finder). Fed with REMUS, "
        f"the hydrodynamics give {remus['within_5_percent']} of {remus['coefficients']} of the thesis' "
        f"coefficients within 5 %{more}. Table 3 determines "
        f"{len(known)} of {len(known) + len(open_)} vehicle parameters; not {', '.join(open_)}."
    )


def _short(parts: dict[str, Any]) -> str:
    lines = "\n".join(f"- {line}" for line in shortfalls(parts))
    return f"**What falls short, and why** ({WHERE})\n\n{lines or '- nothing'}"
