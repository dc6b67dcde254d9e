"""Allocator by ramp, each with its own best gains, and the flights that the table of outcomes counts."""

import dataclasses
import json

import pytest

from bumpless.campaign.tune import journal
from bumpless.config.parameters import as_dict
from bumpless_paper.study import fair
from bumpless_paper.study.docks import response
from bumpless_paper.study.outcomes import GROUPS, HELD_OUT, RESPONSES, measure

DECLARED = ("campaign", "tune")  # of a search's identity: what its files say


def test_rows_differ_in_allocator_and_ramp_alone() -> None:
    """Protects: a fair comparison: before their search all rows fly the vehicle as it ships."""
    ours = as_dict(fair.campaign().setups[0].parameters)
    for name in fair.ROWS:
        theirs = as_dict(fair.prepared_for(name).setups[0].parameters)
        assert {section for section in ours if ours[section] != theirs[section]} <= {"allocation", "bumpless"}
    shipped = as_dict(fair.prepared_for("mdca_ramp").setups[0].parameters)
    assert shipped == ours


def test_the_papers_scenarios_had_the_same_search() -> None:
    """Protects: nobody compares a tuned method with one that is not: each row's search was of the same file,
    from the same beginning, with as many trials and flights."""
    tune = fair.campaign().campaign.tune
    assert tune is not None and set(fair.found()) == set(fair.SEARCHED)
    for name, row in fair.found().items():
        now = journal.identity_of(fair.prepared_for(name))
        assert {key: row["identity"][key] for key in DECLARED} == {key: now[key] for key in DECLARED}
        assert (row["trials"], row["seed"]) == (tune.trials, fair.campaign().campaign.seed)
        assert row["values"].keys() == row["present"].keys() == tune.search.keys()
        assert all(
            tune.search[path].low <= value <= tune.search[path].high for path, value in row["values"].items()
        )
        assert 0 <= row["trial"] < tune.trials and row["after"]["docked"]["total"] == tune.held_out


def test_rows_fly_their_own_gains_on_unseen_flights() -> None:
    """Protects: the table's flights are no search's, and each row flies what its own search found."""
    for name in fair.ROWS:
        tuned = fair._tuned(name)
        shipped = fair.prepared_for(name).setups[0].parameters.hover.kp[5]
        assert tuned.campaign.seed == HELD_OUT != fair.campaign().campaign.seed
        wanted = fair.gains(name)["hover.kp[5]"] if name in fair.SEARCHED else shipped
        assert tuned.setups[0].parameters.hover.kp[5] == wanted


def test_gains_are_flown_that_held_out_flights_find_clearly_better(monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: no row is handicapped by a search that was lucky on its own flights; one rule for all."""
    row = {"values": {"hover.kp[5]": 9.0}, "present": {"hover.kp[5]": 60.0}}
    rows = {"wls": row | {"verdict": "clearly better"}, "hard": row | {"verdict": "not clearly better"}}
    monkeypatch.setattr(fair, "found", lambda: rows)
    assert [fair.gains(name) for name in ("wls", "hard", "pid")] == [row["values"], row["present"], {}]


def test_a_row_of_the_table_adds_up() -> None:
    """Protects: endings count every flight, and the same flights give the same row."""
    one, other = (fair.judge(2, names=("mdca_ramp",)) for _ in range(2))
    assert one == other
    row = one["rows"]["mdca_ramp"]
    assert sum(row["endings"].values()) == 2
    assert json.loads(json.dumps(row["median"]))["energy_j"] > 0.0


@pytest.fixture(scope="module")
def measured() -> dict:
    """The whole measure at its smallest."""
    return measure(0.0)


def test_every_group_is_flown_and_counted(measured: dict) -> None:
    """Protects: no kind of flight is left out, and each has an ending and a reason."""
    assert measured["first"] == HELD_OUT >= 6_000_000
    for name in GROUPS:
        group = measured["groups"][name]
        assert sum(group["endings"].values()) == sum(group["why"].values()) == group["flights"] == 2
    said = measured["responses"]
    assert {"depth_step", "heading_step", "start_dip_mps", "stay", "light", "heavy", "shifted"} == said.keys()
    assert set(RESPONSES) >= {"stay"}
    json.dumps(measured, allow_nan=False)


def test_a_step_is_measured_from_where_it_was() -> None:
    """Protects: settled within 5 % for good and the overshoot, of a step whose answer is known."""
    ramp = [min(1.2, 0.01 * k) if k < 200 else 1.0 for k in range(800)]
    found = response._step(0.5 * response.np.array(ramp))
    assert dataclasses.asdict(found) == pytest.approx({"settled_s": 10.4, "overshoot": 0.2}, abs=0.15)
