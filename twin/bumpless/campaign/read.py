"""From a campaign file to flights that can be flown, or every problem with its place in the file."""

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from bumpless.campaign.declaration import Campaign, Docked, Search, Tune, Weights
from bumpless.campaign.distributions import KINDS, Choice, Distribution
from bumpless.campaign.limits import check_draws
from bumpless.campaign.prepared import Prepared, Setup
from bumpless.campaign.problems import refuse, unknown
from bumpless.campaign.quantities import QUANTITIES
from bumpless.config.mission import Mission, MissionError, parse_mission
from bumpless.config.mission.document import Document
from bumpless.config.mission.shipped import missions_folder
from bumpless.config.parameters import ParameterError, check, default_parameters, with_overrides
from bumpless.config.problems import Problem, ProblemsError
from bumpless.config.vehicle import Vehicle, load_vehicle

_FIELDS = {field for model in (Campaign, Docked, Tune, Search, Weights) for field in model.model_fields}


class CampaignError(ProblemsError):
    """A campaign file that is refused; `problems` says where and why."""


def load_campaign(path: Path) -> Prepared:
    """The campaign in a file. Raises CampaignError with every problem, or OSError."""
    try:
        text = path.read_bytes().decode()
    except UnicodeDecodeError as error:
        raise CampaignError([Problem(str(path), None, None, "", None, "is not UTF-8 text")]) from error
    return parse_campaign(text, str(path), path.parent)


def parse_campaign(text: str, source: str = "campaign.yaml", folder: Path = Path()) -> Prepared:
    """The campaign that `text` holds; files it names lie beside `folder`."""
    document = Document(text, source)
    campaign = None if document.root is None else _declared(document)
    setups = () if campaign is None else tuple(_setups(document, campaign, folder))
    if campaign is not None and not document.problems:
        prepared = Prepared(campaign, setups)
        check_draws(document, prepared)
        if not document.problems:
            return prepared
    raise CampaignError(sorted(document.problems, key=lambda p: (p.line or 0, p.column or 0)))


def _declared(document: Document) -> Campaign | None:
    """The declaration by itself, without what it names."""
    items = document.items(document.root, "")  # type: ignore[arg-type]
    data = {key: document.plain(node, key) for key, node in items.items()}
    if "draw" in data:
        data["draw"] = _distributions(document, data["draw"])
    try:
        return Campaign.model_validate(
            data | {"missions": _row(data["missions"])} if "missions" in data else data
        )
    except ValidationError as error:
        refuse(document, error, known=_FIELDS)
        return None


def _row(value: Any) -> Any:
    """A list as a tuple, which is what strict models of rows want."""
    return tuple(value) if isinstance(value, list) else value


def _distributions(document: Document, draws: Any) -> dict[str, Distribution]:
    if not isinstance(draws, dict):
        document.refuse("draw", draws, "must hold named quantities such as `current_speed_mps`")
        return {}
    found = {}
    for name, given in draws.items():
        if name not in QUANTITIES:
            document.refuse(f"draw.{name}", None, unknown(name, QUANTITIES))
            continue
        table = given if isinstance(given, dict) else {}
        kind = next(iter(table), None)
        if isinstance(given, int | float | str) and not isinstance(given, bool):
            found[name] = Choice(choice=(given,))
        elif kind not in KINDS or len(table) != 1:
            rule = f"must be a value, or a mapping of one of {', '.join(KINDS)}"
            document.refuse(f"draw.{name}", None if isinstance(given, dict) else given, rule)
        else:
            try:
                found[name] = KINDS[kind].model_validate({kind: _row(table[kind])})
            except ValidationError as error:
                refuse(document, error, f"draw.{name}")
    return found


def _setups(document: Document, campaign: Campaign, folder: Path) -> Iterator[Setup]:
    overrides = _overrides(document, campaign, folder)
    for i, named in enumerate(campaign.missions):
        vehicle = _vehicle(document, campaign.vehicle, folder) if campaign.vehicle else None
        mission = _mission(document, f"missions[{i}]", named, vehicle, folder)
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
            document.refuse(f"parameters.{problem.field}", problem.value, problem.rule)
        if parameters is not None:
            yield Setup(mission, flown_by, parameters)


def _vehicle(document: Document, named: str, folder: Path) -> Vehicle | None:
    try:
        beside = folder / named
        return load_vehicle(str(beside) if beside.suffix == ".toml" else named)
    except (ProblemsError, OSError) as error:
        reason = str(error.problems[0]) if isinstance(error, ProblemsError) else "cannot be read"
        document.refuse("vehicle", named, reason)
        return None


def _mission(
    document: Document, place: str, named: str | dict[str, Any], vehicle: Vehicle | None, folder: Path
) -> Mission | None:
    """A mission written out, in a file beside the campaign, or shipped."""
    from bumpless.campaign.mission_text import as_yaml

    if isinstance(named, dict):
        text, source = as_yaml(named), document.source
    else:
        options = (folder / named, missions_folder() / f"{named}.yaml")
        file = next((path for path in options if path.is_file()), None)
        if file is None:
            document.refuse(
                place, named, "no such file beside the campaign, and no mission of that name ships"
            )
            return None
        try:
            text, source = file.read_bytes().decode(), file.name
        except (OSError, UnicodeDecodeError):
            document.refuse(place, named, "cannot be read as UTF-8 text")
            return None
    try:
        return parse_mission(text, source, vehicle, any_vehicle=True)
    except MissionError as error:
        for problem in error.problems:
            inside = isinstance(named, dict)
            field = f"{place}.{problem.field}" if inside else place
            document.refuse(
                field, problem.value if inside else named, problem.rule if inside else str(problem)
            )
        return None


def _overrides(document: Document, campaign: Campaign, folder: Path) -> list[Mapping[str, Any]]:
    """The parameter file's numbers, then the campaign's own."""
    found: list[Mapping[str, Any]] = []
    if campaign.parameters_file is not None:
        try:
            found.append(tomllib.loads((folder / campaign.parameters_file).read_text(encoding="utf-8")))
        except (OSError, ValueError) as error:
            document.refuse("parameters_file", campaign.parameters_file, f"cannot be read: {error}")
    return [*found, campaign.parameters]
