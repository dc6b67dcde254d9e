"""A flight's columns without its log: rows are flown in small blocks, and of each what figures need is kept.

A LOG row has 1.5 kB, so that a whole flight's would leave the processor's caches and be read from memory
again, once for each column.
"""

from dataclasses import fields
from typing import Any

import numpy as np
import numpy.typing as npt

from bumpless.contract.enums import RUNNING
from bumpless.jit import jit
from bumpless.metrics import Columns
from bumpless.metrics.columns import DockColumns
from bumpless.sim.log import LOG
from bumpless.sim.twin import Twin, new_log

BLOCK = 256  # cycles per compiled call: their rows fit in a processor's own cache

_DOCK = tuple(f.name for f in fields(DockColumns))
_NAMES = (*(f.name for f in Columns.numbers()), *_DOCK, "phase")
_WORD = np.dtype(np.float64).itemsize
_FIELDS: Any = LOG.fields
_PLACES = np.array([_FIELDS[name][1] // _WORD for name in _NAMES])  # in a row, in words
_WIDTHS = np.array([LOG[name].itemsize // _WORD for name in _NAMES])
_BEGINS = np.concatenate([[0], np.cumsum(_WIDTHS)])  # of each column, in words per row before it
# the same of every word of a row that is kept: where it is, its column's begin, place and width
_FROM = np.concatenate([place + np.arange(width) for place, width in zip(_PLACES, _WIDTHS, strict=True)])
_BEGIN, _STEP = np.repeat(_BEGINS[:-1], _WIDTHS), np.repeat(_WIDTHS, _WIDTHS)
_ASIDE = np.arange(_BEGINS[-1]) - _BEGIN
assert LOG.itemsize % _WORD == 0  # every field is one word or several: rows are read as numbers


class Gatherer:
    """Room for the columns of one flight after the other, and for a block of rows."""

    def __init__(self) -> None:
        self._rows = new_log(BLOCK)
        self._words = self._rows.view(np.float64).reshape(BLOCK, -1)
        self._kept = np.zeros(0)

    def fly(self, twin: Twin) -> Columns:
        """The flight that begins now, to its end. Its columns are valid until the next one."""
        most, begun, filled = twin.cycles, twin.phase, 0
        if len(self._kept) < most * _BEGINS[-1]:
            self._kept = np.zeros(most * _BEGINS[-1])
        while filled < most and twin.phase == begun:
            flown = twin.fly(self._rows[: most - filled])
            gather(self._words[:flown], _FROM, _BEGIN * most + _ASIDE, _STEP, filled, self._kept)
            filled += flown
        return self._columns(most, filled, len(twin.vehicle.commands))

    def _columns(self, room: int, count: int, n_u: int) -> Columns:
        found: dict[str, npt.NDArray[np.generic]] = {}
        for name, width, begin in zip(_NAMES, _WIDTHS, _BEGINS[:-1], strict=True):
            part = self._kept[begin * room : begin * room + count * width].view(LOG[name].base)
            found[name] = part.reshape(count, width) if LOG[name].shape else part
        if (found.pop("phase") != RUNNING).any():
            raise ValueError("a campaign flies missions: not from rest, and not beyond their end")
        for name in ("u", "u_feedback", "du_max"):
            found[name] = found[name][:, :n_u]
        dock = DockColumns(**{name: found.pop(name) for name in _DOCK})  # pyright: ignore[reportArgumentType]
        there = bool(np.any(dock.contact_most > 0.0))
        return Columns(**found, dock=dock if there else None)  # pyright: ignore[reportArgumentType]


@jit
def gather(rows, places, begins, steps, done, out):
    """Copy the words at `places` of rows (m, words) into `out`: word w of row r to begins[w] + r steps[w],
    behind the rows that are `done`."""
    for w in range(places.shape[0]):
        place, step, to = places[w], steps[w], begins[w] + done * steps[w]
        for r in range(rows.shape[0]):
            out[to] = rows[r, place]
            to += step
