"""The parts of e_tau, and the rows of the docking table."""

from bumpless_paper.study.docks.table import row
from bumpless_paper.study.misfit import ROWS, medians


def test_what_is_known_of_thrust_and_lift_lowers_what_is_given() -> None:
    """Protects: on a plant whose lift and thrust differ from the file, knowing them is what helps."""
    names = ("as drawn", "lift too", "as drawn, learned in a flight before")
    drawn, known, learned = (medians("S4", range(60, 63), ROWS[name]) for name in names)
    assert known["e_tau_told"] < drawn["e_tau_told"]
    assert learned["e_tau_told"] < drawn["e_tau_told"]


def test_a_row_counts_every_flight_once() -> None:
    """Protects: docked, waved off, neither and struck add up to what was flown."""
    said = row("still", "fixed", 600, 2, 1)
    assert said == "| still, fixed | 600, 2 | 2 | 0 | 0 | 0 |"
