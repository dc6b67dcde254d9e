"""Pieces of one flight: what a crash, a full disk or the hold after a mission puts into files of their own.

The recorder names them `<run>`, `<run>.2`, `<run>.3` ... A file of the same flight under any other name is a
copy, and no piece.
"""

from collections.abc import Sequence
from dataclasses import fields, replace

import numpy as np

from bumpless.metrics import Columns
from bumpless.metrics.columns import DockColumns

LONGEST_NAME = 120  # of a flight, before the number of a piece


def piece_name(flight: str, number: int) -> str:
    """Id of the file that holds a flight's piece; the first is called as the flight."""
    return flight if number == 1 else f"{flight[:LONGEST_NAME]}.{number}"


def piece_of(name: str, flight: str) -> int:
    """Which piece of a flight the file `name` is, from 1; 0: none."""
    if name == flight:
        return 1
    number = name.removeprefix(f"{flight[:LONGEST_NAME]}.")
    plain = number.isascii() and number.isdigit() and len(number) < 5 and str(int(number)) == number
    return int(number) if flight and number != name and plain and int(number) > 1 else 0


def joined(parts: Sequence[Columns]) -> Columns:
    """Columns of the pieces of one flight, in order; what one tells again or of other actuators is left out.

    Where a cycle is missing, `Columns.follows` is False, as within one file.
    """
    first, kept = parts[0], list[Columns]()
    last = -1
    for part in parts:
        if part.u.shape[1:] != first.u.shape[1:]:
            continue
        new = part.cycle > last
        if new.any():
            kept.append(part.rows(new))
            last = int(part.cycle[new][-1])
    if len(kept) < 2:
        return kept[0] if kept else first
    whole = {f.name: np.concatenate([getattr(p, f.name) for p in kept]) for f in Columns.numbers()}
    return replace(first, **whole, dock=_docks(kept), lost=kept[-1].lost)


def _docks(parts: Sequence[Columns]) -> DockColumns | None:
    """A piece that met no dock knows nothing of one."""
    if all(part.dock is None for part in parts):
        return None
    docks = [part.dock or _unknown(len(part)) for part in parts]
    return DockColumns(*(np.concatenate([getattr(d, f.name) for d in docks]) for f in fields(DockColumns)))


def _unknown(rows: int) -> DockColumns:
    nothing = np.full(rows, np.nan)
    return DockColumns(np.zeros(rows, np.int64), nothing, nothing, nothing, nothing)
