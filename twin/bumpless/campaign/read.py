"""From a campaign file to flights that can be flown, or every problem with its place in the file."""

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.distributions import KINDS, Choice, Distribution
from bumpless.campaign.limits import check_draws
from bumpless.campaign.named import mission_named, vehicle_named
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.quantities import QUANTITIES
from bumpless.config.declare import Unread, read, unknown
from bumpless.config.parameters import ParameterError, check, default_parameters, with_overrides
from bumpless.config.problems import ProblemsError
from bumpless.config.text import BOM, NotText, decoded
from bumpless.config.vehicle import load_vehicle
from bumpless.config.yaml_text import YamlText


class CampaignError(ProblemsError):
    """A campaign file that is refused; `problems` says where and why."""


def load_campaign(path: Path) -> Prepared:
    """The campaign in a file. Raises CampaignError with every problem, or OSError."""
    return parse_campaign(path.read_bytes(), str(path), path.parent)


def parse_campaign(data: bytes | str, source: str = "campaign.yaml", folder: Path = Path()) -> Prepared:
    """The campaign that a file's bytes (or their text) hold; files it names lie beside `folder`."""
    try:
        text = decoded(data, source)
    except NotText as error:
        raise CampaignError([error.problem]) from None
    file = YamlText(text.removeprefix(BOM), source)
    campaign = None if file.value is None else _declared(file, dict(file.value))
    setups = () if campaign is None else tuple(_setups(file, campaign, folder))
    if campaign is not None and not file.problems:
        prepared = Prepared(campaign, setups)
        check_draws(file, prepared)
        if not file.problems:
            return prepared
    raise CampaignError(sorted(file.problems, key=lambda p: (p.line or 0, p.column or 0)))


def _declared(file: YamlText, data: dict[str, Any]) -> Campaign | None:
    """The declaration by itself, without what it names."""
    if "draw" in data:
        data["draw"] = _distributions(file, data["draw"])
    try:
        return read(Campaign, data)
    except Unread as error:
        for one in error.broken:
            file.refuse(*one)
        return None


def _distributions(file: YamlText, draws: Any) -> dict[str, Distribution]:
    if not isinstance(draws, dict):
        file.refuse("draw", draws, "must hold named quantities such as `current_speed_mps`")
        return {}
    found = {}
    for name, given in draws.items():
        place, kind = f"draw.{name}", _kind(given)
        if name not in QUANTITIES:
            file.refuse(place, given, unknown(name, QUANTITIES))
        elif isinstance(given, int | float | str) and not isinstance(given, bool):
            found[name] = Choice(choice=(given,))
        elif kind is None:
            file.refuse(place, given, f"must be a value, or a mapping of one of {', '.join(KINDS)}")
        else:
            try:
                found[name] = read(KINDS[kind], given)
            except Unread as error:
                for path, value, rule in error.broken:
                    file.refuse(f"{place}.{path}", value, rule)
    return found


def _kind(given: Any) -> str | None:
    """The distribution that a table of one entry names."""
    kind = next(iter(given)) if isinstance(given, dict) and len(given) == 1 else None
    return kind if kind in KINDS else None


def _setups(file: YamlText, campaign: Campaign, folder: Path) -> Iterator[Setup]:
    overrides = _overrides(file, campaign, folder)
    vehicle = vehicle_named(file, campaign.vehicle, folder) if campaign.vehicle else None
    for i, named in enumerate(campaign.missions):
        mission = mission_named(file, f"missions[{i}]", named, vehicle, folder)
        if mission is None or (campaign.vehicle and vehicle is None):
            continue
        flown_by = vehicle or load_vehicle(mission.vehicle)
        try:
            parameters = with_overrides(default_parameters(flown_by), mission.parameters)
            for changes in overrides:
                parameters = with_overrides(parameters, changes)
            broken = check(parameters, flown_by)
        except ParameterError as error:
            parameters, broken = None, error.problems
        for problem in broken:
            file.refuse(f"parameters.{problem.field}", problem.value, problem.rule)
        if parameters is not None:
            yield Setup(mission, flown_by, parameters)


def _overrides(file: YamlText, campaign: Campaign, folder: Path) -> list[Mapping[str, Any]]:
    """The parameter file's numbers, then the campaign's own."""
    found: list[Mapping[str, Any]] = []
    if campaign.parameters_file is not None:
        try:
            found.append(tomllib.loads((folder / campaign.parameters_file).read_text(encoding="utf-8")))
        except (OSError, ValueError) as error:
            file.refuse("parameters_file", campaign.parameters_file, f"cannot be read: {error}")
    return [*found, campaign.parameters]
