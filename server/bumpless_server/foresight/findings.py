"""What stands against a plan, each with its place in the text and the changes that mend it."""

import numpy as np

import bumpless
from bumpless.chart import floor_of
from bumpless.config.text import BOM
from bumpless.config.vehicle import load_vehicle
from bumpless.config.yaml_text import YamlText
from bumpless.metrics.floor import below
from bumpless_server.foresight.forecast import known, shown_rows
from bumpless_server.foresight.told import ForesightFinding, ForesightFloor, ForesightMend


def findings_of(mission: bumpless.Mission, vehicle: bumpless.Vehicle | None = None) -> list[ForesightFinding]:
    """The findings of `bumpless.check`, hard ones first."""
    file = YamlText(mission.text.removeprefix(BOM), mission.source)
    return [told(finding, file) for finding in bumpless.check(mission, vehicle)]


def told(finding: bumpless.Finding, file: YamlText) -> ForesightFinding:
    """One finding; `file` is the text that it is about."""
    line, column = file.place_of(finding.field)
    return ForesightFinding(
        severity=finding.severity,
        code=finding.code,
        path=finding.field,
        line=line,
        column=column,
        reason=finding.text,
        change=finding.change,
        mends=[
            ForesightMend(
                label=mend.words,
                path=mend.path,
                value=list(mend.value) if isinstance(mend.value, tuple) else mend.value,
            )
            for mend in finding.mends
        ],
    )


def floor_below(mission: bumpless.Mission, vehicle: bumpless.Vehicle | None = None) -> ForesightFloor | None:
    """The sea floor along the planned legs; None where the mission names none or it is not known."""
    floor = floor_of(mission)
    if floor is None or mission.sea_floor is None:
        return None
    found = below(np.array(mission.path_ned_m), vehicle or load_vehicle(mission.vehicle), floor)
    rows = shown_rows(len(found.along))
    places = found.places[rows].round(2)
    charted = np.isfinite(found.clearance).any()
    return ForesightFloor(
        along_m=found.along[rows].round(2).tolist(),
        north_m=places[:, 0].tolist(),
        east_m=places[:, 1].tolist(),
        depth_m=places[:, 2].tolist(),
        floor_m=known(found.floor[rows]),
        wanted_m=mission.sea_floor.clearance_m,
        least_m=round(float(np.nanmin(found.clearance)), 2) if charted else None,
    )
