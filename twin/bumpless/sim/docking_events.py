"""What the docking automaton did, told from two consecutive LOG rows."""

from collections.abc import Iterator

import numpy as np

from bumpless.contract.docking import REASONS, STAGES
from bumpless.contract.enums import APPROACH, BACK, CREEP, ENTRY, FORWARD, HOLD, HOVER, INFO, REVERSE, WARNING

HELD_S = 10.0  # in place, straight and still: what docked means
Told = tuple[str, str, dict[str, str], int]  # code, text, details, severity


def docking_events(last: np.void, row: np.void) -> Iterator[Told]:
    """Events of the change from `last` to `row`; nothing where the published automaton flies."""
    if not row["stage"] or not last["stage"]:
        return
    details = {
        "stage": STAGES[int(row["stage"])],
        "tried": str(int(row["tried"])),
        "tries": str(int(row["tries"])),
        "reason": REASONS.get(int(row["reason"]), ""),
        "range_m": f"{row['range']:.3f}",
    }
    if row["stage"] != last["stage"]:
        yield from _stage(last, row, details)
    elif row["cleared"] and not last["cleared"] and row["stage"] == APPROACH:
        text = f"Gate passed at {row['along_track']:.1f} m: deep, straight and in line."
        yield "gate_passed", text, details, INFO
    if last["held"] < HELD_S <= row["held"] and not row["captured"]:
        text = f"Held at the observation point for {HELD_S:g} s, {row['range']:.2f} m from it."
        yield "station_held", text, details, INFO


def _stage(last: np.void, row: np.void, details: dict[str, str]) -> Iterator[Told]:
    after, tried, tries = int(row["stage"]), int(row["tried"]), int(row["tries"])
    why = REASONS.get(int(row["reason"]), "")
    heading = f"{np.degrees(row['approach']) % 360.0:.0f}°"
    if after == APPROACH:
        yield "approach_begun", f"Approach {tried} of {tries} begun, heading {heading}.", details, INFO
    elif after == BACK:
        text = f"Waved off: {why}. Backing off along the approach line."
        yield "waved_off", text, details, WARNING
    elif after == ENTRY and tried:
        text = f"Go-around {tried} of {tries - 1}: flying round to the approach line, heading {heading}."
        yield "go_around", text, details, INFO
    elif after == ENTRY:
        yield "entry_begun", f"Flying round to the approach line, heading {heading}.", details, INFO
    elif after == CREEP:
        yield "creep_begun", "In place before the dock: creeping along its axis.", details, INFO
    elif after == HOLD:
        text = f"Ended waved off after {tried} of {tries} approaches: {why}. Holding clear of the dock."
        yield "docking_ended", text, details, WARNING


def docking_switch(before: int, after: int, row: np.void) -> tuple[str, str]:
    """(why the mode changed, what would have kept it) where the docking automaton flies."""
    stage, left = int(row["stage"]), float(row["along_track"])
    if stage in (BACK, HOLD):
        return REASONS.get(int(row["reason"]), STAGES[stage]), "an approach within its limits"
    if stage == APPROACH and after == REVERSE and before == FORWARD:
        return f"on the approach line with the target in sight, {left:.2f} m to go", "more way to go"
    if stage == APPROACH and after == HOVER:
        return f"{left:.2f} m to go and the gate passed", "more way to go, or a closed gate"
    if stage == APPROACH:
        return f"{left:.2f} m to go", "less way to go"
    return f"{STAGES[stage]} begins", "another stage"
