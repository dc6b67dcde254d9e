"""What falls short of its goal and why, from the numbers of `bumpless reproduce`.

The causes are in words here; every number in a reason is read from the document. A goal without a known
cause says where it fails and nothing more.
"""

from typing import Any

from bumpless_paper.report.labels import coordinate, label
from bumpless_paper.report.ticks import change, number, percent, share, words
from bumpless_paper.study.readings import NO_FAULT

Document = dict[str, Any]

_SLOWED = (
    "the ramp and the limited increments that make S4 smooth keep its wrench behind the demand for a while, "
    "S2 jumps at once"
)
_ON_AXIS = (
    "the screw that fails lies on the axis and makes neither pitch nor yaw moment, so knowing its fault "
    "hardly changes what the four fins can do"
)
SIDEWAYS = "plant.eta[1]"
WHERE = "where it fails: means of the failing plants against the others, each number scaled to −1 … 1"
CAUSES: dict[str, str] = {
    "S4<=S2 e_tau": _SLOWED,
    "pitch S5->S6": _ON_AXIS,
    "yaw S5->S6": _ON_AXIS,
}


def shortfalls(parts: Document) -> list[str]:
    """One line per claim that misses its goal, with its reason."""
    return [*_goals(parts), *_tank(parts), *_remus(parts), *_stability(parts)]


def _goals(parts: Document) -> list[str]:
    if "robustness" not in parts:
        return []
    numbers, table = parts["robustness"]["numbers"], parts["robustness"]["tables"]["goals"]
    where = {words(row[0]): row[-1] for row in table["rows"]}
    lines = []
    for name in numbers["missed"]:
        told = [f"holds on {share(numbers['share'][name])} of the plants, wanted on 90 %"]
        if name in CAUSES:
            told.append(CAUSES[name])
        told += [
            f"even with {NO_FAULT}, it would hold on {share(read['share'])}"
            for read in numbers.get("readings", {}).get(name, ())
            if read["definition"] == NO_FAULT
        ]
        if where[words(name)]:
            told.append(f"it fails where {where[words(name)]}")
        told += _price(name, parts)
        lines.append(f"{words(name)}: {'. '.join(text[0].upper() + text[1:] for text in told)}.")
    return lines


def _price(name: str, parts: Document) -> list[str]:
    """The best point of all curves for this goal, and how far the median moves along them."""
    if "tradeoff" not in parts:
        return []
    numbers, titles = parts["tradeoff"]["numbers"], parts["tradeoff"]["numbers"]["titles"]
    found = [top for top in numbers["best"] if top["goal"] == name]
    if not found:
        return []
    top = max(found, key=lambda one: one["share"])
    ratios = [
        ratio
        for curve in numbers["curves"].values()
        for point in curve["points"]
        if name in point["goals"] and (ratio := point["goals"][name]["ratio"]) is not None
    ]
    others = " and ".join(f"{words(other)} holds on {share(of)}" for other, of in top["others"].items())
    return [
        f"along the trade-off curves its median change stays between {change(min(ratios))} and "
        f"{change(max(ratios))}; the best point is {share(top['share'])} of {numbers['plants']} plants at "
        f"{titles[top['curve']]} {number(float(top['at']), 3)}, where {others}"
    ]


def _tank(parts: Document) -> list[str]:
    if "tank" not in parts:
        return []
    lines = []
    for name, goal in parts["tank"]["numbers"]["goals"].items():
        if not goal["met"]:
            reason = f": {goal['reason']}" if goal.get("reason") else ""
            lines.append(
                f"Tank, hover {label(name)}: {percent(goal['S1_to_S3'])} against no allocation, wanted "
                f"less{reason}."
            )
    return lines


def _remus(parts: Document) -> list[str]:
    n = parts.get("remus", {}).get("numbers", {})
    if not n or n["within_5_percent"] == n["coefficients"]:
        return []
    said = ""
    if "explained" in n:
        said = (
            f" {n['explained']} of these come out under another reading of the thesis, which the page "
            f"computes; for {n['unexplained']} ({', '.join(n['unexplained_names'])}) none was found: the "
            "print contradicts its own geometry or looks adjusted to trials."
        )
    off = n["coefficients"] - n["within_5_percent"]
    return [
        f"REMUS: {off} of {n['coefficients']} coefficients lie more than 5 % from the thesis' print.{said}"
    ]


def _stability(parts: Document) -> list[str]:
    if "stability" not in parts:
        return []
    lines = []
    for row in parts["stability"]["tables"]["dwell"]["rows"]:
        if row[7] == "proven":
            continue
        radius = parts["stability"]["numbers"][row[0]]["spectral_radius"]
        if row[4] is None:
            mode = max(radius, key=radius.__getitem__)
            slowest = parts["stability"]["numbers"][row[0]].get("slowest_in")
            where = f", slowest in {coordinate(slowest[mode])}" if slowest else ""
            if slowest and slowest[mode] == SIDEWAYS:
                where += ", for nothing pushes it sideways"
            reason = (
                f"no dwell is proven enough, for the loop linearised in {mode} does not contract (spectral "
                f"radius {radius[mode]:.6f}{where})"
            )
        else:
            reason = (
                f"N_dwell = {row[4]} is proven enough; the condition is sufficient, for any order of "
                "switches for ever, and the mission switches a few times"
            )
        lines.append(f"Stability of {row[0]}: N_dwell = {row[2]} in use; {reason}.")
    return lines
