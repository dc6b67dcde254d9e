"""Whether every draw gives a mission that can be flown: each quantity is tried at its ends."""

from bumpless.campaign.distributions import Value
from bumpless.campaign.drawn import drawn_mission
from bumpless.campaign.mission_text import mission_text
from bumpless.campaign.parameter_path import changes_of
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.quantities import EITHER, NAMES, QUANTITIES, TOGETHER
from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.mission.document import Document
from bumpless.config.parameters import ParameterError, check


def check_draws(document: Document, prepared: Prepared) -> None:
    """Add a problem for each quantity or searched parameter that leaves its bounds or breaks a mission."""
    before = len(document.problems)
    _alone(document, prepared)
    for name, distribution in prepared.campaign.draw.items():
        for value in distribution.ends:
            _bounds(document, name, value)
    if len(document.problems) == before:
        _tried(document, prepared)
    _search(document, prepared)


def _alone(document: Document, prepared: Prepared) -> None:
    drawn = prepared.campaign.draw
    for pair in TOGETHER:
        for name, other in (pair, pair[::-1]):
            if name in drawn and other not in drawn:
                document.refuse(f"draw.{name}", None, f"means nothing without {other}")
    for name, other in EITHER:
        if name in drawn and other in drawn:
            document.refuse(f"draw.{other}", None, f"cannot be drawn beside {name}")


def _bounds(document: Document, name: str, value: Value) -> None:
    quantity, is_text = QUANTITIES[name], isinstance(value, str)
    if is_text != (name in NAMES):
        document.refuse(f"draw.{name}", value, "must be names" if name in NAMES else "must be numbers")
    elif not is_text and not quantity.low <= value <= quantity.high:  # type: ignore[operator]
        unit = f" in {quantity.unit}" if quantity.unit not in ("", "1") else ""
        rule = f"must be between {quantity.low:g} and {quantity.high:g}{unit}"
        document.refuse(f"draw.{name}", value, rule)


def _tried(document: Document, prepared: Prepared) -> None:
    """Each quantity at each of its ends, the others in their middle, must leave a mission that is valid."""
    draws = prepared.campaign.draw
    middle = {name: distribution.at(0.5) for name, distribution in draws.items()}
    for name, distribution in draws.items():
        for value in dict.fromkeys(distribution.ends):
            for setup in prepared.setups:
                try:
                    mission = drawn_mission(setup.mission, middle | {name: value})
                    parse_mission(mission_text(mission), "", setup.vehicle, any_vehicle=True)
                except MissionError as error:
                    broken = f"{error.problems[0].field} {error.problems[0].rule}"
                    document.refuse(
                        f"draw.{name}", value, f"makes no mission of {setup.mission.name}: {broken}"
                    )
                except ValueError as error:
                    document.refuse(f"draw.{name}", value, str(error))


def _search(document: Document, prepared: Prepared) -> None:
    tune = prepared.campaign.tune
    for path, search in tune.search.items() if tune else ():
        place = f"tune.search.{path}"
        if not search.low < search.high or (search.log and search.low <= 0.0):
            above = "0 < low < high" if search.log else "low < high"
            document.refuse(place, None, f"must have {above}")
            continue
        for setup in prepared.setups:
            for end in (search.low, search.high):
                try:
                    changed = prepared.with_parameters(changes_of(setup.parameters, {path: end}))
                    broken = [p for s in changed.setups for p in check(s.parameters, s.vehicle)]
                except (ParameterError, ValueError) as error:
                    broken = error.problems if isinstance(error, ParameterError) else ()
                    if not broken:
                        document.refuse(place, None, str(error))
                        break
                if broken:
                    document.refuse(place, end, f"{broken[0].field} {broken[0].rule}")
                    break
