"""The table that leads the page: what is wanted of a docking vehicle, and what was measured.

Endings, steps and responses come from the part `outcome`, the true wrench from `honest`, whose mission it was
measured on before. A row without a measurement says so; it is never left out.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

from bumpless.campaign.summary import share_of
from bumpless_paper.report.ticks import number, share

UNMEASURED = "not measured in this page"
HEAD = ("figure", "before", "target", "measured", "95 % interval", "flown")
Numbers = Mapping[str, Any]
_WRENCH = ("e_tau_map", "e_tau_told", "e_tau_true")


@dataclass(frozen=True)
class Row:
    """One line of the table, as it is shown."""

    figure: str
    before: str  # on the version that the targets were set against
    target: str
    measured: str = UNMEASURED
    interval: str = ""  # 95 %
    of: str = ""

    @property
    def cells(self) -> tuple[str, ...]:
        """In the order of `HEAD`."""
        return (self.figure, self.before, self.target, self.measured, self.interval, self.of)


def rows_of(parts: Mapping[str, Any]) -> list[Row]:
    """The table from the parts at hand, as in reproduce.json."""
    outcome = parts["outcome"]["numbers"] if "outcome" in parts else None
    honest = parts["honest"]["numbers"] if "honest" in parts else None
    groups = outcome["groups"] if outcome else None
    said = outcome["responses"] if outcome else None
    return [
        _collided(groups),
        _ended("docked, approach into the current", "5 %", "≥ 95 %", groups, "into", ("docked",)),
        _ended("docked in still water", "10 of 20", "≥ 95 %", groups, "still", ("docked",)),
        _ended(
            "docked or waved off with its reason, fixed heading",
            "never waved off",
            "all",
            groups,
            "fixed",
            ("docked", "waved_off"),
        ),
        _stay(said),
        _wander(said),
        _step("depth 0.5 m step in F", "49 s, 40 %", "< 15 s, < 5 %", said, "depth_step"),
        _step("heading 20° step in F", "54 s, 34 %", "< 15 s, < 10 %", said, "heading_step"),
        _depth_r(groups),
        _dip(said),
        _gentle("F→R", "0.074 (median)", groups, "step_fr"),
        _gentle("R→H", "0.116 (median)", groups, "step_rh"),
        _true_wrench(honest),
        _unknown_wrench(honest),
        _learned_wrench(honest),
        _loads(said),
        _ballast(said),
    ]


def outcomes_html(rows: list[Row]) -> str:
    """The table as HTML."""
    cells = "".join(
        f"<tr><th>{escape(row.figure)}</th>"
        + "".join(f"<td>{escape(text)}</td>" for text in row.cells[1:])
        + "</tr>"
        for row in rows
    )
    titles = "".join(f"<th>{escape(title)}</th>" for title in HEAD)
    return f'<h2>Does it dock?</h2><div class="wide"><table><tr>{titles}</tr>{cells}</table></div>'


def _collided(groups: Numbers | None) -> Row:
    figure, before, target = "hull in the dock, uncommanded", "> 50 %", "0 of 1,000"
    if groups is None:
        return Row(figure, before, target)
    count = sum(group["endings"].get("collided", 0) for group in groups.values())
    flights = sum(group["flights"] for group in groups.values())
    of = "all drawn flights, with faults, target lost or never seen"
    return Row(figure, before, target, f"{count} of {flights:,}", _interval(count, flights), of)


def _ended(
    figure: str, before: str, target: str, groups: Numbers | None, name: str, words: tuple[str, ...]
) -> Row:
    if groups is None:
        return Row(figure, before, target)
    group = groups[name]
    count = sum(group["endings"].get(word, 0) for word in words)
    measured = f"{count} of {group['flights']}"
    if len(words) > 1:
        each = (f"{group['endings'].get(word, 0)} {word.replace('_', ' ')}" for word in words)
        measured += f" ({', '.join(each)})"
    return Row(figure, before, target, measured, _interval(count, group["flights"]), group["about"])


def _stay(said: Numbers | None) -> Row:
    figure, before, target = "hover held for 10 min in every accepted current", "lost", "all"
    if said is None or "accepted" not in said["stay"]:
        return Row(figure, before, target)
    stay = said["stay"]
    of = (
        f"of {stay['asked']} draws, 0 to 0.15 m/s with gusts of 1 to 6 mm/s, the check accepts "
        f"{stay['accepted']} for 10 min; median {share(stay['within']['median'], 1)} of the time within "
        "docked's limits"
    )
    measured = f"{stay['held']} of {stay['accepted']}"
    return Row(figure, before, target, measured, _interval(stay["held"], stay["accepted"]), of)


def _wander(said: Numbers | None) -> Row:
    figure, before, target = "heading wander about the approach in such a hover", "lost", "< 1°"
    if said is None or "accepted" not in said["stay"]:
        return Row(figure, before, target)
    q = said["stay"]["wander_deg"]
    return Row(figure, before, target, _spread(q, "° RMS"), "", "accepted currents")


def _step(figure: str, before: str, target: str, said: Numbers | None, name: str) -> Row:
    if said is None:
        return Row(figure, before, target)
    settled, over = said[name]["settled_s"], said[name]["overshoot"]
    measured = f"{number(settled['median'], 2)} s, {share(over['median'], 1)}; "
    measured += f"worst {number(settled['worst'], 3)} s, {share(over['worst'], 1)}"
    return Row(figure, before, target, measured, "", f"{said[name]['plants']} drawn plants, still water")


def _depth_r(groups: Numbers | None) -> Row:
    figure, before, target = "depth about its reference in R, RMS", "0.17 m", "< 0.03 m"
    if groups is None:
        return Row(figure, before, target)
    return Row(
        figure, before, target, _spread(groups["into"]["depth_r_m"], " m"), "", "as the vehicle believed"
    )


def _dip(said: Numbers | None) -> Row:
    figure, before, target = "loss of speed at the start", "0.07 m/s", "< 0.02 m/s"
    if said is None:
        return Row(figure, before, target)
    return Row(
        figure, before, target, _spread(said["start_dip_mps"], " m/s"), "", "drawn plants, still water"
    )


def _gentle(switch: str, before: str, groups: Numbers | None, name: str) -> Row:
    figure = f"largest step {switch}, to the ramp's end + 15 s"
    target = "≤ 0.05 on 90 %"
    if groups is None:
        return Row(figure, before, target)
    count, flights = groups["into"]["gentle"][name]
    measured = f"≤ 0.05 on {share(count / flights if flights else None)}"
    q = groups["into"]["largest_step"][name]
    measured += f" (median {number(q['median'], 2)}, worst {number(q['worst'], 2)})"
    return Row(figure, before, target, measured, _interval(count, flights), "flights that docked")


def _true_wrench(honest: Numbers | None) -> Row:
    figure, before, target = "RMS e_τ by the true wrench, S4", "0.39, above S2", "≤ 0.2 and below S2"
    if honest is None:
        return Row(figure, before, target)
    four, two = (honest["as_file"][name] for name in ("S4", "S2"))
    measured = f"{number(four, 2)}; S2 {number(two, 2)} (medians)"
    return Row(figure, before, target, measured, "", "the paper's mission, the vehicle as its file")


def _unknown_wrench(honest: Numbers | None) -> Row:
    """On plants whose lift and thrust nobody on board knows: how much of the error is the allocator's."""
    figure, before = "the same where lift and thrust differ from the file", "not told apart"
    target = "S4 below S2 in what is allocated"
    return _wide(figure, before, target, honest, honest and honest["rows"])


def _learned_wrench(honest: Numbers | None) -> Row:
    """On the same plants, after one flight before from whose log thrust and lift were identified."""
    figure = "the same, thrust and lift learned from the log of one flight before"
    return _wide(figure, "never learned", "≤ 0.2 given as told", honest, honest and honest.get("learned"))


def _wide(figure: str, before: str, target: str, honest: Numbers | None, rows: Numbers | None) -> Row:
    if honest is None or rows is None:
        return Row(figure, before, target)
    said = (
        f"{name} {' / '.join(number(row['median'][key], 2) for key in _WRENCH)}"
        for name, row in ((name, rows[name]) for name in ("S4", "S2"))
    )
    of = f"{honest['plants']} wide plants; allocated / given as told / with the passive lift of the fins"
    return Row(figure, before, target, "; ".join(said), "", of)


def _loads(said: Numbers | None) -> Row:
    figure, before, target = "1 N too light or too heavy", "loses hover", "docks"
    if said is None:
        return Row(figure, before, target)
    (up, ups), (down, downs) = said["light"], said["heavy"]
    measured = f"{up} of {ups} too light, {down} of {downs} too heavy"
    return Row(figure, before, target, measured, _interval(up + down, ups + downs), "still water")


def _ballast(said: Numbers | None) -> Row:
    figure, before, target = "1 % of the mass moved by 5 cm", "loses hover", "docks"
    if said is None or "shifted" not in said:
        return Row(figure, before, target)
    docked, flown = said["shifted"]
    return Row(figure, before, target, f"{docked} of {flown}", _interval(docked, flown), "still water")


def _spread(q: Numbers, unit: str) -> str:
    return f"{number(q['median'], 2)}{unit}; 90 % below {number(q['q90'], 2)}{unit}"


def _interval(count: int, of: int) -> str:
    found = share_of(count, of)
    return " – ".join(share(end, 1) for end in (found.low, found.high))
