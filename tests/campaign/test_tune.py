"""The search for parameters."""

import json
import pickle
import tomllib
from dataclasses import replace

import pytest

from bumpless.campaign import flight
from bumpless.campaign.declaration import Weights
from bumpless.campaign.figures import TRACKING
from bumpless.campaign.flight import FlightError, FlyNumbers
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.store import StoreError
from bumpless.campaign.tune import journal, result, study
from bumpless.campaign.tune.score import Quality, score_gain, score_of
from bumpless.campaign.tune.values import applied, first

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
    with journal.opened(folder, prepared, resume) as found:
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
    with journal.opened(tmp_path, toy, False) as found:
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
    assert searched(tmp_path / "straight", longer, Toy())[1].values == tuned.values


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
    assert again == tuned
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
    renamed = Prepared(replace(toy.campaign, name="other"), toy.setups)
    for prepared, resume, said in (
        (toy, False, "go on with --resume"),
        (campaign(11, TUNE), True, "the campaign's declaration"),
        (campaign(10, TUNE.replace("low: 1,", "low: 2,")), True, "what is searched"),
        (renamed, True, "the campaign's name"),
    ):
        with pytest.raises(StoreError, match=said), journal.opened(tmp_path, prepared, resume):
            pass


def test_one_process_searches_in_a_folder(toy, tmp_path):
    """Protects: a second `--resume` beside one that runs doubles no trial."""
    with journal.opened(tmp_path, toy, False), pytest.raises(StoreError, match="another process"):
        journal.opened(tmp_path, toy, True).__enter__()


def test_a_killed_process_leaves_nothing_that_stops_the_next(toy, tmp_path):
    """Protects: the lock of a process that is no more and half a line are cleared away; all trials stay."""
    _, whole = searched(tmp_path, toy, Toy())
    (tmp_path / "study.journal.lock").symlink_to(tmp_path / "study.journal")
    with (tmp_path / "study.journal").open("a") as file:
        file.write('{"op_code":4,"study')
    fly = Toy()
    assert searched(tmp_path, toy, fly, True)[1] == whole
    assert not fly.flown


@pytest.mark.parametrize("text", ["no journal\n{}\n", '{"op_code": 99}\n'])
def test_what_is_no_journal_is_refused(toy, tmp_path, text):
    """Protects: a damaged or foreign file is told by its name."""
    (tmp_path / "study.journal").write_text(text)
    with pytest.raises(StoreError, match=r"study\.journal cannot be read"):
        journal.opened(tmp_path, toy, True).__enter__()


def test_a_search_that_finds_nothing_says_so(campaign, tmp_path):
    """Protects: "keep what you have" is an answer, and flights are not flown twice to find no difference."""
    good = campaign(10, TUNE + "parameters: {hover: {kp: [1, 1, 1, 1, 1, 30], ramp_cycles: 40}}\n")
    fly = Toy()
    _, tuned = searched(tmp_path, good, fly)
    assert (tuned.trial, tuned.verdict) == (0, "nothing better found")
    assert tuned.before == tuned.after and tuned.values == tuned.present
    assert len([number for number in fly.flown if number >= 10]) == 5


def test_a_trial_that_cannot_be_flown_costs_that_trial_only(toy, tmp_path):
    """Protects: one flight that crashes ends no search of hours; it is said, and a resumed one agrees."""

    class Crashing(Toy):
        def __call__(self, prepared, numbers):
            if prepared.setups[0].parameters.hover.kp[5] < 20.0:
                raise FlightError(numbers[0], "FloatingPointError: no number")
            return super().__call__(prepared, numbers)

    found, tuned = searched(tmp_path, toy, Crashing())
    failed = [t for t in found.trials if t.state.name == "FAIL"]
    assert failed and len(tuned.failed) == len(failed)
    assert "flight 0 could not be flown: FloatingPointError: no number" in tuned.failed[0]
    assert tuned.trials == 14
    assert searched(tmp_path, toy, Crashing(), True)[1] == tuned


def test_a_first_trial_that_cannot_be_flown_ends_the_search(toy, tmp_path):
    """Protects: without a beginning there is nothing to be better than."""

    def crash(prepared, numbers):
        raise FlightError(numbers[0], "boom")

    with pytest.raises(FlightError, match="flight 0 could not be flown: boom"):
        searched(tmp_path, toy, crash)
    assert searched(tmp_path, toy, Toy(), True)[1] == searched(tmp_path / "new", toy, Toy())[1]


def test_parameters_that_do_not_fit_each_other_are_never_flown(campaign, tmp_path):
    """Protects: what is found can be flown: bounds that overlap cost trials, not a file that is refused."""
    wild = """tune:
  trials: 12
  held_out: 2
  search:
    supervisor.range_rh_lower_m: {low: 0.1, high: 1.4}
    supervisor.range_rh_upper_m: {low: 0.6, high: 3}
"""
    flown = []

    class Fits(Toy):
        def __call__(self, prepared, numbers):
            flown.append(prepared.setups[0].parameters.supervisor)
            return super().__call__(prepared, numbers)

    _, tuned = searched(tmp_path, campaign(4, wild), Fits())
    assert all(s.range_rh_lower_m < s.range_rh_upper_m for s in flown)
    assert any("must be greater than range_rh_lower_m" in why for why in tuned.failed)


def test_a_search_begins_where_its_file_says(campaign, tmp_path):
    """Protects: once its gains ship, a search can still be done again from where it began."""
    declared = TUNE.replace("high: 100, log: true", "high: 100, log: true, start: 90")
    old, new = (
        campaign(10, declared + f"parameters: {{hover: {{kp: [1, 1, 1, 1, 1, {now}]}}}}\n")
        for now in (90, 31)
    )
    assert first(new)["hover.kp[5]"] == 90.0
    same = ("tune", "parameters")  # where it begins is the same; what is flown otherwise may differ
    assert all(journal.identity_of(old)[key] == journal.identity_of(new)[key] for key in same)
    assert (
        searched(tmp_path / "new", new, Toy())[1].values == searched(tmp_path / "old", old, Toy())[1].values
    )


def test_each_mission_keeps_what_is_not_searched(toy):
    """Protects: of a row, one number is searched; the others stay each mission's own."""
    setup = toy.setups[0]
    other = replace(setup, parameters=study_row(setup.parameters, [2, 2, 2, 2, 2, 2]))
    two = Prepared(toy.campaign, (setup, other))
    found = [s.parameters.hover.kp for s in applied(two, {"hover.kp[5]": 9.0}).setups]
    assert found == [(1, 1, 1, 1, 1, 9), (2, 2, 2, 2, 2, 9)]


def study_row(parameters, row):
    """The same with another row of hover gains."""
    return replace(parameters, hover=replace(parameters.hover, kp=tuple(row)))


def test_a_flight_that_crashes_is_told_by_its_number(campaign, monkeypatch):
    """Protects: a worker's error says which flight to look at, also when it comes from another process."""
    monkeypatch.setattr(flight, "fly_number", lambda *_: 1 / 0)
    with pytest.raises(FlightError, match="flight 3 could not be flown: ZeroDivisionError") as told:
        FlyNumbers(campaign(6))([3, 4])
    assert str(pickle.loads(pickle.dumps(told.value))) == str(told.value)


def test_numbers_never_known_are_null(toy, tmp_path):
    """Protects: tune.json is JSON also when no flight ever reached a mode."""
    _, tuned = searched(tmp_path, toy, Toy())
    lost = replace(tuned, after=replace(tuned.after, quality=Quality(float("nan"), 1.0, 1.0)))
    result.write(tmp_path, toy, lost)
    assert json.loads((tmp_path / "tune.json").read_text())["after"]["quality"]["tracking"] is None


def test_the_gain_is_told_flight_by_flight():
    """Protects: what is better on each flight is clearly better, though the flights differ widely."""
    one = Quality(1.0, 1.0, 1.0)

    def rows(figure):
        of = dict.fromkeys((*TRACKING, "largest_step", "energy_j"))
        return [{"outcome": "held" if k % 3 else "docked", **dict.fromkeys(of, figure)} for k in range(30)]

    low, high = score_gain(rows(1.0), rows(0.9), Weights(), one)
    assert 0.0 < low <= high < 0.1
    assert score_gain(rows(1.0), rows(1.0), Weights(), one) == (0.0, 0.0)


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
