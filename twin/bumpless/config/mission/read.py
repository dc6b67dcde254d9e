"""From the bytes of a file to a Mission, or all that is wrong with it."""

from typing import TYPE_CHECKING

from bumpless.config.declare import Unread, read
from bumpless.config.mission.model import Document, Mission, MissionError
from bumpless.config.mission.rules import broken_overrides, broken_rules
from bumpless.config.problems import Problem
from bumpless.config.text import BOM, NotText, decoded, foreign_kind
from bumpless.config.yaml_text import YamlText

if TYPE_CHECKING:
    from bumpless.config.vehicle import Vehicle

MOST_PROBLEMS = 100  # more tell nobody anything


def parse_mission(
    data: bytes | str,
    source: str = "mission.yaml",
    vehicle: "Vehicle | None" = None,
    any_vehicle: bool = False,
) -> Mission:
    """The mission that a file's bytes (or their text) hold; `source` is the name its problems carry.

    It is checked against `vehicle`, or when None against the vehicle file of the name it asks for.
    With `any_vehicle` it may ask for another than `vehicle`, and is still checked against that one.
    Raises MissionError with every problem, in the order of the file.
    """
    kind = foreign_kind(data)
    if kind is not None:
        raise MissionError([Problem(source, None, None, "", None, f"is {kind}, not a Bumpless mission")])
    try:
        text = decoded(data, source)
    except NotText as error:
        raise MissionError([error.problem]) from None
    file = YamlText(text.removeprefix(BOM), source)
    mission = _checked(file, text, vehicle, any_vehicle)
    if file.problems or mission is None:
        ordered = sorted(file.problems, key=lambda p: (p.line or 0, p.column or 0))
        raise MissionError(ordered[:MOST_PROBLEMS])
    return mission


def _checked(file: YamlText, text: str, vehicle: "Vehicle | None", any_vehicle: bool) -> Mission | None:
    """The mission with all its rules checked; what is wrong is added to the file's problems."""
    if file.value is None:
        return None
    try:
        document = read(Document, file.value)
    except Unread as error:
        for one in (*error.broken, *broken_overrides(file.value, vehicle)):
            file.refuse(*one)
        return None
    mission = Mission(**vars(document), source=file.source, text=text)
    for one in broken_rules(mission, vehicle, any_vehicle):
        file.refuse(*one)
    return mission
