"""The table that leads the page: what is wanted of a docking vehicle, and what was measured.

The endings come from a campaign's result where one is given, else from the part `honest`: its S4, on drawn
plants. Steps and true wrench come from `honest`. A row without a measurement says so; it is never left out.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from typing import Any, Self

from bumpless.campaign.summary import share_of
from bumpless_paper.report.ticks import number, share

UNMEASURED = "not measured in this page"


@dataclass(frozen=True)
class Flights:
    """How many flights ended in each way: all that this table takes of a campaign."""

    of: str  # what flew, for people
    flights: int
    endings: Mapping[str, int]  # word of `bumpless.Ending` -> count

    @classmethod
    def of_part(cls, honest: Mapping[str, Any], row: str = "S4") -> Self:
        """From the numbers of the part `honest`."""
        shares, plants = honest["rows"][row], honest["plants"]
        counts = {word: round(shares[word] * plants) for word in ("docked", "collided")}
        return cls(f"{row} on {plants} drawn plants", plants, counts)


@dataclass(frozen=True)
class Row:
    """One line of the table, as it is shown."""

    figure: str
    before: str  # on the version that the targets were set against
    target: str
    measured: str = UNMEASURED
    interval: str = ""  # 95 %
    of: str = ""


def rows_of(parts: Mapping[str, Any], campaign: Flights | None = None) -> list[Row]:
    """The table from the parts at hand, as in reproduce.json."""
    honest = parts["honest"]["numbers"] if "honest" in parts else None
    flights = campaign or (Flights.of_part(honest) if honest else None)
    gentle = {} if honest is None else honest["rows"]["S4"]
    plants = "" if honest is None else f"S4 on {honest['plants']} drawn plants"
    return [
        _counted("hull through the dock's plane", "> 50 %", "0 of 1,000", flights, "collided"),
        _counted("docked", "5 %", "≥ 95 % where station can be held", flights, "docked"),
        _steps("F→R", "0.074 (median)", gentle.get("gentle_FR"), honest, plants),
        _steps("R→H", "0.116 (median)", gentle.get("gentle_RH"), honest, plants),
        _true_wrench(honest, plants),
    ]


def outcomes_html(rows: list[Row]) -> str:
    """The table as HTML."""
    head = ("figure", "before", "target", "measured", "95 % interval", "flown")
    cells = "".join(
        "<tr>"
        + f"<th>{escape(row.figure)}</th>"
        + "".join(f"<td>{escape(text)}</td>" for text in (row.before, row.target, row.measured))
        + f"<td>{escape(row.interval)}</td><td>{escape(row.of)}</td></tr>"
        for row in rows
    )
    titles = "".join(f"<th>{escape(title)}</th>" for title in head)
    return f'<h2>Does it dock?</h2><div class="wide"><table><tr>{titles}</tr>{cells}</table></div>'


def _counted(figure: str, before: str, target: str, flights: Flights | None, ending: str) -> Row:
    if flights is None or ending not in flights.endings:
        return Row(figure, before, target)
    count = flights.endings[ending]
    return Row(
        figure, before, target, f"{count} of {flights.flights}", _interval(count, flights.flights), flights.of
    )


def _steps(switch: str, before: str, held: float | None, honest: Any, of: str) -> Row:
    figure = f"largest step {switch}, to the ramp's end + 15 s"
    target = "≤ 0.05 on 90 %"
    if held is None:
        return Row(figure, before, target)
    plants = honest["plants"]
    return Row(
        figure, before, target, f"≤ 0.05 on {share(held)}", _interval(round(held * plants), plants), of
    )


def _true_wrench(honest: Any, of: str) -> Row:
    figure, before, target = "RMS e_τ by the true wrench, S4", "0.39, above S2", "≤ 0.2 and below S2"
    if honest is None:
        return Row(figure, before, target)
    four, two = (honest["rows"][name]["median"]["e_tau_true"] for name in ("S4", "S2"))
    return Row(figure, before, target, f"{number(four, 3)}; S2 {number(two, 3)} (medians)", "", of)


def _interval(count: int, of: int) -> str:
    found = share_of(count, of)
    return " – ".join(share(end, 1) for end in (found.low, found.high))
