"""Whether every draw gives a mission that can be flown: each quantity is tried at its ends."""

from collections.abc import Iterable, Mapping

from pydantic import ValidationError

from bumpless.campaign.declaration import Search
from bumpless.campaign.distributions import Value
from bumpless.campaign.drawn import drawn_mission
from bumpless.campaign.mission_text import mission_text
from bumpless.campaign.parameter_path import value_at
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.quantities import EITHER, NAMES, QUANTITIES, TOGETHER
from bumpless.campaign.tune.values import applied, begun
from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.parameters import ParameterError
from bumpless.config.yaml_text import YamlText


def check_draws(file: YamlText, prepared: Prepared) -> None:
    """Add a problem for each quantity or searched parameter that leaves its bounds or breaks a mission."""
    before = len(file.problems)
    _alone(file, prepared)
    for name, distribution in prepared.campaign.draw.items():
        for value in distribution.ends:
            _bounds(file, name, value)
    if len(file.problems) == before:
        _tried(file, prepared)
    _search(file, prepared)


def _alone(file: YamlText, prepared: Prepared) -> None:
    drawn = prepared.campaign.draw
    for pair in TOGETHER:
        for name, other in (pair, pair[::-1]):
            if name in drawn and other not in drawn:
                file.refuse(f"draw.{name}", None, f"means nothing without {other}")
    for name, other in EITHER:
        if name in drawn and other in drawn:
            file.refuse(f"draw.{other}", None, f"cannot be drawn beside {name}")


def _bounds(file: YamlText, name: str, value: Value) -> None:
    quantity, is_text = QUANTITIES[name], isinstance(value, str)
    if is_text != (name in NAMES):
        file.refuse(f"draw.{name}", value, "must be names" if name in NAMES else "must be numbers")
    elif not is_text and not quantity.low <= value <= quantity.high:  # type: ignore[operator]
        unit = f" in {quantity.unit}" if quantity.unit not in ("", "1") else ""
        rule = f"must be between {quantity.low:g} and {quantity.high:g}{unit}"
        file.refuse(f"draw.{name}", value, rule)


def _tried(file: YamlText, prepared: Prepared) -> None:
    """Each quantity at each of its ends, the others in their middle, must leave a mission that is valid."""
    draws = prepared.campaign.draw
    middle = {name: distribution.at(0.5) for name, distribution in draws.items()}
    for name, distribution in draws.items():
        for value in dict.fromkeys(distribution.ends):
            for setup in prepared.setups:
                if broken := _broken(setup, middle | {name: value}):
                    file.refuse(f"draw.{name}", value, f"makes no mission of {setup.mission.name}: {broken}")


def _broken(setup: Setup, values: Mapping[str, Value]) -> str:
    """What is wrong with the mission that these values make; "" when nothing is."""
    try:
        mission = drawn_mission(setup.mission, values)
        parse_mission(mission_text(mission), "", setup.vehicle, any_vehicle=True)
    except MissionError as error:
        return f"{error.problems[0].field} {error.problems[0].rule}"
    except ValidationError as error:  # of one part of the mission, by its declaration
        first = error.errors(include_url=False)[0]
        return " ".join((path_of(first["loc"]), first["msg"]))
    except ValueError as error:
        return str(error)
    return ""


def path_of(place: Iterable[str | int]) -> str:
    """`position_ned_m[2]` from pydantic's place."""
    path = ""
    for step in place:
        path += f"[{step}]" if isinstance(step, int) else f".{step}" if path else step
    return path


def _search(file: YamlText, prepared: Prepared) -> None:
    tune = prepared.campaign.tune
    before = len(file.problems)
    for path, search in tune.search.items() if tune else ():
        if found := _unsearchable(prepared, path, search):
            file.refuse(f"tune.search.{path}", *found)
    if tune and len(file.problems) == before:
        try:
            begun(prepared)
        except ParameterError as error:
            file.refuse(
                "tune.search", None, f"begins where {error.problems[0].field} {error.problems[0].rule}"
            )


def _unsearchable(prepared: Prepared, path: str, search: Search) -> tuple[Value | None, str] | None:
    """What is wrong with the search of one parameter: the value and the rule it breaks."""
    try:
        now = value_at(prepared.setups[0].parameters, path)
    except ValueError as error:
        return None, str(error)
    least = 0.5 if isinstance(now, int) else 0.0
    if not search.low < search.high or (search.log and search.low <= least):
        return None, f"must have {'0 < low < high' if search.log else 'low < high'}"
    for end in (search.low, search.high):
        try:
            applied(prepared, {path: end})
        except ParameterError as error:
            return end, f"{error.problems[0].field} {error.problems[0].rule}"
    start = now if search.start is None else search.start
    whole = (search.low, search.high, start)
    if isinstance(now, int) and any(value != round(value) for value in whole):
        return None, "must have whole numbers, for it is one"
    if not search.low <= start <= search.high:
        return (
            start,
            f"must be between low and high, {search.low:g} and {search.high:g}, where the search begins",
        )
    return None
