"""What the docs say that tuning found, and that the shipped gains are those."""

import json

import pytest

from bumpless.campaign.read import load_campaign
from bumpless.campaign.tune.journal import identity_of
from bumpless.campaign.tune.values import applied
from docs.generate import tuning

VEHICLES = sorted(path.stem.removeprefix("tune_") for path in tuning.CAMPAIGNS.glob("tune_*.yaml"))


def run_of(vehicle: str) -> dict:
    """What its search found."""
    return json.loads((tuning.FOUND / f"{vehicle}.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("vehicle", VEHICLES)
def test_every_vehicle_flies_what_its_search_left_it_with(vehicle: str) -> None:
    """Protects: shipped gains are those found, or those the search found nothing clearly better than; the
    result is of the very file that ships, whose draws are none of those that the outcomes are judged by."""
    run, file = run_of(vehicle), load_campaign(tuning.CAMPAIGNS / f"tune_{vehicle}.yaml")
    now, tune = identity_of(file), file.campaign.tune
    assert tune is not None and file.campaign.seed < 5_000_000
    assert {key: run["identity"][key] for key in ("campaign", "tune")} == {
        key: now[key] for key in ("campaign", "tune")
    }
    assert (run["trials"], run["failed"]) == (tune.trials, [])
    assert tuning.shipped(run, file.setups[0].parameters) in ("yes", "kept")


def test_shipped_is_told_as_it_is() -> None:
    """Protects: the table's word: found and flown, kept for want of better, or neither."""
    file = load_campaign(tuning.CAMPAIGNS / "tune_ts100.yaml")
    path = "hover.kp[5]"
    run = {"trial": 7, "verdict": "clearly better", "values": {path: 30.0}, "present": {path: 60.0}}

    def said(gain: float, **more: object) -> str:
        return tuning.shipped(run | more, applied(file, {path: gain}).setups[0].parameters)

    assert [said(30.01), said(60.0), said(40.0)] == ["yes", "no", "no"]
    assert said(60.0, verdict="not better") == "kept"
    same = {"trial": 0, "verdict": "nothing better found", "values": run["present"]}
    assert [said(60.0, **same), said(40.0, **same)] == ["kept", "no"]


def test_a_control_that_changed_since_is_told() -> None:
    """Protects: nobody takes a search of a former control for one of today's."""
    file = load_campaign(tuning.CAMPAIGNS / "tune_ts100.yaml")
    run = run_of("ts100")
    run["identity"] = identity_of(file)
    assert tuning._search("ts100", run, file)[-1] == "nothing"
    searched = applied(file, {"hover.kp[5]": 31.0})
    assert tuning._search("ts100", run, searched)[-1] == "nothing"
    other = applied(file, {"hover.ki[5]": 31.0})
    assert tuning._search("ts100", run, other)[-1] == "control"
    run["identity"] = run["identity"] | {"missions": "another"}
    assert tuning._search("ts100", run, other)[-1] == "mission and control"
