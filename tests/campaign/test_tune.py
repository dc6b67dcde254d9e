"""The search for parameters."""

import tomllib
from dataclasses import replace

import pytest

from bumpless.campaign.declaration import Weights
from bumpless.campaign.figures import TRACKING
from bumpless.campaign.flight import FlyNumbers
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.store import StoreError
from bumpless.campaign.tune import result, study
from bumpless.campaign.tune.score import Quality, score_of

TUNE = """tune:
  trials: 14
  held_out: 5
  search:
    "hover.kp[5]": {low: 1, high: 100, log: true}
    hover.ramp_cycles: {low: 10, high: 90}
"""


class Toy:
    """Flights of a vehicle that docks where its yaw gain is near 30, and tracks best with a ramp of 40."""

    def __init__(self) -> None:
        self.flown: list[int] = []

    def __call__(self, prepared: Prepared, numbers) -> list[dict]:
        """Rows as `FlyNumbers` gives them; some numbers dock more easily than others."""
        self.flown += numbers
        hover = prepared.setups[0].parameters.hover
        return [self.row(hover, number) for number in numbers]

    def row(self, hover, number):
        """One flight."""
        good = abs(hover.kp[5] - 30.0) < 8.0 + 8.0 * (number % 5)
        off = 0.01 + abs(hover.ramp_cycles - 40) / 100.0
        figures = dict.fromkeys((*TRACKING, "largest_step", "energy_j"), off)
        return {"number": number, "outcome": "docked" if good else "collided", **figures}


@pytest.fixture
def toy(campaign):
    """A campaign of 10 flights that declares the toy's search, far from its best at first."""
    return campaign(10, TUNE + "parameters: {hover: {kp: [1, 1, 1, 1, 1, 90]}}\n")


def searched(folder, prepared, toy, resume=False):
    """Search to the end and judge."""
    found = study.opened(folder, prepared, resume)
    study.search(found, prepared, toy)
    return found, result.judge(found, prepared, toy)


def test_the_search_improves(toy, tmp_path):
    """Protects: what tuning ends with docks more held-out flights than what it began with."""
    found, tuned = searched(tmp_path, toy, Toy())
    assert tuned.before.docked.count < tuned.after.docked.count
    assert tuned.after.score < tuned.before.score
    assert found.trials[0].params["hover.kp[5]"] == 90.0


def test_trials_never_see_the_held_out_flights(toy, tmp_path):
    """Protects: the held-out share is an honest estimate; the flights of trials and of judging share none."""
    fly = Toy()
    found = study.opened(tmp_path, toy, False)
    study.search(found, toy, fly)
    assert set(fly.flown) == set(range(10))
    fly.flown.clear()
    tuned = result.judge(found, toy, fly)
    assert sorted(set(fly.flown)) == list(result.held_out_numbers(toy)) == list(range(10, 15))
    assert (tuned.tuning, tuned.held_out, tuned.looks) == ((0, 9), (10, 14), 1)


def test_looks_at_the_held_out_flights_are_counted(toy, tmp_path):
    """Protects: who looks again and again tunes on the held-out set; a longer search says so."""
    fly = Toy()
    searched(tmp_path, toy, fly)
    fly.flown.clear()
    assert searched(tmp_path, toy, fly, True)[1].looks == 1
    assert not fly.flown
    tune = replace(toy.campaign.tune, trials=30)
    longer = Prepared(replace(toy.campaign, tune=tune), toy.setups)
    _, tuned = searched(tmp_path, longer, fly, True)
    assert tuned.looks == (1 if tuned.trial < 14 else 2)


def test_a_killed_search_goes_on_as_if_nothing_had_happened(toy, tmp_path):
    """Protects: reproducible gains: killed in mid-trial and resumed, the search takes the same steps."""

    class Killed(Toy):
        def __call__(self, prepared, numbers):
            if len(self.flown) > 60:
                raise KeyboardInterrupt
            return super().__call__(prepared, numbers)

    whole, tuned = searched(tmp_path / "whole", toy, Toy())
    with pytest.raises(KeyboardInterrupt):
        searched(tmp_path / "cut", toy, Killed())
    cut, again = searched(tmp_path / "cut", toy, Toy(), True)
    assert again.values == tuned.values
    steps = [[t.params for t in s.trials if t.state.name != "FAIL"] for s in (whole, cut)]
    assert steps[0] == steps[1]
    assert len(cut.trials) == len(whole.trials) + 1


def test_hopeless_trials_are_given_up(toy, tmp_path):
    """Protects: flights are not spent on parameters that have already ended worse than the best in all."""
    fly = Toy()
    found, _ = searched(tmp_path, toy, fly)
    assert any(t.state.name == "PRUNED" for t in found.trials)
    assert len([n for n in fly.flown if n < 10]) < 10 * len(found.trials)
    assert found.best_trial.state.name == "COMPLETE"


def test_another_search_is_refused(toy, campaign, tmp_path):
    """Protects: trials of two different searches are not mixed."""
    searched(tmp_path, toy, Toy())
    with pytest.raises(StoreError, match="go on with --resume"):
        study.opened(tmp_path, toy, False)
    with pytest.raises(StoreError, match="another campaign"):
        study.opened(tmp_path, campaign(11, TUNE), True)


def test_endings_come_first():
    """Protects: no tracking, smoothness or cost pays for one flight that ended worse."""
    one = Quality(1.0, 1.0, 1.0)

    def rows(outcome, figure):
        return [{"outcome": outcome, **dict.fromkeys((*TRACKING, "largest_step", "energy_j"), figure)}]

    def score(*args):
        return score_of(rows(*args), Weights(), one)

    assert score("docked", 1e9) < score("held", 0.0) < score("time_over", 0.0) < score("collided", 0.0)
    assert score("docked", 0.1) < score("docked", 0.2)


def test_the_patch_can_be_flown(toy, tmp_path, campaign):
    """Protects: parameters.toml holds whole rows and its origin; a campaign that names it flies with it."""
    from bumpless.campaign.read import parse_campaign
    from tests.campaign.conftest import DRAW, HEAD

    _, tuned = searched(tmp_path, toy, Toy())
    result.write(tmp_path, toy, tuned)
    text = (tmp_path / "parameters.toml").read_text()
    assert tomllib.loads(text)["hover"]["kp"][5] == tuned.values["hover.kp[5]"]
    assert toy.identity()["vehicle"] in text
    named = HEAD.format(count=2) + DRAW + "parameters_file: parameters.toml\n"
    hover = parse_campaign(named, folder=tmp_path).setups[0].parameters.hover
    assert hover.kp[5] == tuned.values["hover.kp[5]"]
    assert hover.ramp_cycles == tuned.values["hover.ramp_cycles"]


def test_real_flights_give_what_a_score_needs(campaign):
    """Protects: the columns that the score reads are those that flights have."""
    prepared = campaign(2)
    rows = FlyNumbers(prepared)([0, 1])
    quality = study.quality_of(rows)
    assert 0.0 < score_of(rows, Weights(), quality) % 1.0 == pytest.approx(0.5)
