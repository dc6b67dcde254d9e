"""The searched parameters of a campaign: where the search begins, and the campaign with others."""

from collections.abc import Mapping
from dataclasses import replace

from bumpless.campaign.declaration import Tune
from bumpless.campaign.parameter_path import changes_of, value_at
from bumpless.campaign.prepared import Prepared
from bumpless.config.parameters import ParameterError, check, with_overrides


def tune_of(prepared: Prepared) -> Tune:
    """What the campaign searches."""
    assert prepared.campaign.tune is not None, "the campaign declares no search"
    return prepared.campaign.tune


def first(prepared: Prepared) -> dict[str, float]:
    """Where the search begins, by path in order: as declared, else as the first mission is flown now."""
    search = tune_of(prepared).search
    return {
        path: value_at(prepared.setups[0].parameters, path)
        if (start := search[path].start) is None
        else start
        for path in sorted(search)
    }


def applied(prepared: Prepared, values: Mapping[str, float]) -> Prepared:
    """The campaign with these parameters, every other number of each mission as it is.

    Raises ParameterError when they can't be flown together.
    """
    setups = tuple(
        replace(s, parameters=with_overrides(s.parameters, changes_of(s.parameters, values)))
        for s in prepared.setups
    )
    if broken := [problem for s in setups for problem in check(s.parameters, s.vehicle)]:
        raise ParameterError(broken)
    return replace(prepared, setups=setups)


def begun(prepared: Prepared) -> Prepared:
    """The campaign as its first trial flies it."""
    return applied(prepared, first(prepared))
