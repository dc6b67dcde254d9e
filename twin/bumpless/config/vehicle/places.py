"""Where a vehicle's two files say what, though they are read as one text."""

from dataclasses import replace
from typing import Any

from bumpless.config.problems import Problem
from bumpless.config.text import BOM
from bumpless.config.toml_places import places_of


class Places:
    """The places of a vehicle's fields; from line `control_line` on, unless 0, in the file beside."""

    def __init__(self, text: str, source: str, control_line: int) -> None:
        self._places = places_of(text.removeprefix(BOM))
        self._source, self._control_line = source, control_line

    def problem(self, path: str, value: Any, rule: str, at: str = "") -> Problem:
        """A broken rule at the place of `at` (else of `path`), or of the nearest part around it."""
        around = at or path
        while around and around not in self._places:
            around = around[: max(around.rfind("."), around.rfind("["), 0)]
        line, column = self._places.get(around, (1, 1))
        return beside(Problem(self._source, line, column, path, value, rule), self._control_line)


def beside(problem: Problem, control_line: int) -> Problem:
    """The same in the file beside, if its line is there."""
    line = problem.line or 0
    if not control_line or line < control_line:
        return problem
    file = problem.file.removesuffix(".toml") + ".control.toml"
    return replace(problem, file=file, line=line - control_line + 1)
