"""Campaign files: what is refused, with its place."""

from pathlib import Path

import pytest

from bumpless.campaign.read import CampaignError, load_campaign, parse_campaign
from bumpless.config.mission import missions_folder

GOOD = """version: 1
name: good
missions: [docking]
count: 10
seed: 1
draw:
  current_speed_mps: {uniform: [0, 0.1]}
  current_relative_deg: {uniform: [0, 360]}
"""


def refused(text: str) -> list[str]:
    """Every problem of `text`, as people read it."""
    with pytest.raises(CampaignError) as caught:
        parse_campaign(text, "c.yaml")
    return [str(problem) for problem in caught.value.problems]


BAD = {
    "unknown field": ("seed: 1", "seeds: 1", "c.yaml:5:1: seeds = 1; unknown field; did you mean seed?"),
    "missing field": ("count: 10\n", "", "c.yaml:1:1: count; is missing: Flights"),
    "wrong type": ("count: 10", "count: many", "c.yaml:4:1: count = many; must be a number"),
    "out of range": ("count: 10", "count: 0", "c.yaml:4:1: count = 0; must be between 1 and 10000000"),
    "unknown mission": ("[docking]", "[dokking]", "c.yaml:3:12: missions[0] = dokking; no such file beside"),
    "unknown quantity": ("current_speed_mps", "curent_speed_mps", "did you mean current_speed_mps?"),
    "unknown distribution": (
        "{uniform: [0, 0.1]}",
        "{gauss: [0, 1]}",
        "must be a value, or a mapping of one of",
    ),
    "ends in wrong order": (
        "[0, 0.1]",
        "[0.1, 0]",
        "c.yaml:7:23: draw.current_speed_mps.uniform = [0.1, 0]; the first end must not lie above the second",
    ),
    "quantity out of its bounds": (
        "[0, 0.1]",
        "[0, 9]",
        "draw.current_speed_mps = 9.0; must be between 0 and 5 in m/s",
    ),
    "no number": (
        "[0, 0.1]",
        "[0, fast]",
        "draw.current_speed_mps.uniform[1] = fast; must be a number",
    ),
    "half a pair": (
        "  current_relative_deg: {uniform: [0, 360]}\n",
        "",
        "means nothing without current_relative_deg",
    ),
    "two currents": (
        "draw:\n",
        "draw:\n  current_along_mps: 0.1\n",
        "cannot be drawn beside current_speed_mps",
    ),
    "no mission": ("draw:\n", "draw:\n  start_down_m: {uniform: [-5, 0]}\n", "makes no mission of docking"),
    "half a fault": ("draw:\n", "draw:\n  fault_at_s: 9\n", "a mission without a fault needs all of"),
    "no actuator": (
        "draw:\n",
        "draw:\n  fault_actuator: sail\n  fault_at_s: 9\n  fault_effectiveness: 0.5\n",
        "faults[0].actuator unknown actuator",
    ),
    "unknown vehicle": ("seed: 1", "seed: 1\nvehicle: ts1000", "c.yaml:6:1: vehicle = ts1000;"),
    "wrong parameter": ("seed: 1", "seed: 1\nparameters: {hover: {lamda: 1}}", "parameters.hover.lamda"),
    "parameter out of range": (
        "seed: 1",
        "seed: 1\nparameters: {hover: {lambda: -1}}",
        "parameters.hover.lambda",
    ),
    "no parameter file": (
        "seed: 1",
        "seed: 1\nparameters_file: no.toml",
        "parameters_file = no.toml; cannot be read",
    ),
    "unknown search": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.kz: {low: 1, high: 2}}}",
        "hover.kz: no such parameter",
    ),
    "search beyond range": (
        "seed: 1",
        'seed: 1\ntune: {trials: 2, held_out: 2, search: {"hover.kp[5]": {low: 1, high: 2e9}}}',
        "hover.kp[5] must be",
    ),
    "search upside down": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.lambda: {low: 2, high: 1}}}",
        "must have low < high",
    ),
    "search of a word": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {allocation.allocator: {low: 1, high: 2}}}",
        "allocation.allocator must be one of",
    ),
    "search of a switch": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {bumpless.ramp: {low: 0, high: 1}}}",
        "bumpless.ramp must be true or false",
    ),
    "search of a whole row": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.kp: {low: 1, high: 2}}}",
        "hover.kp must be a list",
    ),
    "search with a slip": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.lamda: {low: 1, high: 2}}}",
        "no such parameter; did you mean hover.lambda?",
    ),
    "search between whole numbers": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.ramp_cycles: {low: 10.5, high: 90}}}",
        "must have whole numbers",
    ),
    "search by factors from none": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {hover.ramp_cycles: {low: 0, high: 90, log: true}}}",
        "must have 0 < low < high",
    ),
    "search that leaves out where it begins": (
        "seed: 1",
        'seed: 1\ntune: {trials: 2, held_out: 2, search: {"hover.kp[5]": {low: 1, high: 2}}}',
        "must be between low and high, 1 and 2, where the search begins",
    ),
    "start beyond its bounds": (
        "seed: 1",
        'seed: 1\ntune: {trials: 2, held_out: 2, search: {"hover.kp[5]": {low: 1, high: 2, start: 3}}}',
        "must be between low and high, 1 and 2, where the search begins",
    ),
    "start that fits nothing": (
        "seed: 1",
        "seed: 1\ntune: {trials: 2, held_out: 2, search: {supervisor.range_rh_lower_m: {low: 0.1, high: 1.4,"
        " start: 1.2}, supervisor.range_rh_upper_m: {low: 0.6, high: 3, start: 1.1}}}",
        "begins where supervisor.range_rh_upper_m must be greater",
    ),
    "no trials": (
        "seed: 1",
        "seed: 1\ntune: {trials: 0, held_out: 2, search: {hover.lambda: {low: 0.001, high: 1}}}",
        "tune.trials",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_what_is_wrong_is_said_with_its_place(case):
    """Protects: a mistake costs a look at the line named, not a campaign flown in vain."""
    before, after, said = BAD[case]
    assert before in GOOD
    problems = refused(GOOD.replace(before, after))
    assert any(said in problem for problem in problems), problems
    assert all(problem.startswith("c.yaml:") for problem in problems)


def test_every_problem_is_told_at_once():
    """Protects: two mistakes are two lines, not two attempts."""
    text = GOOD.replace("[0, 0.1]", "[0, 9]").replace("[0, 360]", "[0, 999]")
    assert len(refused(text)) == 2


def test_a_mission_may_stand_in_the_campaign():
    """Protects: a mission written out in the campaign flies; its problems are told at their place there."""
    mission = """
  - version: 1
    name: here
    vehicle: ts100
    duration_s: 30
    start: {position_ned_m: [0, 0, 2], heading_deg: 0}
    legs:
      - {to_ned_m: [20, 0, 2], speed_mps: 0.5}
    target: {position_ned_m: [26, 0, 2], heading_deg: 0, standoff_m: 1.5}
"""
    text = GOOD.replace(" [docking]", mission.rstrip())
    assert parse_campaign(text).setups[0].mission.name == "here"
    problems = refused(text.replace("speed_mps: 0.5", "speed_mps: 50"))
    assert problems[0].startswith("c.yaml:10:") and "missions[0].legs[0].speed_mps = 50" in problems[0]


def test_a_parameter_file_lies_under_the_campaigns_own(tmp_path: Path):
    """Protects: what `bumpless tune` wrote can be flown, and still be changed for a trial."""
    (tmp_path / "t.toml").write_text("[hover]\nlambda = 0.5\nramp_cycles = 50\n")
    text = GOOD + "parameters_file: t.toml\nparameters: {hover: {lambda: 0.25}}\n"
    hover = parse_campaign(text, folder=tmp_path).setups[0].parameters.hover
    assert (hover.lambda_, hover.ramp_cycles) == (0.25, 50)


@pytest.mark.parametrize(
    "path", sorted((missions_folder() / "campaigns").glob("*.yaml")), ids=lambda p: p.stem
)
def test_shipped_campaigns_are_good(path):
    """Protects: the campaigns that ship can be flown, and each is named as its file."""
    assert load_campaign(path).campaign.name == path.stem


def test_a_changed_comment_is_no_change_and_a_number_is():
    """Protects: the identity that guards a folder of results is that of what is flown."""
    one, other = parse_campaign(GOOD), parse_campaign("# a remark\n" + GOOD)
    assert one.identity() == other.identity()
    for change in (
        ("0.1]", "0.2]"),
        ("seed: 1", "seed: 2"),
        ("seed: 1", "seed: 1\nparameters: {hover: {lambda: 0.3}}"),
    ):
        assert parse_campaign(GOOD.replace(*change)).identity() != one.identity()
